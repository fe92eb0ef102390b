// osem slice: one layer of an octree file or a stack of them, as pictures or as runs.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "commands/stack_name.hpp"
#include "commands/write_image.hpp"
#include "console/progress.hpp"
#include "console/text_lines.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "picture/slice.hpp"

namespace osem::host {

namespace {

struct SliceArguments {
    std::string input;
    std::string output;
    Axis axis = axis_z;
    std::string at;
    bool stack = false;
    std::string from;
    std::string to;
    int every = 1;
    bool runs = false;
    int level = -1; // the tree's depth
};

// The cell whose half-open extent along the axis holds the world coordinate that an option was given.
std::int32_t cell_at(const WorldCube& cube, Axis axis, const char* option, const std::string& text) {
    double world = 0;
    static_cast<void>(parse_decimals(text, &world, 1)); // the parser has checked it
    const double low = cube.origin[axis];
    const double cell = std::floor((world - low) / cube.unit());
    if (!(cell >= 0 && cell < root_side)) {
        throw BadInput(std::string(option) + ' ' + decimal(world) + " lies outside the root cube: " +
                       "xyz"[axis] + " runs from " + decimal(low) + " to below " + decimal(low + cube.side));
    }
    return static_cast<std::int32_t>(cell);
}

// A file of a few bytes may state a depth of 20: a million pictures.
constexpr std::int32_t most_layers = 16384;

// The cells of the layers asked for: one, or those of a stack, each the lowest of its layer of pixels.
std::vector<std::int32_t> cells_of(const SliceArguments& options, const WorldCube& cube, int level) {
    if (!options.stack) return {cell_at(cube, options.axis, "--at", options.at)};
    const std::int32_t side = root_side >> level;
    std::int32_t first = 0;
    std::int32_t last = root_side - 1;
    if (!options.from.empty()) first = cell_at(cube, options.axis, "--from", options.from);
    if (!options.to.empty()) last = cell_at(cube, options.axis, "--to", options.to);
    if (first > last) throw CLI::ValidationError("--from", "is above --to");
    const std::int32_t layers = (last / side - first / side) / options.every + 1;
    if (layers > most_layers) {
        throw BadInput("a stack of " + std::to_string(layers) + " layers; " + std::to_string(most_layers) +
                       " at most: --level, --every, --from and --to choose fewer");
    }
    std::vector<std::int32_t> cells;
    for (std::int64_t layer = first / side; layer <= last / side; layer += options.every) {
        cells.push_back(static_cast<std::int32_t>(layer) * side);
    }
    return cells;
}

int level_of(const SliceArguments& options, const Octree& tree) {
    if (options.level < 0) return tree.depth;
    if (options.level <= tree.depth) return options.level;
    throw BadInput("--level " + std::to_string(options.level) +
                   " is deeper than the octree, whose depth is " + std::to_string(tree.depth));
}

// One line a run; a stream that refuses is reported once, when the command has ended.
struct RunLines {
    TextLines lines;
    std::int32_t layer = 0;

    static bool take(void* context, const PixelRun& run) {
        auto& self = *static_cast<RunLines*>(context);
        if (!self.lines.start_line()) return false;
        for (const std::int32_t value : {self.layer, run.row, run.start, run.length}) {
            self.lines.number(value);
        }
        self.lines.word(run.colour == Colour::black ? "black\n" : "boundary\n");
        return true;
    }
};

void write_runs(const Octree& tree, const SliceArguments& options, const std::vector<std::int32_t>& cells,
                int level, std::ostream& out) {
    RunLines text{TextLines(out)};
    RunSlicing job;
    for (const std::int32_t cell : cells) {
        text.layer = cell / (root_side >> level);
        static_cast<void>(
            job.begin(tree, {options.axis, cell, static_cast<std::uint8_t>(level)}, {RunLines::take, &text}));
        job.step(UINT32_MAX);
        if (job.finish().status != Status::ok) break;
    }
    text.lines.flush();
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw BadInput(path + ": " + error.message());
}

void write_stack(const Octree& tree, const SliceArguments& options, const std::vector<std::int32_t>& cells,
                 int level, const Console& console) {
    const StackName names = *StackName::parse(options.output);
    if (options.output.find('%') == std::string::npos) make_folder(options.output);
    Progress progress(console, "slicing");
    std::uint64_t done = 0;
    for (const std::int32_t cell : cells) {
        progress.show(done++, cells.size());
        write_image(names.of(cell / (root_side >> level)),
                    draw_slice(tree, {options.axis, cell, static_cast<std::uint8_t>(level)}));
    }
}

// A directory that looks like a picture is hardly meant.
void require_picture_names(const SliceArguments& options) {
    if (!options.stack) {
        const std::string fault = picture_name_fault(options.output);
        if (!fault.empty()) throw CLI::ValidationError("--output", fault);
        return;
    }
    const bool numbered = options.output.find('%') != std::string::npos;
    const bool named_png = picture_name_fault(options.output).empty();
    if (!StackName::parse(options.output) || numbered != named_png) {
        throw CLI::ValidationError("--output", "a stack is many files: expected a directory, or a name with "
                                               "one %d or %0Nd that ends in .png, not " +
                                                   options.output);
    }
}

void require_sense(const SliceArguments& options) {
    if (options.stack == !options.at.empty()) {
        throw CLI::ValidationError("slice", "either --at or --stack says which layers are meant");
    }
    if (!options.stack && (!options.from.empty() || !options.to.empty() || options.every != 1)) {
        throw CLI::ValidationError("slice", "--from, --to and --every choose the layers of a --stack");
    }
    if (options.output.empty() && !options.runs) {
        throw CLI::ValidationError("--output", "is required for pictures");
    }
    if (!options.runs) require_picture_names(options);
}

void run_slice(const SliceArguments& options, const Console& console) {
    require_sense(options);
    const bool one_file = !options.output.empty() && (options.runs || !options.stack);
    if (!options.output.empty()) {
        refuse_same_file("--output", options.output, "the input", options.input);
        if (one_file) OutputFile::probe(options.output);
    }
    TreeFile file(options.input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    const int level = level_of(options, tree);
    const std::vector<std::int32_t> cells = cells_of(options, file.facts().cube, level);
    if (!options.runs) {
        if (options.stack) {
            write_stack(tree, options, cells, level, console);
        } else {
            write_image(options.output,
                        draw_slice(tree, {options.axis, cells[0], static_cast<std::uint8_t>(level)}));
        }
    } else if (one_file) {
        OutputFile output(options.output);
        write_runs(tree, options, cells, level, output.stream());
        output.commit();
    } else {
        write_runs(tree, options, cells, level, console.out);
    }
}

std::string number_fault(const std::string& text) {
    double number = 0;
    return parse_decimals(text, &number, 1) ? std::string() : "expected a finite decimal number";
}

constexpr const char* slice_footer =
    "White, black and boundary (steel blue) leaves of one plane, a pixel a leaf at the tree's depth; above\n"
    "2048 pixels a side a pixel is the mean of its leaves, below 256 a leaf is a square of 256 / 2^depth\n"
    "pixels. Where --at falls on the border of two leaves the one on the positive side is shown. Axis x "
    "shows\n"
    "y to the right and z upwards, axis y x and z, axis z x and y. With --level a pixel of several leaves "
    "is\n"
    "white or black only if it is so throughout, else boundary.\n"
    "--stack writes one picture a layer of pixels (with --level of its lowest cells), numbered from 0 at "
    "the\n"
    "root's low side: -o is a directory (0000.png, 0001.png, ...) or a pattern such as part%04d.png. If it\n"
    "fails part way, the pictures written so far remain. A stack has at most 16384 layers.\n"
    "--runs prints one line a run, white left out: \"layer row start length colour\", all in pixels, rows\n"
    "counted upwards; with -o into a file.";

void add_layers(CLI::App& command, SliceArguments& options) {
    command.add_option("--at", options.at, "World coordinate of the plane along the axis")
        ->check(number_fault)
        ->type_name("WORLD");
    command.add_flag("--stack", options.stack, "All layers, one picture each");
    command.add_option("--from", options.from, "World coordinate in the first layer of the stack")
        ->check(number_fault)
        ->type_name("WORLD");
    command.add_option("--to", options.to, "World coordinate in the last layer of the stack")
        ->check(number_fault)
        ->type_name("WORLD");
    command.add_option("--every", options.every, "Only every N-th layer of the stack")
        ->check(CLI::Range(1, root_side).description(""))
        ->type_name("N");
}

} // namespace

void add_slice(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("slice", "Draw planes of an octree, or print them as runs");
    const auto options = std::make_shared<SliceArguments>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    add_output(*command, "-o,--output", options->output,
               "PNG file to write; with --stack a pattern or a directory")
        ->type_name("OUT.png");
    add_choice<Axis>(*command, "--axis", options->axis, "The axis the plane is perpendicular to: x, y or z",
                     {{"x", axis_x}, {"y", axis_y}, {"z", axis_z}})
        ->required()
        ->type_name("AXIS");
    add_layers(*command, *options);
    command->add_flag("--runs", options->runs, "Print runs instead of drawing");
    command->add_option("--level", options->level, "Pixels of side 1 / 2^L of the root. Default: the depth")
        ->check(CLI::Range(0, max_depth).description(""))
        ->type_name("L");
    command->footer(slice_footer);
    command->callback([options, &console] { run_slice(*options, console); });
}

} // namespace osem::host
