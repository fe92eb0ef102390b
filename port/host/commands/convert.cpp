// osem convert: a mesh file to an octree file.
#include <algorithm>
#include <iomanip>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/conversion.hpp"
#include "commands/octants_apart.hpp"
#include "commands/output_option.hpp"
#include "commands/solid_input.hpp"
#include "console/progress.hpp"
#include "files/node_budget.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/quantize.hpp"
#include "mesh/write_off.hpp"
#include "osem/convert.hpp"
#include "osem/grid_convert.hpp"

namespace osem::host {

namespace {

enum class Technique { grids, divide, bintree };

// What each technique visits.
const char* const visited_names[] = {"grid", "octant", "block"};

struct ConvertArguments {
    std::string input;
    std::string output;
    std::string quantized;
    SolidOptions solid;
    ConvertOptions conversion; ///< but for the winding rule
    Technique technique = Technique::grids;
    std::optional<std::uint32_t> nodes; ///< to fit
    std::optional<unsigned> threads;    ///< by grids
    bool stats = false;
};

void print_stages(std::ostream& out, const StageCounts& stages) {
    static const char* const names[stage_count] = {"minimax", "plane", "vertices", "section", "holes"};
    out << "stage             rejected         accepted\n";
    for (int i = 0; i < stage_count; ++i) {
        out << std::left << std::setw(9) << names[i] << std::right << std::setw(17) << stages.rejected[i]
            << std::setw(17) << stages.accepted[i] << '\n';
    }
}

void print_stats(std::ostream& out, Technique technique, const Converted& converted) {
    if (technique != Technique::grids) print_stages(out, converted.stages);
    const std::string visited = visited_names[static_cast<int>(technique)];
    out << visited << "s " << converted.visited << '\n';
    for (const auto& [name, count] : converted.counts) out << name << ' ' << count << '\n';
    out << "nodes " << measure(converted.tree).nodes << '\n'
        << "memory_bytes " << converted.memory << '\n'
        << "ns_per_" << visited << ' '
        << static_cast<std::uint64_t>(1e9 * converted.seconds / static_cast<double>(converted.visited))
        << '\n';
}

void refuse_contradictions(const ConvertArguments& options) {
    const bool centre = options.conversion.leaves == LeafRule::centre;
    if (centre && options.conversion.depth == max_depth) {
        throw CLI::ValidationError("--depth", "centre leaves end at depth 19");
    }
    if (options.threads && options.nodes) {
        throw CLI::ValidationError("--threads", "--fit converts by divide and conquer, on one thread");
    }
    if (options.threads && options.technique != Technique::grids) {
        throw CLI::ValidationError("--threads", "is for --technique grids");
    }
    if (options.technique != Technique::bintree) return;
    if (centre) throw CLI::ValidationError("--technique", "bintree has no centre leaves");
    if (options.nodes) throw CLI::ValidationError("--technique", "--fit converts by divide and conquer");
}

Converted convert(const ConvertArguments& options, const CheckedSolid& solid, WindingRule winding,
                  const Console& console) {
    ConvertOptions conversion = options.conversion;
    conversion.winding = winding;
    Progress progress(console, "converting");
    if (options.nodes) return divide_to_fit(solid, conversion, *options.nodes, progress);
    if (options.technique == Technique::bintree) return label(solid, conversion, progress);
    if (options.technique == Technique::divide) return divide(solid, conversion, progress);
    const unsigned threads =
        options.threads.value_or(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
    const bool apart = threads > 1 && conversion.depth > most_grid_levels; // otherwise there is one grid
    return apart ? convert_octants_apart(solid, conversion, threads, progress)
                 : convert_by_grids(solid, conversion, progress);
}

void run_convert(const ConvertArguments& options, const Console& console) {
    refuse_contradictions(options);
    refuse_same_file("--output", options.output, "the input", options.input);
    if (!options.quantized.empty()) {
        refuse_same_file("--quantized", options.quantized, "the input", options.input);
        refuse_same_file("--quantized", options.quantized, "--output", options.output);
    }
    OutputFile::probe(options.output);
    if (!options.quantized.empty()) OutputFile::probe(options.quantized);

    const IntegerSolid solid = read_solid(options.input, options.solid);
    const CheckedSolid checked = check_solid(options.input, solid);
    const Converted converted = convert(options, checked, winding_rule(options.solid, solid), console);

    OutputFile tree_file(options.output);
    write_tree(tree_file, converted.tree, {solid.cube, options.conversion.leaves});
    std::optional<OutputFile> quantized;
    if (!options.quantized.empty()) write_off(quantized.emplace(options.quantized).stream(), solid);
    if (options.nodes) console.out << "depth " << int{converted.tree.depth} << '\n';
    const Technique technique = options.nodes ? Technique::divide : options.technique;
    if (options.stats) print_stats(console.out, technique, converted);
    finish_printing(console);
    if (quantized) quantized->commit();
    tree_file.commit();
}

} // namespace

void add_convert(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("convert", "Convert a solid to an octree");
    const auto options = std::make_shared<ConvertArguments>();
    command->add_option("IN", options->input, "Mesh file: .off, .stl, .obj or .poly")
        ->required()
        ->type_name("");
    add_tree_output(*command, "-o,--output", options->output, "Octree file to write")
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
    add_choice<Technique>(
        *command, "--technique", options->technique,
        "grids (the default: many octants at once), divide (octant by octant, in less memory) or bintree (a "
        "bintree and the labelling of its components; no centre leaves); the trees are the same",
        {{"grids", Technique::grids}, {"divide", Technique::divide}, {"bintree", Technique::bintree}})
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--fit", [options](const std::string& text) { options->nodes = parse_node_budget(text); },
            "Convert at the finest depth, up to that of --depth, whose tree takes no more from a pool: nodes "
            "(600) or memory (8KB; units B, KB, MB), the top node not counted; octant by octant. Prints the "
            "depth")
        ->check([](const std::string& text) {
            return parse_node_budget(text) ? std::string() : "expected nodes of a pool, or B, KB or MB";
        })
        ->type_name("SIZE");
    command
        ->add_option("--threads", options->threads,
                     "How many threads convert by grids, up to 8; the tree is the same (default: as many as "
                     "the machine "
                     "runs at once)")
        ->check(CLI::Range(1, 8).description(""))
        ->type_name("N");
    add_solid_options(*command, options->solid);
    command->add_flag(
        "--stats", options->stats,
        "Print the grids, octants or blocks visited, nodes, memory (job, scratch as far as it was used, and "
        "pool) and the time of the pass that made the tree (on several threads: of all of them together); "
        "except for grids, also how many faces each stage rejected and accepted");
    add_output(*command, "--quantized", options->quantized,
               "Also write the integer solid actually converted, in lattice units (0 to 2^20)")
        ->type_name("Q.off");
    command->callback([options, &console] { run_convert(*options, console); });
}

} // namespace osem::host
