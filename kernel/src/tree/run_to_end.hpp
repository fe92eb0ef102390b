// For the functions that do a whole job at once.
#ifndef OSEM_TREE_RUN_TO_END_HPP
#define OSEM_TREE_RUN_TO_END_HPP

#include <cstdint>

namespace osem {

template <class Job>
void run_to_end(Job& job) {
    while (job.step(UINT32_MAX)) {
    }
}

} // namespace osem

#endif
