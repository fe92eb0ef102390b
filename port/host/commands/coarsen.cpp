// osem coarsen: an octree file to one of at most so many nodes.
#include <algorithm>
#include <memory>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "osem/fit.hpp"

namespace osem::host {

namespace {

struct Options {
    std::string input;
    std::string output;
    std::uint32_t nodes = 0;
};

void run_coarsen(const Options& options, std::ostream& out) {
    OutputFile::probe(options.output);
    TreeFile file(options.input);
    HostPool operand(file.nodes());
    const Octree tree = file.read(operand.pool());

    HostPool pool(std::min(options.nodes, file.nodes()));
    const auto job = std::make_unique<Pruning>();
    const PruneOutcome outcome = prune(*job, tree, options.nodes, &pool.pool());
    if (outcome.built.status != Status::ok) throw BadInput(describe(outcome.built.status));

    OutputFile output(options.output);
    write_tree(output, outcome.built.tree, file.facts());
    output.commit();
    out << "nodes " << outcome.built.nodes_needed << '\n'
        << "inner_lost " << outcome.inner_lost << '\n'
        << "outer_gained " << outcome.outer_gained << '\n'
        << "above_optimum " << outcome.above_optimum << '\n';
}

constexpr const char* footer =
    "What is black in the result is black in X throughout, what is white is white: the rest is boundary.\n"
    "Prints one \"key value\" line each: nodes (all but the top one); inner_lost and outer_gained, the\n"
    "cells that were black or white and are boundary, 2^60 of which fill the root; above_optimum, by how\n"
    "much at most their sum is above the least that any tree of so few nodes could lose.";

} // namespace

void add_coarsen(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("coarsen", "Coarsen an octree to a budget of nodes");
    const auto options = std::make_shared<Options>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    command->add_option("--nodes", options->nodes, "Nodes that the result may have beside its top node")
        ->required()
        ->type_name("N");
    add_output(*command, "-o,--output", options->output, "Octree file to write; may be the one read")
        ->required()
        ->type_name("Y.osem");
    command->footer(footer);
    command->callback([options, &console] { run_coarsen(*options, console.out); });
}

} // namespace osem::host
