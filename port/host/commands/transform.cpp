// osem transform: an octree file moved, turned, scaled or cropped.
#include <cmath>
#include <memory>
#include <optional>
#include <ostream>
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
#include "osem/transform.hpp"

namespace osem::host {

namespace {

struct TransformArguments {
    std::string input;
    std::string output;
    std::string translate;
    std::string symmetry;
    std::string crop;
    std::string at;
    int up = 0;
    int down = 0;
    int depth = 0;
    bool cut = false;
    bool update_frame = false;
};

// The multiple of the lattice unit that a world length is; lengths that are none are refused.
std::int32_t lattice_length(const WorldCube& cube, const char* option, double world) {
    const double cells = world / cube.unit();
    const bool is_multiple = cells == std::floor(cells) && cells * cube.unit() == world;
    if (std::fabs(cells) > 2.0 * root_side) {
        throw BadInput(std::string(option) + ": " + decimal(world) +
                       " is farther than two sides of the root octant, " + decimal(cube.side));
    }
    if (!is_multiple) {
        throw BadInput(std::string(option) + ": " + decimal(world) +
                       " is no multiple of the lattice unit, which is " + decimal(cube.unit()) +
                       "; the nearest is " + decimal(std::round(cells) * cube.unit()));
    }
    return static_cast<std::int32_t>(cells);
}

Point lattice_vector(const WorldCube& cube, const std::string& text) {
    double world[3] = {};
    static_cast<void>(parse_decimals(text, world, 3)); // the parser has checked it
    Point vector = {{0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i) vector.at[i] = lattice_length(cube, "--translate", world[i]);
    return vector;
}

CellBox lattice_box(const WorldCube& cube, const std::string& text) {
    double world[6] = {};
    static_cast<void>(parse_decimals(text, world, 6));
    CellBox box = {{{0, 0, 0}}, {{0, 0, 0}}};
    for (std::size_t i = 0; i < 3; ++i) {
        box.low.at[i] = lattice_length(cube, "--crop", world[i] - cube.origin[i]);
        box.high.at[i] = lattice_length(cube, "--crop", world[i + 3] - cube.origin[i]);
    }
    return box;
}

// The octant of a level that holds the world point --at; by default the one in the root's minimum corner.
Octant octant_at(const WorldCube& cube, const std::string& text, int level) {
    Octant octant = {{{0, 0, 0}}, static_cast<std::uint8_t>(level)};
    if (text.empty()) return octant;
    double world[3] = {};
    static_cast<void>(parse_decimals(text, world, 3));
    for (std::size_t i = 0; i < 3; ++i) {
        const double cell = std::floor((world[i] - cube.origin[i]) / cube.unit());
        if (!(cell >= 0 && cell < root_side)) throw BadInput("--at lies outside the root cube");
        octant.corner.at[i] = static_cast<std::int32_t>(cell) & -octant.side();
    }
    return octant;
}

// "+y-x+z": along x lies what lay along y, along y what lay along x, reversed, and so on.
std::optional<Symmetry> parse_symmetry(const std::string& text) {
    Symmetry symmetry = Symmetry::identity();
    if (text.size() != 6) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        const char sign = text[2 * i];
        const char axis = text[2 * i + 1];
        if ((sign != '+' && sign != '-') || axis < 'x' || axis > 'z') return std::nullopt;
        symmetry.from[i] = static_cast<std::uint8_t>(axis - 'x');
        if (sign == '-') symmetry.flips = static_cast<std::uint8_t>(symmetry.flips | (1U << i));
    }
    if (!symmetry.is_valid()) return std::nullopt;
    return symmetry;
}

Octree tree_of(const TreeOutcome& outcome) {
    if (outcome.status != Status::ok) throw BadInput(describe(outcome.status));
    return outcome.tree;
}

// Runs a job twice: to count the nodes, then in a pool with room for them, which takes the place of `pool`.
template <class Job, class Begin>
Octree run_job(std::unique_ptr<HostPool>& pool, const Octree& tree, Progress& progress, const Begin& begin) {
    const auto job = std::make_unique<Job>();
    for (const bool count_only : {true, false}) {
        const Status begun = begin(*job, pool->adopted(tree), pool->pool(), count_only);
        if (begun != Status::ok) throw BadInput{describe(begun)};
        drive(*job, progress, count_only ? 0 : 1, 2);
        const TreeOutcome outcome = job->finish();
        if (!count_only) return tree_of(outcome);
        static_cast<void>(tree_of(outcome));
        pool = std::make_unique<HostPool>(*pool, std::uint64_t{pool->pool().used()} + outcome.nodes_needed);
    }
    return tree;
}

// Exactness can take leaves of single cells, which no computer has room for; so much is only done when asked.
void require_depth(const Octree& tree, const Placement& placement) {
    const int exact = placed_depth(tree.depth, placement);
    if (placement.depth != 0 || exact <= tree.depth) return;
    const std::uint64_t times = std::uint64_t{1} << (2 * (exact - tree.depth));
    throw BadInput("the vector or the box fits no leaves of the octree, whose depth is " +
                   std::to_string(tree.depth) + ": --depth " + std::to_string(exact) +
                   " places it exactly, with " + std::to_string(times) +
                   " times as many leaves or more; with less, octants of several colours become boundary");
}

Octree placed(std::unique_ptr<HostPool>& pool, const Octree& tree, const TransformArguments& options,
              WorldCube& cube, Progress& progress) {
    Placement placement;
    if (!options.crop.empty()) placement.keep = lattice_box(cube, options.crop);
    if (!options.translate.empty()) placement.by = lattice_vector(cube, options.translate);
    placement.cut_at_root = options.cut;
    placement.depth = static_cast<std::uint8_t>(options.depth);
    placement.mixed_as_boundary = options.depth != 0;
    require_depth(tree, placement);
    const double unit = cube.unit();
    for (std::size_t i = 0; i < 3 && options.update_frame; ++i) cube.origin[i] -= placement.by.at[i] * unit;
    return run_job<Translation>(pool, tree, progress,
                                [&](Translation& job, const Octree& from, NodePool& in, bool count_only) {
                                    return job.begin(from, placement, in, count_only);
                                });
}

Octree scaled(std::unique_ptr<HostPool>& pool, const Octree& tree, const TransformArguments& options,
              WorldCube& cube) {
    const bool up = options.up != 0;
    const Octant octant = octant_at(cube, options.at, up ? options.up : options.down);
    const WorldCube old = cube;
    const double scale = std::ldexp(1.0, up ? -options.up : options.down);
    if (options.update_frame) cube.side = old.side * scale;
    for (std::size_t i = 0; i < 3 && options.update_frame; ++i) {
        cube.origin[i] += up ? octant.corner.at[i] * old.unit() : -octant.corner.at[i] * cube.unit();
    }
    if (up) return tree_of(enlarged(tree, octant));
    if (tree.depth + octant.level > max_depth) {
        throw BadInput("--down " + std::to_string(options.down) + " makes the depth " +
                       std::to_string(tree.depth + octant.level) + ", and the greatest is " +
                       std::to_string(max_depth));
    }
    pool = std::make_unique<HostPool>(*pool, std::uint64_t{pool->pool().used()} + octant.level);
    return tree_of(reduced(pool->adopted(tree), octant, pool->pool()));
}

// What scaling up leaves out, in cells of the operand.
void print_dropped(std::ostream& out, const Measures& whole, const Measures& part, int up) {
    out << "inner_dropped " << whole.inner_volume - (part.inner_volume >> (3 * up)) << '\n'
        << "outer_dropped " << whole.outer_volume - (part.outer_volume >> (3 * up)) << '\n';
}

void require_one_job(const TransformArguments& options) {
    const bool places = !options.translate.empty() || !options.crop.empty();
    const int wanted = (places ? 1 : 0) + (options.symmetry.empty() ? 0 : 1) + (options.up != 0 ? 1 : 0) +
                       (options.down != 0 ? 1 : 0);
    if (wanted != 1) {
        throw CLI::ValidationError(
            "transform",
            "wants one of --translate (with or without --crop), --crop, --symmetry, --up, --down");
    }
    if (options.update_frame && !options.symmetry.empty()) {
        throw CLI::ValidationError("--update-frame", "no frame undoes a symmetry");
    }
    if (!options.at.empty() && options.up == 0 && options.down == 0) {
        throw CLI::ValidationError("--at", "is for --up and --down");
    }
    if (!places && (options.cut || options.depth != 0)) {
        throw CLI::ValidationError("transform", "--cut and --depth are for --translate and --crop");
    }
}

void run_transform(const TransformArguments& options, const Console& console) {
    require_one_job(options);
    OutputFile::probe(options.output);
    TreeFile file(options.input);
    TreeFacts facts = file.facts();
    auto pool = std::make_unique<HostPool>(file.nodes());
    Octree tree = file.read(pool->pool());
    const Measures before = measure(tree);
    {
        Progress progress(console, "transforming");
        if (!options.symmetry.empty()) {
            const Symmetry symmetry = *parse_symmetry(options.symmetry);
            tree = run_job<Reorientation>(
                pool, tree, progress,
                [&](Reorientation& job, const Octree& from, NodePool& in, bool count_only) {
                    return job.begin(from, symmetry, in, count_only);
                });
        } else if (options.up != 0 || options.down != 0) {
            tree = scaled(pool, tree, options, facts.cube);
        } else {
            tree = placed(pool, tree, options, facts.cube, progress);
        }
    }
    OutputFile output(options.output);
    write_tree(output, tree, facts);
    if (options.up != 0) print_dropped(console.out, before, measure(tree), options.up);
    finish_printing(console);
    output.commit();
}

std::string numbers_fault(const std::string& text, std::size_t count) {
    double numbers[6] = {};
    return parse_decimals(text, numbers, count)
               ? std::string()
               : "expected " + std::to_string(count) + " finite decimal numbers, separated by commas";
}
std::string vector_fault(const std::string& text) { return numbers_fault(text, 3); }
std::string box_fault(const std::string& text) { return numbers_fault(text, 6); }
std::string symmetry_fault(const std::string& text) {
    return parse_symmetry(text) ? std::string() : "expected signs and axes such as +y-x+z, each axis once";
}

constexpr const char* transform_footer =
    "Every cell of the result has the colour of the cell that it came from. Lengths are in world units and\n"
    "have to be multiples of the lattice unit, SIDE / 2^20. A vector or a box that is no multiple of the\n"
    "side of X's leaves needs --depth; octants of several colours at that depth become boundary. --up keeps\n"
    "one octant and prints inner_dropped and outer_dropped: the black cells, and the black and boundary\n"
    "cells, of X outside of it, 2^60 of which fill the root. --update-frame changes the frame along with\n"
    "the tree, so that the solid stays where it is in the world.";

} // namespace

void add_transform(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("transform", "Move, turn, scale or crop an octree");
    const auto options = std::make_shared<TransformArguments>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    add_tree_output(*command, "-o,--output", options->output, "Octree file to write; may be the one read")
        ->required()
        ->type_name("Y.osem");
    command->add_option("--translate", options->translate, "Vector; nothing may leave the root cube")
        ->check(vector_fault)
        ->type_name("X,Y,Z");
    command->add_flag("--cut", options->cut, "What leaves the root cube is dropped");
    command->add_option("--crop", options->crop, "Box of the result outside of which all becomes white")
        ->check(box_fault)
        ->type_name("X0,Y0,Z0,X1,Y1,Z1");
    command->add_option("--depth", options->depth, "Greatest depth of the result, for --translate and --crop")
        ->check(CLI::Range(1, max_depth).description(""))
        ->type_name("D");
    command
        ->add_option("--symmetry", options->symmetry,
                     "+y-x+z: x becomes old y, y old x reversed, z stays; about the root's centre")
        ->check(symmetry_fault)
        ->type_name("AXES");
    command->add_option("--up", options->up, "Scale up by 2^K: the octant at --at fills the root")
        ->check(CLI::Range(1, max_depth).description(""))
        ->type_name("K");
    command->add_option("--down", options->down, "Scale down by 2^K, into the octant at --at")
        ->check(CLI::Range(1, max_depth).description(""))
        ->type_name("K");
    command->add_option("--at", options->at, "World point in the octant. Default: the minimum corner")
        ->check(vector_fault)
        ->type_name("X,Y,Z");
    command->add_flag("--update-frame", options->update_frame, "Change the frame along with the tree");
    command->footer(transform_footer);
    command->callback([options, &console] { run_transform(*options, console); });
}

} // namespace osem::host
