#include "osem/fit.hpp"

#include "tree/run_to_end.hpp"

namespace osem {

Status Fitting::begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                      std::uint32_t scratch_size, NodePool& pool) {
    running_ = false;
    visited_ = 0;
    const Status status = conversion_.begin(solid, options, scratch, scratch_size, nullptr);
    if (status != Status::ok) return status;
    solid_ = solid;
    options_ = options;
    scratch_ = scratch;
    pool_ = &pool;
    writing_ = false;
    running_ = true;
    return Status::ok;
}

bool Fitting::step(std::uint32_t octants) {
    for (; octants > 0 && running_; --octants) {
        const bool more = conversion_.step(1);
        const bool fits = conversion_.nodes_counted() <= pool_->capacity() - pool_->used();
        if (writing_) {
            running_ = more;
        } else if (!more || !fits) {
            next_pass(fits);
        }
    }
    return running_;
}

// Nothing of a counting pass that was given up remains: it never wrote.
void Fitting::next_pass(bool fits) {
    visited_ += conversion_.octants_visited();
    writing_ = fits;
    if (!fits) --options_.depth; // never below 1: that depth takes no node
    // Accepted at the first begin, and a lower depth is as good.
    static_cast<void>(conversion_.begin(solid_, options_, scratch_, convert_scratch(solid_.view()),
                                        writing_ ? pool_ : nullptr));
}

FitOutcome Fitting::finish() {
    const bool whole = writing_ && !running_;
    FitOutcome outcome = {conversion_.finish(), visited_ + conversion_.octants_visited()};
    if (!whole) outcome.built.status = Status::unfinished;
    running_ = false;
    writing_ = whole; // asked again, the answer is the same
    return outcome;
}

FitOutcome fit(Fitting& job, const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
               std::uint32_t scratch_size, NodePool& pool) {
    const Status status = job.begin(solid, options, scratch, scratch_size, pool);
    if (status != Status::ok) {
        return {{status, 0, 0, Octree{&pool, Node::uniform(Colour::white), 1}}, 0};
    }
    run_to_end(job);
    return job.finish();
}

} // namespace osem
