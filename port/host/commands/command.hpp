// What the commands have in common. Each registers itself with the option parser and runs when the parser
// has accepted the whole line.
#ifndef OSEM_HOST_COMMAND_HPP
#define OSEM_HOST_COMMAND_HPP

#include "console/console.hpp"

namespace CLI {
class App;
}

namespace osem::host {

void add_check(CLI::App& app, const Console& console);
void add_convert(CLI::App& app, const Console& console);
void add_combinations(CLI::App& app, const Console& console); ///< union, intersection, difference, xor
void add_complement(CLI::App& app, const Console& console);
void add_coarsen(CLI::App& app, const Console& console);
void add_csg(CLI::App& app, const Console& console);
void add_info(CLI::App& app, const Console& console);
void add_measure(CLI::App& app, const Console& console); ///< measure, components
void add_query(CLI::App& app, const Console& console);
void add_collide(CLI::App& app, const Console& console);
void add_leaves(CLI::App& app, const Console& console);
void add_image(CLI::App& app, const Console& console);
void add_slice(CLI::App& app, const Console& console);
void add_mesh(CLI::App& app, const Console& console);
void add_transform(CLI::App& app, const Console& console);
void add_carray(CLI::App& app, const Console& console);

} // namespace osem::host

#endif
