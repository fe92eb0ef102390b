// osem coarsen: an octree file to one of at most so many nodes, or of at most some depth.
#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "osem/fit.hpp"
#include "osem/transform.hpp"

namespace osem::host {

namespace {

struct CoarsenArguments {
    std::string input;
    std::string output;
    std::optional<std::uint32_t> nodes;
    std::optional<int> depth;
    std::optional<Coarse> mode;
};

void require_one(const CoarsenArguments& options) {
    if (options.nodes.has_value() == options.depth.has_value()) {
        throw CLI::ValidationError("coarsen", "wants either --nodes or --depth");
    }
    if (options.mode && !options.depth) throw CLI::ValidationError("--mode", "is for --depth");
}

void save(const CoarsenArguments& options, const TreeFile& file, const Octree& tree, const Console& console) {
    OutputFile output(options.output);
    write_tree(output, tree, file.facts());
    finish_printing(console);
    output.commit();
}

void coarsen_to_nodes(const CoarsenArguments& options, const Console& console) {
    TreeFile file(options.input);
    HostPool operand(file.nodes());
    const Octree tree = file.read(operand.pool());

    HostPool pool(std::min(*options.nodes, file.nodes()));
    const auto job = std::make_unique<Pruning>();
    const PruneOutcome outcome = prune(*job, tree, *options.nodes, &pool.pool());
    if (outcome.built.status != Status::ok) throw BadInput(describe(outcome.built.status));

    console.out << "nodes " << outcome.built.nodes_needed << '\n'
                << "inner_lost " << outcome.inner_lost << '\n'
                << "outer_gained " << outcome.outer_gained << '\n'
                << "above_optimum " << outcome.above_optimum << '\n';
    save(options, file, outcome.built.tree, console);
}

// The result stands in the operand's pool and takes at most as many nodes once more.
void coarsen_to_depth(const CoarsenArguments& options, const Console& console) {
    TreeFile file(options.input);
    HostPool pool(std::uint64_t{file.nodes()} * 2);
    const Octree tree = file.read(pool.pool());
    const auto job = std::make_unique<Coarsening>();
    const TreeOutcome outcome =
        coarsen(*job, tree, *options.depth, options.mode.value_or(Coarse::certified), pool.pool());
    if (outcome.status != Status::ok) throw BadInput(describe(outcome.status));

    const Measures measures = measure(outcome.tree);
    console.out << "nodes " << measures.nodes - 1 << '\n'
                << "inner_volume " << measures.inner_volume << '\n'
                << "outer_volume " << measures.outer_volume << '\n';
    save(options, file, outcome.tree, console);
}

void run_coarsen(const CoarsenArguments& options, const Console& console) {
    require_one(options);
    OutputFile::probe(options.output);
    if (options.nodes) {
        coarsen_to_nodes(options, console);
    } else {
        coarsen_to_depth(options, console);
    }
}

constexpr const char* coarsen_footer =
    "With --nodes, or --depth in the mode `certified`, what is black in the result is black in X "
    "throughout,\n"
    "what is white is white: the rest is boundary. At a depth the other modes make octants of several\n"
    "colours white (inner), black (outer) or what fills more of them (majority), boundary leaves likewise,\n"
    "one counting as half full. --depth prints nodes, inner_volume and outer_volume. --nodes prints one "
    "\"key value\" line each: nodes (all but the top one); inner_lost and outer_gained, the\n"
    "cells that were black or white and are boundary, 2^60 of which fill the root; above_optimum, by how\n"
    "much at most their sum is above the least that any tree of so few nodes could lose.\n"
    "The leaf rule that `osem info` prints stays that of X.";

} // namespace

void add_coarsen(CLI::App& app, const Console& console) {
    CLI::App* command =
        app.add_subcommand("coarsen", "Coarsen an octree to a depth, or prune it to a budget of nodes");
    const auto options = std::make_shared<CoarsenArguments>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    command
        ->add_option("--nodes", options->nodes, "Prune: nodes that the result may have beside its top node")
        ->type_name("N");
    command->add_option("--depth", options->depth, "Greatest depth of the result")
        ->check(CLI::Range(1, max_depth).description(""))
        ->type_name("D");
    add_choice<Coarse>(*command, "--mode", options->mode,
                       "For --depth, what becomes of mixed octants: inner, outer, majority or certified,\n"
                       "the default",
                       {{"inner", Coarse::inner},
                        {"outer", Coarse::outer},
                        {"majority", Coarse::majority},
                        {"certified", Coarse::certified}})
        ->type_name("MODE");
    add_tree_output(*command, "-o,--output", options->output, "Octree file to write; may be the one read")
        ->required()
        ->type_name("Y.osem");
    command->footer(coarsen_footer);
    command->callback([options, &console] { run_coarsen(*options, console); });
}

} // namespace osem::host
