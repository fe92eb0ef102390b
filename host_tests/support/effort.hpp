// How far a job is driven: in steps of what size, and how many of them.
#ifndef OSEM_SUPPORT_EFFORT_HPP
#define OSEM_SUPPORT_EFFORT_HPP

#include <cstdint>

namespace osem::tests {

constexpr std::uint32_t step_budgets[] = {1, 2, 3, 7, 1000, UINT32_MAX};
constexpr std::size_t step_budget_count = sizeof step_budgets / sizeof *step_budgets;

struct Effort {
    std::uint32_t budget = UINT32_MAX; ///< of one step
    std::uint64_t steps = UINT64_MAX;  ///< after so many the job is given up
};

template <class Job>
void drive(Job& job, const Effort& effort) {
    for (std::uint64_t i = 0; i < effort.steps && job.step(effort.budget); ++i) {
    }
}

} // namespace osem::tests

#endif
