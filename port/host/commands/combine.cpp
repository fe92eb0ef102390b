// osem union, intersection, difference, xor and complement: octree files to an octree file.
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "console/progress.hpp"
#include "files/decimal.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "osem/stream_boolean.hpp"

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

// From file to file: no tree is ever in memory. `begin` starts the job with a sink.
template <class Begin>
void run(const std::string& output, const Console& console, TreeFile& a, TreeFile& b, const Begin& begin) {
    OutputFile file(output);
    StreamCombination job;
    begin(job, sink_of(file)); // what it refuses, finish refuses too
    {
        Progress progress(console, "combining");
        drive(job, progress, 0, 1);
    }
    const StreamCombinationOutcome outcome = job.finish();
    if (outcome.status == Status::stream_count_mismatch && outcome.offset == 0) {
        throw BadInput(output + ": the result has too many nodes for a file");
    }
    if (outcome.status != Status::ok && outcome.status != Status::sink_refused) {
        (outcome.operand == 0 ? a : b).refuse(outcome.status, outcome.offset);
    }
    file.commit(); // reports a write that was not taken
}

void run_combination(Operator op, const Operands& files, const Console& console) {
    OutputFile::probe(files.output);
    TreeFile a(files.a);
    TreeFile b(files.b);
    require_same_frame(a, b);
    require_same_leaves(a, b);
    run(files.output, console, a, b, [&](StreamCombination& job, const Sink& sink) {
        static_cast<void>(job.begin(op, a.source(), b.source(), sink));
    });
}

void run_complement(const Operands& files, const Console& console) {
    OutputFile::probe(files.output);
    TreeFile a(files.a);
    run(files.output, console, a, a, [&](StreamCombination& job, const Sink& sink) {
        static_cast<void>(job.begin_complement(a.source(), sink));
    });
}

void add_result(CLI::App& command, Operands& operands) {
    add_tree_output(command, "-o,--output", operands.output, "Octree file to write; may be one of those read")
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

void add_complement(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("complement", "What the root cube holds outside A");
    const auto operands = std::make_shared<Operands>();
    command->add_option("A", operands->a, "Octree file")->required()->type_name("");
    add_result(*command, *operands);
    command->callback([operands, &console] { run_complement(*operands, console); });
}

} // namespace osem::host
