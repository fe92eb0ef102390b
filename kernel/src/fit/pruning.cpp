#include "osem/fit.hpp"
#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

// Below the root an octant holds at most 2^57 cells: at this price none is kept.
constexpr std::uint64_t highest_price = volume_at(1);

// What is left of a cost once `units` at a price are taken off; 0 when they come to more.
std::uint64_t cost_less(std::uint64_t cost, std::uint64_t price, std::uint32_t units) {
    const std::uint64_t taken_off = price * units;
    return taken_off > cost ? 0 : cost - taken_off;
}

bool has_known_leaf(const Node& node) { return (blacks(node) | whites(node)) != 0; }

} // namespace

void Pruning::begin(const Octree& tree, std::uint32_t budget, NodePool* pool) {
    builder_.begin(pool);
    tree_ = tree;
    budget_ = budget;
    visited_ = 0;
    too_low_ = 0;
    enough_ = highest_price;
    price_ = 0;
    least_loss_ = 0;
    inner_lost_ = 0;
    outer_gained_ = 0;
    room_ = 0;
    phase_ = Phase::bisecting;
    appraisal_.begin(tree_.pool, tree_.top, 0, price_);
}

bool Pruning::step(std::uint32_t nodes) {
    for (; nodes > 0 && builder_.building(); --nodes) {
        ++visited_;
        if (phase_ == Phase::writing) {
            write();
        } else if (!appraisal_.step()) {
            appraised();
        }
    }
    return builder_.building();
}

// The whole tree has been appraised at a price. The top node is always kept, for nothing.
void Pruning::appraised() {
    const std::uint64_t kept = appraisal_.kept_below();
    if (phase_ == Phase::bisecting) {
        choose_price(kept);
        return;
    }
    room_ = budget_ - kept;
    // At a price lower by one, more than the budget would be kept, each node for that price, and no more than
    // the root's volume is there to be paid with: so the budget at this price comes to less than 2^60 + 2^32.
    least_loss_ = cost_less(appraisal_.cost_below(), price_, budget_);
    start_writing();
}

// The price just looked at becomes an end of the interval.
void Pruning::choose_price(std::uint64_t kept) {
    const bool fits = kept <= budget_;
    if (fits && price_ == 0) {
        start_writing();
        return;
    }
    (fits ? enough_ : too_low_) = price_;
    const bool found = enough_ - too_low_ == 1;
    if (found) phase_ = Phase::settling;
    price_ = found ? enough_ : too_low_ + (enough_ - too_low_) / 2;
    appraisal_.begin(tree_.pool, tree_.top, 0, price_);
}

void Pruning::start_writing() {
    phase_ = Phase::writing;
    asking_ = false;
    level_ = -1;
    enter(tree_.top, Rule::paid);
}

// Takes the leaves of a node over; the grey children are decided one after the other.
void Pruning::enter(const Node& node, Rule rule) {
    const std::uint8_t grey = node.grey();
    builder_.leaves(node.may, static_cast<std::uint8_t>(node.must & ~grey));
    frames_[++level_] = Frame{node, grey, rule};
}

// Does one thing: goes on with an appraisal, asks for the next one, or closes an octant.
void Pruning::write() {
    if (asking_) {
        if (!appraisal_.step()) decide();
    } else if (frames_[level_].left != 0) {
        ask(frames_[level_].rule == Rule::loose || frames_[level_].rule == Rule::all_cheap);
    } else {
        builder_.close();
        --level_;
    }
}

void Pruning::ask(bool cheap) {
    asking_ = true;
    cheap_ = cheap;
    appraisal_.begin(tree_.pool, child(), level_ + 1, price_ - (cheap ? 1 : 0));
}

// The next child has been appraised.
void Pruning::decide() {
    asking_ = false;
    const Rule rule = frames_[level_].rule;
    const bool as_favour = rule == Rule::loose || (rule == Rule::paid && cheap_);
    const std::uint64_t kept = appraisal_.kept();
    if (as_favour) {
        decide_favour(kept);
    } else if (kept != 0) {
        keep(rule);
    } else if (rule == Rule::paid && room_ != 0) {
        ask(true);
    } else {
        give_up();
    }
}

// Keeps a child that nothing has been set aside for, as a whole where there is room, else in part: its node
// is worth its place when some of its leaves are known. (A node without any would fold into a boundary leaf
// if nothing below it could be kept.) The price itself keeps nothing below a node kept in part: a leaf of
// that node is known and not worth the price, and no octant below holds more cells than that leaf.
void Pruning::decide_favour(std::uint64_t kept) {
    if (kept != 0 && take_room(kept)) {
        keep(Rule::all_cheap);
    } else if (kept != 0 && has_known_leaf(child()) && take_room(1)) {
        keep(Rule::loose);
    } else {
        give_up();
    }
}

bool Pruning::take_room(std::uint64_t nodes) {
    if (nodes > room_) return false;
    room_ -= nodes;
    return true;
}

const Node& Pruning::child() const {
    const Frame& frame = frames_[level_];
    return tree_.pool->child(frame.node, lowest(frame.left));
}

void Pruning::keep(Rule rule) {
    const Node& node = child();
    Frame& frame = frames_[level_];
    builder_.open(lowest(frame.left));
    frame.left = without_lowest(frame.left);
    enter(node, rule);
}

void Pruning::give_up() {
    Frame& frame = frames_[level_];
    builder_.leaf(lowest(frame.left), Colour::boundary);
    frame.left = without_lowest(frame.left);
    inner_lost_ += appraisal_.black();
    outer_gained_ += appraisal_.known() - appraisal_.black();
}

PruneOutcome Pruning::finish() {
    const bool whole = builder_.finished();
    const std::uint64_t above = whole ? inner_lost_ + outer_gained_ - least_loss_ : 0;
    return {builder_.finish(tree_.depth), inner_lost_, outer_gained_, above};
}

PruneOutcome prune(Pruning& job, const Octree& tree, std::uint32_t budget, NodePool* pool) {
    job.begin(tree, budget, pool);
    run_to_end(job);
    return job.finish();
}

} // namespace osem
