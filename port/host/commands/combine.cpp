// osem union, intersection, difference, xor and complement: octree files to an octree file.
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "console/progress.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "osem/boolean.hpp"

namespace osem::host {

namespace {

struct Operands {
    std::string a;
    std::string b;
    std::string output;
};

void require_same_frame(const TreeFile& a, const TreeFile& b) {
    if (same_cube(a.facts().cube, b.facts().cube)) return;
    throw BadInput("the frames differ: " + a.path() + " covers " + frame_text(a.facts().cube) + ", " +
                   b.path() + " covers " + frame_text(b.facts().cube) +
                   "; convert both with the same --frame");
}

// A black or white leaf is a promise about all of itself under one rule, about its centre under the other; a
// result of both would promise nothing.
void require_same_leaves(const TreeFile& a, const TreeFile& b) {
    if (a.facts().leaves == b.facts().leaves) return;
    throw BadInput("the leaf rules differ: " + a.path() + " has " + leaf_rule_name(a.facts().leaves) +
                   " leaves, " + b.path() + " has " + leaf_rule_name(b.facts().leaves) +
                   " leaves; convert both with the same --leaves");
}

TreeOutcome run_pass(Combination& job, Operator op, const Octree& a, const Octree& b, NodePool& pool,
                     bool count_only, Progress& progress) {
    const Status begun = job.begin(op, a, b, pool, count_only);
    if (begun != Status::ok) throw BadInput(describe(begun));
    drive(job, progress, count_only ? 0 : 1, 2);
    const TreeOutcome outcome = job.finish();
    if (outcome.status != Status::ok) throw BadInput(describe(outcome.status));
    return outcome;
}

void run_combination(Operator op, const Operands& files, const Console& console) {
    OutputFile::probe(files.output);
    TreeFile file_a(files.a);
    TreeFile file_b(files.b);
    require_same_frame(file_a, file_b);
    require_same_leaves(file_a, file_b);
    auto operands = std::make_unique<HostPool>(std::uint64_t{file_a.nodes()} + file_b.nodes());
    const Octree a = file_a.read(operands->pool());
    const Octree b = file_b.read(operands->pool());

    Progress progress(console, "combining");
    const auto job = std::make_unique<Combination>();
    const TreeOutcome counted = run_pass(*job, op, a, b, operands->pool(), true, progress);
    HostPool all(*operands, std::uint64_t{operands->pool().used()} + counted.nodes_needed);
    operands.reset();
    const TreeOutcome result =
        run_pass(*job, op, all.adopted(a), all.adopted(b), all.pool(), false, progress);

    OutputFile output(files.output);
    write_tree(output, result.tree, file_a.facts());
    output.commit();
}

void run_complement(const Operands& files) {
    OutputFile::probe(files.output);
    TreeFile file(files.a);
    HostPool pool(2 * std::uint64_t{file.nodes()}); // the complement has a node for each node of the operand
    const Octree tree = file.read(pool.pool());
    const auto job = std::make_unique<Combination>();
    const TreeOutcome result = complement(*job, tree, pool.pool());
    if (result.status != Status::ok) throw BadInput(describe(result.status));

    OutputFile output(files.output);
    write_tree(output, result.tree, file.facts());
    output.commit();
}

void add_result(CLI::App& command, Operands& operands) {
    add_output(command, "-o,--output", operands.output, "Octree file to write; may be one of those read")
        ->required()
        ->type_name("C.osem");
}

void add_combination(CLI::App& app, const Console& console, const char* name, const char* help, Operator op) {
    CLI::App* command = app.add_subcommand(name, help);
    const auto operands = std::make_shared<Operands>();
    command->add_option("A", operands->a, "Octree file")->required()->type_name("");
    command->add_option("B", operands->b, "Octree file with the same frame and leaf rule")
        ->required()
        ->type_name("");
    add_result(*command, *operands);
    command->callback([operands, op, &console] { run_combination(op, *operands, console); });
}

} // namespace

void add_combinations(CLI::App& app, const Console& console) {
    add_combination(app, console, "union", "What lies in A or B", Operator::unite);
    add_combination(app, console, "intersection", "What lies in both A and B", Operator::intersect);
    add_combination(app, console, "difference", "What lies in A but not in B", Operator::subtract);
    add_combination(app, console, "xor", "What lies in exactly one of A and B", Operator::exclusive_or);
}

void add_complement(CLI::App& app, const Console&) {
    CLI::App* command = app.add_subcommand("complement", "What the root cube holds outside A");
    const auto operands = std::make_shared<Operands>();
    command->add_option("A", operands->a, "Octree file")->required()->type_name("");
    add_result(*command, *operands);
    command->callback([operands] { run_complement(*operands); });
}

} // namespace osem::host
