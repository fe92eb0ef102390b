// osem image and osem slice: pictures of an octree file.
#include <cmath>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "console/progress.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "picture/camera.hpp"
#include "picture/image.hpp"
#include "picture/render.hpp"
#include "picture/slice.hpp"

namespace osem::host {

namespace {

constexpr int most_image_pixels = 4096;

struct ImageOptions {
    std::string input;
    std::string output;
    std::string view = "iso";
    int size = 800;
};

struct SliceOptions {
    std::string input;
    std::string output;
    Axis axis = axis_z;
    std::string at;
};

void write_image(const std::string& path, const Image& image) {
    OutputFile output(path);
    write_png(output.stream(), image);
    output.commit();
}

void run_image(const ImageOptions& options, const Console& console) {
    refuse_same_file("--output", options.output, "the input", options.input);
    OutputFile::probe(options.output);
    TreeFile file(options.input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    Progress progress(console, "rendering");
    write_image(options.output, render(tree, *parse_view(options.view), options.size, progress));
}

// The cell whose half-open extent along the axis holds the world coordinate.
std::int32_t cell_at(const WorldCube& cube, Axis axis, double world) {
    const double low = cube.origin[axis];
    const double cell = std::floor((world - low) / cube.unit());
    if (!(cell >= 0 && cell < root_side)) {
        throw BadInput("--at " + decimal(world) + " lies outside the root cube: " + "xyz"[axis] +
                       " runs from " + decimal(low) + " to below " + decimal(low + cube.side));
    }
    return static_cast<std::int32_t>(cell);
}

void run_slice(const SliceOptions& options) {
    refuse_same_file("--output", options.output, "the input", options.input);
    OutputFile::probe(options.output);
    TreeFile file(options.input);
    double world = 0;
    static_cast<void>(parse_decimals(options.at, &world, 1)); // the parser has checked it
    const std::int32_t cell = cell_at(file.facts().cube, options.axis, world);
    HostPool pool(file.nodes());
    write_image(options.output, slice(file.read(pool.pool()), options.axis, cell));
}

std::string view_fault(const std::string& text) {
    if (parse_view(text)) return {};
    return "expected iso, front, back, left, right, top, bottom or AZIMUTH,ELEVATION in degrees";
}

std::string number_fault(const std::string& text) {
    double number = 0;
    return parse_decimals(text, &number, 1) ? std::string() : "expected a finite decimal number";
}

constexpr const char* image_footer =
    "Orthographic, hidden surfaces removed, fitted to what the tree holds. Boundary leaves are steel blue,\n"
    "black leaves, where they show, warm grey. The front is seen from negative y, the right side from\n"
    "positive x; an azimuth counts from the x axis towards the y axis, an elevation upwards (z).";

constexpr const char* slice_footer =
    "White, black and boundary (steel blue) leaves of one plane, a pixel a leaf at the tree's depth; above\n"
    "2048 pixels a side a pixel is the mean of its leaves, below 256 a leaf is a square of 256 / 2^depth\n"
    "pixels. Where --at falls on the border of two leaves the one on the positive side is shown. Axis x "
    "shows\n"
    "y to the right and z upwards, axis y x and z, axis z x and y.";

} // namespace

void add_image(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("image", "Draw an octree as a shaded picture");
    const auto options = std::make_shared<ImageOptions>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    add_output(*command, "-o,--output", options->output, "PNG file to write")
        ->required()
        ->type_name("OUT.png");
    command
        ->add_option("--view", options->view,
                     "iso, front, back, left, right, top, bottom or AZIMUTH,ELEVATION")
        ->check(view_fault)
        ->type_name("VIEW")
        ->capture_default_str();
    command->add_option("--size", options->size, "Pixels a side, 16 to 4096")
        ->check(CLI::Range(16, most_image_pixels).description(""))
        ->type_name("N")
        ->capture_default_str();
    command->footer(image_footer);
    command->callback([options, &console] { run_image(*options, console); });
}

void add_slice(CLI::App& app, const Console&) {
    CLI::App* command = app.add_subcommand("slice", "Draw a plane of an octree");
    const auto options = std::make_shared<SliceOptions>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    add_output(*command, "-o,--output", options->output, "PNG file to write")
        ->required()
        ->type_name("OUT.png");
    add_choice<Axis>(*command, "--axis", options->axis, "The axis the plane is perpendicular to: x, y or z",
                     {{"x", axis_x}, {"y", axis_y}, {"z", axis_z}})
        ->required()
        ->type_name("AXIS");
    command->add_option("--at", options->at, "World coordinate of the plane along the axis")
        ->required()
        ->check(number_fault)
        ->type_name("WORLD");
    command->footer(slice_footer);
    command->callback([options] { run_slice(*options); });
}

} // namespace osem::host
