// osem measure and osem components: exact measures of the solids that an octree file certifies.
#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/tree_file.hpp"
#include "measure/mass.hpp"
#include "measure/wide.hpp"
#include "mesh/bad_input.hpp"
#include "osem/components.hpp"

namespace osem::host {

namespace {

struct ComponentOptions {
    std::string input;
    bool empty = false; ///< of the void instead of the solid
    bool outer = false;
    Connectivity connectivity = Connectivity::corners;
};

// A labelling and the memory it works in.
class Labels {
  public:
    Labels(const Octree& tree, std::uint8_t colours, Connectivity connectivity) {
        const std::uint64_t words = component_scratch(measure(tree), colours);
        if (words > INT32_MAX) throw BadInput("the octree has too many leaves to be labelled");
        scratch_.resize(static_cast<std::size_t>(words));
        job_.begin(tree, colours, connectivity, scratch_.data(), static_cast<std::uint32_t>(words));
        while (job_.step(UINT32_MAX)) {
        }
    }

    std::vector<Component> components() const {
        std::vector<Component> all(job_.finish().components);
        job_.fill(all.data(), static_cast<std::uint32_t>(all.size()));
        return all;
    }

  private:
    std::vector<std::uint32_t> scratch_;
    ComponentLabelling job_;
};

std::uint8_t colours_of(bool empty, bool outer) {
    if (empty) return outer ? outer_void : inner_void;
    return outer ? outer_solid : inner_solid;
}

template <class Value>
void list(std::ostream& out, const std::string& key, const Value* values, int count) {
    out << key;
    for (int i = 0; i < count; ++i) {
        if constexpr (std::is_integral_v<Value>) {
            out << ' ' << values[i];
        } else {
            out << ' ' << decimal(values[i]);
        }
    }
    out << '\n';
}

void print_shape(std::ostream& out, const std::string& solid, const Octree& tree, bool outer,
                 const SurfaceMeasures& surface) {
    const std::size_t pieces =
        Labels(tree, colours_of(false, outer), Connectivity::corners).components().size();
    const auto around = Labels(tree, colours_of(true, outer), Connectivity::faces).components();
    const auto cavities =
        std::count_if(around.begin(), around.end(), [](const Component& c) { return !c.touches_border; });
    out << solid << "_euler_closed " << surface.euler_closed << '\n'
        << solid << "_euler_open " << surface.euler_open << '\n'
        << solid << "_pieces " << pieces << '\n'
        << solid << "_cavities " << cavities << '\n'
        << solid << "_tunnels " << static_cast<std::int64_t>(pieces) + cavities - surface.euler_closed
        << '\n';
}

void print_solid(std::ostream& out, const std::string& solid, const Moments& moments,
                 const SurfaceMeasures& surface, const WorldCube& cube) {
    out << solid << "_volume " << moments.volume << '\n';
    list(out, solid + "_first", moments.first, 3);
    list(out, solid + "_second", moments.second, 6);
    list(out, solid + "_area", surface.area, 3);
    out << solid << "_volume_world " << decimal(world_volume(moments.volume, cube)) << '\n';
    double area[3];
    for (int a = 0; a < 3; ++a) area[a] = static_cast<double>(surface.area[a]) * cube.unit() * cube.unit();
    list(out, solid + "_area_world", area, 3);
    if (moments.volume == 0) return;
    const Mass mass = mass_of(moments, cube);
    list(out, solid + "_centroid_world", mass.centroid, 3);
    list(out, solid + "_inertia_world", mass.inertia, 6);
}

void run_measure(const std::string& input, std::ostream& out) {
    TreeFile file(input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    const WorldCube& cube = file.facts().cube;
    const SolidMoments m = moments(tree);
    SurfaceMeasurement job;
    const SurfaceOutcome surface = measure_surface(job, tree);
    print_solid(out, "inner", m.inner, surface.inner, cube);
    print_shape(out, "inner", tree, false, surface.inner);
    print_solid(out, "outer", m.outer, surface.outer, cube);
    print_shape(out, "outer", tree, true, surface.outer);
}

void run_components(const ComponentOptions& options, std::ostream& out) {
    TreeFile file(options.input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    const auto components =
        Labels(tree, colours_of(options.empty, options.outer), options.connectivity).components();
    out << "components " << components.size() << '\n';
    std::size_t index = 0;
    for (const Component& c : components) {
        out << index++ << ' ' << c.volume << ' ' << decimal(world_volume(c.volume, file.facts().cube)) << ' '
            << c.leaves;
        for (const Point* corner : {&c.box.low, &c.box.high}) {
            for (const std::int32_t at : corner->at) out << ' ' << at;
        }
        out << (c.touches_border ? " border" : options.empty ? " sealed" : " inside") << '\n';
    }
}

constexpr const char* measure_footer =
    "Prints one \"key values\" line each, for the inner solid (black leaves) and the outer one (black and\n"
    "boundary leaves). In lattice units, exactly: volume; first, 2 * integral of x y z; second, 12 * "
    "integral\n"
    "of xx yy zz xy yz zx; area perpendicular to x y z, the root's border included. In world units: volume,\n"
    "area, centroid, and inertia about it (Ixx Iyy Izz Ixy Iyz Izx, unit density); the last two are left "
    "out\n"
    "when there is no volume. euler_closed counts the closed solid, whose pieces may hang together by\n"
    "corners: pieces - tunnels + cavities, each also by itself; euler_open counts its interior.";

constexpr const char* components_footer =
    "Prints \"components N\", then one line each: \"index volume volume_world leaves x y z x y z where\". "
    "The\n"
    "volume is in lattice cells; the corners of the bounding box are in lattice units; where is \"border\" "
    "when\n"
    "the component reaches the root's border, else \"inside\" or, of the void, \"sealed\". The void outside "
    "the\n"
    "root joins all void on the border. Components are numbered by their first leaf in Morton order.";

void add_measure_command(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("measure", "Print moments, areas and topology of an octree");
    const auto input = std::make_shared<std::string>();
    command->add_option("X", *input, "Octree file")->required()->type_name("");
    command->footer(measure_footer);
    command->callback([input, &console] { run_measure(*input, console.out); });
}

void add_components_command(CLI::App& app, const Console& console) {
    CLI::App* command =
        app.add_subcommand("components", "List the connected pieces or cavities of an octree");
    const auto options = std::make_shared<ComponentOptions>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    add_choice<bool>(*command, "--of", options->empty, "solid (default) or void",
                     {{"solid", false}, {"void", true}})
        ->type_name("WHAT");
    CLI::Option* inner = command->add_flag("--inner", "Boundary leaves are void (default)");
    command->add_flag("--outer", options->outer, "Boundary leaves are solid")->excludes(inner);
    CLI::Option* connectivity =
        add_choice<Connectivity>(
            *command, "--connectivity", options->connectivity,
            "Neighbours of a cell: 6, 18 or 26 (default: 26, of the void 6)",
            {{"6", Connectivity::faces}, {"18", Connectivity::edges}, {"26", Connectivity::corners}})
            ->type_name("N");
    command->footer(components_footer);
    command->callback([options, connectivity, &console] {
        if (options->empty && connectivity->count() == 0) options->connectivity = Connectivity::faces;
        run_components(*options, console.out);
    });
}

} // namespace

void add_measure(CLI::App& app, const Console& console) {
    add_measure_command(app, console);
    add_components_command(app, console);
}

} // namespace osem::host
