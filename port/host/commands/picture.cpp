// osem image: a picture of an octree file.
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "commands/write_image.hpp"
#include "console/progress.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "picture/camera.hpp"
#include "picture/render.hpp"

namespace osem::host {

namespace {

constexpr int most_image_pixels = 4096;

struct ImageOptions {
    std::string input;
    std::string output;
    std::string view = "iso";
    int size = 800;
};

void run_image(const ImageOptions& options, const Console& console) {
    refuse_same_file("--output", options.output, "the input", options.input);
    OutputFile::probe(options.output);
    TreeFile file(options.input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    Progress progress(console, "rendering");
    write_image(options.output, render(tree, *parse_view(options.view), options.size, progress));
}

std::string view_fault(const std::string& text) {
    if (parse_view(text)) return {};
    return "expected iso, front, back, left, right, top, bottom or AZIMUTH,ELEVATION in degrees";
}

constexpr const char* image_footer =
    "Orthographic, hidden surfaces removed, fitted to what the tree holds. Boundary leaves are steel blue,\n"
    "black leaves, where they show, warm grey. The front is seen from negative y, the right side from\n"
    "positive x; an azimuth counts from the x axis towards the y axis, an elevation upwards (z).";

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

} // namespace osem::host
