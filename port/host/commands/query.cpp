// osem query: questions to an octree file, one a command line.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/world_point.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "osem/nearest.hpp"
#include "osem/neighbour.hpp"
#include "osem/query.hpp"
#include "osem/ray.hpp"

namespace osem::host {

namespace {

struct Question {
    std::string input;
    Coordinates at = {};
    Coordinates direction = {};
    Coordinates to = {};
    bool has_to = false;
    bool all = false;
    double box[6] = {};
    double within = std::numeric_limits<double>::infinity();
    std::uint8_t colours = solid_colours;
};

/// The tree asked and where it lies.
struct Asked {
    Octree tree;
    WorldCube cube;
    std::ostream& out;
};

const char* yes_or_no(bool yes) { return yes ? "yes" : "no"; }

[[noreturn]] void refuse_outside(const std::string& what, const WorldCube& cube) {
    throw BadInput(what + " outside the root cube, which is " + frame_text(cube) + " (X,Y,Z,SIDE)");
}

void ask_point(const Asked& asked, const Question& question) {
    const Point cell = on_lattice(question.at, asked.cube, Rounding::down);
    const PointOutcome found = leaf_at(asked.tree, cell);
    if (found.status == Status::point_off_root) {
        refuse_outside("the point " + decimals(question.at.data(), 3) + " lies", asked.cube);
    }
    require_ok(found.status);
    asked.out << "cell " << point_text(cell) << '\n'
              << "colour " << colour_name(found.leaf.colour) << '\n'
              << "leaf " << leaf_text(found.leaf) << '\n'
              << "visited " << found.visited << '\n';
}

bool is_in_root(const CellBox& box) {
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        inside = inside && box.low.at[axis] >= 0 && box.high.at[axis] <= root_side;
    }
    return inside;
}

void ask_box(const Asked& asked, const Question& question) {
    const double* bounds = question.box;
    const CellBox box = {on_lattice({bounds[0], bounds[1], bounds[2]}, asked.cube, Rounding::down),
                         on_lattice({bounds[3], bounds[4], bounds[5]}, asked.cube, Rounding::up)};
    const std::string text = "the box " + decimals(bounds, 6);
    if (!is_in_root(box)) refuse_outside(text + " reaches", asked.cube);
    const BoxOutcome found = colours_in(asked.tree, box);
    if (found.status == Status::box_empty) {
        throw BadInput(text +
                       " holds no cell: each of its first three numbers must be below the one three behind");
    }
    require_ok(found.status);
    asked.out << "low " << point_text(box.low) << '\n'
              << "high " << point_text(box.high) << '\n'
              << "white " << yes_or_no(found.holds(Colour::white)) << '\n'
              << "boundary " << yes_or_no(found.holds(Colour::boundary)) << '\n'
              << "black " << yes_or_no(found.holds(Colour::black)) << '\n'
              << "mixed " << yes_or_no(found.mixed()) << '\n'
              << "touches " << yes_or_no(found.touches) << '\n'
              << "clear " << yes_or_no(found.clear()) << '\n'
              << "visited " << found.visited << '\n';
}

constexpr double longest_direction = 134217728; // 2^27

// A direction on the lattice: the longest component becomes 2^27 cells.
Point lattice_direction(const Coordinates& direction) {
    double longest = 0;
    for (const double component : direction) longest = std::max(longest, std::abs(component));
    if (longest == 0) throw CLI::ValidationError("ray", "the direction is 0,0,0");
    Point rounded = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        rounded.at[axis] =
            static_cast<std::int32_t>(std::floor(direction[axis] / longest * longest_direction + 0.5));
    }
    return rounded;
}

Segment segment_of(const Question& question, const WorldCube& cube) {
    const Point from = on_lattice(question.at, cube, Rounding::nearest);
    if (question.has_to) return {from, on_lattice(question.to, cube, Rounding::nearest)};
    for (const std::int32_t coordinate : from.at) {
        if (std::abs(coordinate) > segment_reach / 2) throw BadInput("the ray begins too far from the root");
    }
    return ray(from, lattice_direction(question.direction));
}

std::string parameter_text(const Parameter& parameter) {
    return std::to_string(parameter.numerator) + '/' + std::to_string(parameter.denominator);
}

// The world point at a parameter, as near as binary64 gets.
std::string world_text(const Segment& segment, const Parameter& at, const WorldCube& cube) {
    Coordinates world = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double length = double{1} * segment.to.at[axis] - segment.from.at[axis];
        const double lattice = segment.from.at[axis] + length * at.numerator / at.denominator;
        world[axis] = cube.origin[axis] + lattice * cube.unit();
    }
    return decimals(world.data(), world.size());
}

std::string crossing_text(const Crossing& crossing, const Segment& segment, const WorldCube& cube) {
    return parameter_text(crossing.at) + ' ' + world_text(segment, crossing.at, cube) + ' ' +
           "xyz"[crossing.axis] + ' ' + colour_name(crossing.before) + ' ' + colour_name(crossing.after);
}

void print_first_hit(const Asked& asked, const Segment& segment) {
    const HitOutcome found = first_hit(asked.tree, segment);
    require_ok(found.status);
    asked.out << "hit " << yes_or_no(found.hit) << '\n';
    if (found.hit) {
        const Passage& passage = found.passage;
        asked.out << "t " << parameter_text(passage.entry) << '\n'
                  << "at " << world_text(segment, passage.entry, asked.cube) << '\n'
                  << "face " << (passage.begins ? "none" : std::string(1, "xyz"[passage.entered_axis]))
                  << '\n'
                  << "leaf " << leaf_text(passage.leaf) << '\n';
    }
    asked.out << "visited " << found.visited << '\n';
}

void ask_ray(const Asked& asked, const Question& question) {
    const Segment segment = segment_of(question, asked.cube);
    asked.out << "from " << point_text(segment.from) << '\n' << "to " << point_text(segment.to) << '\n';
    if (!question.all) return print_first_hit(asked, segment);
    SegmentWalk walk(asked.tree, segment);
    require_ok(walk.status());
    Crossing crossing = {};
    std::size_t count = 0;
    for (; walk.next_crossing(crossing); ++count) {
        asked.out << "crossing " << crossing_text(crossing, segment, asked.cube) << '\n';
    }
    asked.out << "crossings " << count << '\n' << "visited " << walk.visited() << '\n';
}

void ask_neighbour(const Asked& asked, const Question& question) {
    const PointOutcome leaf = leaf_at(asked.tree, on_lattice(question.at, asked.cube, Rounding::down));
    require_ok(leaf.status);
    asked.out << "leaf " << leaf_text(leaf.leaf) << '\n';
    std::uint32_t visited = leaf.visited;
    for (unsigned side = 0; side < 6; ++side) {
        const OctantFace face = {static_cast<Axis>(side / 2), side % 2 != 0};
        const std::string name = {"xyz"[face.axis], face.high ? '+' : '-'};
        const NeighbourOutcome found = face_neighbour(asked.tree, leaf.leaf.octant, face);
        asked.out << name << ' ' << (found.outside ? "outside" : leaf_text({found.octant, found.colour}))
                  << '\n';
        visited += found.visited;
        if (found.colour != Colour::grey || !question.all) continue;
        NeighbourWalk walk(asked.tree, leaf.leaf.octant, face);
        Leaf beyond = {};
        while (walk.next(beyond)) asked.out << name << "leaf " << leaf_text(beyond) << '\n';
        visited += walk.visited();
    }
    asked.out << "visited " << visited << '\n';
}

// A distance in world units as the greatest squared distance between lattice points that is within it.
std::uint64_t squared_bound(double within, const WorldCube& cube) {
    const double cells = within / cube.unit();
    const double square = std::floor(cells * cells);
    return square < 9e18 ? static_cast<std::uint64_t>(square) : UINT64_MAX; // any distance is below 2^62
}

void ask_nearest(const Asked& asked, const Question& question) {
    const Point from = on_lattice(question.at, asked.cube, Rounding::nearest);
    const NearestOutcome found =
        nearest_leaf(asked.tree, from, question.colours, squared_bound(question.within, asked.cube));
    require_ok(found.status);
    asked.out << "from " << point_text(from) << '\n' << "found " << yes_or_no(found.found) << '\n';
    if (found.found) {
        const double distance = std::sqrt(static_cast<double>(found.distance)) * asked.cube.unit();
        asked.out << "leaf " << leaf_text(found.leaf) << '\n'
                  << "distance_squared " << found.distance << '\n'
                  << "distance_world " << decimal(distance) << '\n';
    }
    asked.out << "visited " << found.visited << '\n';
}

void run(const Question& question, std::ostream& out, void (*ask)(const Asked&, const Question&)) {
    TreeFile file(question.input);
    HostPool pool(file.nodes());
    ask({file.read(pool.pool()), file.facts().cube, out}, question);
}

CLI::App* add_kind(CLI::App& query, const std::string& name, const std::string& help,
                   const std::shared_ptr<Question>& question, const Console& console,
                   void (*ask)(const Asked&, const Question&)) {
    CLI::App* command = query.add_subcommand(name, help);
    command->callback([question, &console, ask] { run(*question, console.out, ask); });
    return command;
}

void add_box(CLI::App& command, Question& question) {
    const auto set = [&question](const std::string& text) {
        static_cast<void>(parse_decimals(text, question.box, 6)); // checked before
    };
    const auto fault = [](const std::string& text) {
        double read[6];
        return parse_decimals(text, read, 6) ? std::string() : "expected X0,Y0,Z0,X1,Y1,Z1";
    };
    command.add_option_function<std::string>("BOX", set, "Two corners")
        ->required()
        ->check(fault)
        ->type_name("X0,Y0,Z0,X1,Y1,Z1");
}

void add_ray(CLI::App& command, const std::shared_ptr<Question>& question) {
    add_coordinates(command, "FROM", question->at, "Where it begins")->required();
    CLI::Option* direction = add_coordinates(command, "DIRECTION", question->direction, "Where it goes");
    CLI::Option* to = add_coordinates(command, "--to", question->to, "Where it ends, instead of a direction");
    command.add_flag("--all", question->all, "Every change of colour, not the first leaf that may be solid");
    command.parse_complete_callback([direction, to, question] {
        question->has_to = to->count() != 0;
        const bool has_direction = direction->count() != 0;
        if (has_direction && question->has_to) {
            throw CLI::ValidationError("ray", "DIRECTION and --to exclude each other");
        }
        if (!has_direction && !question->has_to) {
            throw CLI::ValidationError("ray", "either DIRECTION or --to is required");
        }
    });
}

void add_nearest(CLI::App& command, Question& question) {
    add_coordinates(command, "POINT", question.at, "From where")->required();
    command.add_option("--within", question.within, "Not farther than this, in world units")
        ->check([](const std::string& text) {
            double distance = 0;
            const bool is_distance = parse_decimals(text, &distance, 1) && distance >= 0;
            return is_distance ? std::string() : std::string("expected a number that is not negative");
        })
        ->type_name("D");
    add_choice<std::uint8_t>(command, "--colour", question.colours,
                             "solid (black or boundary; the default), black, boundary or white",
                             {{"solid", solid_colours},
                              {"black", colour_bit(Colour::black)},
                              {"boundary", colour_bit(Colour::boundary)},
                              {"white", colour_bit(Colour::white)}});
}

constexpr const char* query_footer =
    "Coordinates are world coordinates. point and neighbour take the cell that holds the point, box rounds\n"
    "outwards to whole cells, ray and nearest to the nearest lattice point; a direction is rounded to one\n"
    "part in 2^27. Answers are \"key value\" lines in lattice units, 2^20 of which make the root's side; a\n"
    "leaf is \"x y z side colour\". ray: t is the exact fraction of the way from from to to; with --all a\n"
    "line a change of colour: crossing T WORLD_POINT AXIS BEFORE AFTER. neighbour: with --all also the\n"
    "leaves along a face behind which the octant is divided (grey). visited counts nodes.\n"
    "box: white, boundary and black say whether a cell of the box lies in such a leaf; mixed: in leaves of\n"
    "several colours; touches: no cell is black or boundary, but the box shares a face, an edge or a corner\n"
    "with a leaf that is; clear: it is white throughout and touches nothing.";

} // namespace

void add_query(CLI::App& app, const Console& console) {
    CLI::App* query = app.add_subcommand("query", "Ask for colours, hits, neighbours and the nearest leaf");
    const auto question = std::make_shared<Question>();
    query->add_option("X", question->input, "Octree file")->required()->type_name("");
    query->require_subcommand(1);
    query->footer(query_footer);
    const auto add = [&](const char* name, const char* help, void (*ask)(const Asked&, const Question&)) {
        return add_kind(*query, name, help, question, console, ask);
    };
    CLI::App* point = add("point", "The colour and the leaf at a point", ask_point);
    add_coordinates(*point, "POINT", question->at, "Where")->required();
    add_box(*add("box", "The colours in a box, and whether it touches the solid", ask_box), *question);
    add_ray(*add("ray", "What a ray or a segment meets", ask_ray), question);
    CLI::App* neighbour = add("neighbour", "What is beside the leaf at a point", ask_neighbour);
    add_coordinates(*neighbour, "POINT", question->at, "Where")->required();
    neighbour->add_flag("--all", question->all, "Also the leaves along divided neighbours");
    add_nearest(*add("nearest", "The nearest leaf of a colour", ask_nearest), *question);
}

} // namespace osem::host
