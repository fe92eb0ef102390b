// osem convert: a mesh file to an octree file.
#include <chrono>
#include <iomanip>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "commands/solid_input.hpp"
#include "console/progress.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "mesh/quantize.hpp"
#include "mesh/write_off.hpp"
#include "osem/convert.hpp"

namespace osem::host {

namespace {

struct Options {
    std::string input;
    std::string output;
    std::string quantized;
    SolidOptions solid;
    ConvertOptions conversion; ///< but for the winding rule
    bool stats = false;
};

struct Converted {
    std::unique_ptr<HostPool> pool;
    TreeOutcome outcome;
    double seconds; ///< of the pass that wrote the tree
};

TreeOutcome run_pass(Conversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                     std::vector<std::uint32_t>& faces, NodePool* pool, Progress& progress) {
    const Status begun =
        job.begin(solid, options, faces.data(), static_cast<std::uint32_t>(faces.size()), pool);
    if (begun != Status::ok) throw BadInput(describe(begun));
    drive(job, progress, pool == nullptr ? 0 : 1, 2);
    return job.finish();
}

// Twice: the first pass only counts the nodes, so that the second has exactly the memory it needs.
Converted convert_twice(Conversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                        Progress& progress) {
    std::vector<std::uint32_t> faces(convert_scratch(solid.view()));
    const TreeOutcome counted = run_pass(job, solid, options, faces, nullptr, progress);
    Converted result = {std::make_unique<HostPool>(counted.nodes_needed), counted, 0.0};

    const auto start = std::chrono::steady_clock::now();
    result.outcome = run_pass(job, solid, options, faces, &result.pool->pool(), progress);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (result.outcome.status != Status::ok) throw BadInput(describe(result.outcome.status));
    return result;
}

void print_stats(std::ostream& out, const Conversion& job, const Converted& converted) {
    static const char* const names[stage_count] = {"minimax", "plane", "vertices", "section", "holes"};
    const StageCounts& stages = job.stages();
    out << "stage             rejected         accepted\n";
    for (int i = 0; i < stage_count; ++i) {
        out << std::left << std::setw(9) << names[i] << std::right << std::setw(17) << stages.rejected[i]
            << std::setw(17) << stages.accepted[i] << '\n';
    }
    const auto octants = job.octants_visited();
    out << "octants " << octants << '\n'
        << "nodes " << measure(converted.outcome.tree).nodes << '\n'
        << "ns_per_octant "
        << static_cast<std::uint64_t>(1e9 * converted.seconds / static_cast<double>(octants)) << '\n';
}

void run_convert(const Options& options, const Console& console) {
    if (options.conversion.leaves == LeafRule::centre && options.conversion.depth == max_depth) {
        throw CLI::ValidationError("--depth", "centre leaves end at depth 19");
    }
    refuse_same_file("--output", options.output, "the input", options.input);
    if (!options.quantized.empty()) {
        refuse_same_file("--quantized", options.quantized, "the input", options.input);
        refuse_same_file("--quantized", options.quantized, "--output", options.output);
    }
    OutputFile::probe(options.output);
    if (!options.quantized.empty()) OutputFile::probe(options.quantized);

    const IntegerSolid solid = read_solid(options.input, options.solid);
    const CheckedSolid checked = check_solid(options.input, solid);
    ConvertOptions conversion = options.conversion;
    conversion.winding = winding_rule(options.solid, solid);
    const auto job = std::make_unique<Conversion>();
    std::optional<Progress> progress(std::in_place, console, "converting");
    const Converted converted = convert_twice(*job, checked, conversion, *progress);
    progress.reset();

    OutputFile tree_file(options.output);
    write_tree(tree_file, converted.outcome.tree, {solid.cube, conversion.leaves});
    if (!options.quantized.empty()) {
        OutputFile quantized(options.quantized);
        write_off(quantized.stream(), solid);
        quantized.commit();
    }
    tree_file.commit();
    if (options.stats) print_stats(console.out, *job, converted);
}

} // namespace

void add_convert(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("convert", "Convert a solid to an octree");
    const auto options = std::make_shared<Options>();
    command->add_option("IN", options->input, "Mesh file: .off, .stl, .obj or .poly")
        ->required()
        ->type_name("");
    add_output(*command, "-o,--output", options->output, "Octree file to write")
        ->required()
        ->type_name("OUT.osem");
    command->add_option("--depth", options->conversion.depth, "Depth of the tree, 1 to 20 (19 with centre)")
        ->check(CLI::Range(1, max_depth).description(""))
        ->type_name("N")
        ->capture_default_str();
    add_choice<LeafRule>(*command, "--leaves", options->conversion.leaves,
                         "Colour of leaves at full depth that the surface meets: conservative (the default: "
                         "boundary) or centre (black or white, as the leaf's centre)",
                         {{"conservative", LeafRule::conservative}, {"centre", LeafRule::centre}})
        ->type_name("RULE");
    add_solid_options(*command, options->solid);
    command->add_flag("--stats", options->stats,
                      "Print faces rejected and accepted by each stage, octants visited, nodes and time");
    add_output(*command, "--quantized", options->quantized,
               "Also write the integer solid actually converted, in lattice units (0 to 2^20)")
        ->type_name("Q.off");
    command->callback([options, &console] { run_convert(*options, console); });
}

} // namespace osem::host
