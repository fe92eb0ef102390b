// osem image: a picture of an octree file, of a solid, or of both side by side.
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "commands/solid_input.hpp"
#include "commands/write_image.hpp"
#include "console/progress.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "picture/camera.hpp"
#include "picture/render.hpp"
#include "picture/sheet.hpp"

namespace osem::host {

namespace {

constexpr int most_image_pixels = 4096;

struct ImageOptions {
    std::string input;
    std::string with;
    std::string output;
    std::string views = "iso";
    int size = 800;
    std::optional<Style> shade;
    bool wireframe = false;
    std::optional<Lines> lines;
};

// What is drawn, kept while it is.
struct Shown {
    std::optional<HostPool> pool;
    Octree tree = {};
    IntegerSolid solid;
    std::vector<Subject> subjects; ///< from the left
};

void load_solid(Shown& shown, const std::string& path, const SolidOptions& options) {
    shown.solid = read_solid(path, options);
    check_solid(path, shown.solid);
    shown.subjects.emplace_back(&shown.solid);
}

void load(Shown& shown, const ImageOptions& options) {
    if (!is_tree_name(options.input)) {
        if (!options.with.empty()) throw CLI::ValidationError("--with", "X is no octree file");
        load_solid(shown, options.input, {});
        return;
    }
    TreeFile file(options.input);
    shown.pool.emplace(file.nodes());
    shown.tree = file.read(shown.pool->pool());
    if (!options.with.empty()) load_solid(shown, options.with, {frame_text(file.facts().cube), std::nullopt});
    shown.subjects.emplace_back(&shown.tree);
}

// In a grid about as wide as high; subjects side by side have a row for each view.
int columns_of(std::size_t views, std::size_t subjects) {
    if (subjects > 1) return static_cast<int>(subjects);
    return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(views))));
}

Image draw(const Shown& shown, const ImageOptions& options, const Console& console) {
    const std::vector<NamedView> views = *parse_views(options.views);
    const Style style = options.wireframe ? Style::wireframe : options.shade.value_or(Style::faces);
    const Look look = {style, options.lines.value_or(Lines::leaves)};
    std::vector<Tile> tiles;
    for (const NamedView& view : views) {
        for (const Subject& subject : shown.subjects) {
            Progress progress(console, "rendering");
            const std::string label = views.size() > 1 ? view.name : std::string();
            tiles.push_back(
                {render(subject, shown.subjects, view.view, options.size, look, progress), label});
        }
    }
    return sheet(tiles, columns_of(views.size(), shown.subjects.size()));
}

void require_sense(const ImageOptions& options) {
    if (options.wireframe && options.shade) {
        throw CLI::ValidationError("--shade", "is for --style shaded; a wireframe has no shades");
    }
    if (!options.wireframe && options.lines) {
        throw CLI::ValidationError("--lines", "is for --style wireframe");
    }
}

void run_image(const ImageOptions& options, const Console& console) {
    require_sense(options);
    refuse_same_file("--output", options.output, "the input", options.input);
    if (!options.with.empty()) refuse_same_file("--output", options.output, "--with", options.with);
    OutputFile::probe(options.output);
    Shown shown;
    load(shown, options);
    write_image(options.output, draw(shown, options, console));
}

std::string view_fault(const std::string& text) {
    const auto views = parse_views(text);
    if (!views) {
        return "expected iso, front, back, left, right, top, bottom or AZIMUTH,ELEVATION in degrees, or a "
               "list of them with commas";
    }
    return views->size() <= 16 ? std::string() : std::string("more than 16 views");
}

constexpr const char* image_footer =
    "Orthographic, hidden surfaces removed, fitted to what is drawn. Boundary leaves are steel blue, black\n"
    "leaves, where they show, and solids warm grey. The front is seen from negative y, the right side from\n"
    "positive x; an azimuth counts from the x axis towards the y axis, an elevation upwards (z). Several\n"
    "views, as in iso,front,top,right, fill a grid row by row, each --size pixels a side. With --with the\n"
    "solid is on the left, the octree on the right, under one camera, a row for each view.";

void add_looks(CLI::App& command, ImageOptions& options) {
    add_choice<bool>(command, "--style", options.wireframe,
                     "shaded, or wireframe: lines, hidden ones removed. Default: shaded",
                     {{"shaded", false}, {"wireframe", true}})
        ->type_name("STYLE");
    add_choice<Style>(command, "--shade", options.shade,
                      "faces, each leaf's as it is, or smooth, as the surface that small leaves stand for. "
                      "Default: faces",
                      {{"faces", Style::faces}, {"smooth", Style::smooth}})
        ->type_name("HOW");
    add_choice<Lines>(command, "--lines", options.lines,
                      "Lines of a wireframe: leaves, around every face, or outline, where the surface bends "
                      "or ends. Default: leaves",
                      {{"leaves", Lines::leaves}, {"outline", Lines::outline}})
        ->type_name("WHICH");
}

} // namespace

void add_image(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("image", "Draw an octree or a solid");
    const auto options = std::make_shared<ImageOptions>();
    command->add_option("X", options->input, "Octree file, or a mesh")->required()->type_name("");
    add_picture_output(*command, "-o,--output", options->output, "PNG file to write")
        ->required()
        ->type_name("OUT.png");
    command->add_option("--with", options->with, "Mesh to draw beside the octree, in its frame")
        ->type_name("MESH");
    command
        ->add_option("--view", options->views,
                     "iso, front, back, left, right, top, bottom or AZIMUTH,ELEVATION, or several")
        ->check(view_fault)
        ->type_name("VIEW")
        ->capture_default_str();
    command->add_option("--size", options->size, "Pixels a side, 16 to 4096")
        ->check(CLI::Range(16, most_image_pixels).description(""))
        ->type_name("N")
        ->capture_default_str();
    add_looks(*command, *options);
    command->footer(image_footer);
    command->callback([options, &console] { run_image(*options, console); });
}

} // namespace osem::host
