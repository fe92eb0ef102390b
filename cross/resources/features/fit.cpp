// The finest conversion that fits, and pruning to a node budget.
#include "features/roots.hpp"

#include "osem/fit.hpp"

extern "C" {
auto fit_roots = roots_of(&osem::Fitting::begin, &osem::Fitting::step, &osem::Fitting::finish,
                          &osem::Pruning::begin, &osem::Pruning::step, &osem::Pruning::finish);
}
