// osem csg: an expression over mesh files and octree files to an octree file, in one walk.
#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/expression.hpp"
#include "commands/output_option.hpp"
#include "commands/solid_input.hpp"
#include "console/progress.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "mesh/read_mesh.hpp"
#include "osem/csg.hpp"

namespace osem::host {

namespace {

struct CsgArguments {
    std::string expression;
    std::vector<std::string> bindings;
    std::string output;
    SolidOptions solid;
    std::optional<int> depth;
    std::optional<LeafRule> leaves;
    bool stats = false;
};

// An octree file as an operand, read where it lies.
struct TreeOperand {
    explicit TreeOperand(const std::string& path) : file(path), stream(file.source()) {}
    TreeFile file;
    CsgStream stream;
};

// A mesh file as an operand.
struct MeshOperand {
    explicit MeshOperand(const std::string& file) : path(file), mesh(read_mesh(file)) {}

    void put_into(const WorldCube& cube, const SolidOptions& options) {
        solid = solid_in(cube, path, mesh);
        mesh = Mesh();
        const CheckedSolid checked = check_solid(path, solid);
        faces.resize(convert_scratch(checked.view()));
        operand.emplace(checked, winding_rule(options, solid), faces.data(),
                        static_cast<std::uint32_t>(faces.size()));
    }

    std::string path;
    Mesh mesh;
    IntegerSolid solid;
    std::vector<std::uint32_t> faces;
    std::optional<CsgSolid> operand;
};

// One of the two.
struct Operand {
    std::unique_ptr<TreeOperand> tree;
    std::unique_ptr<MeshOperand> mesh;
};

// NAME=FILE.
struct Binding {
    std::string name;
    std::string path;
};

Binding binding_of(const std::string& text) {
    const std::size_t equals = text.find('=');
    Binding binding = {text.substr(0, equals), equals == std::string::npos ? "" : text.substr(equals + 1)};
    if (!is_operand_name(binding.name) || binding.path.empty()) {
        throw CLI::ValidationError("NAME=FILE", "expected a name, = and a file, not " + text);
    }
    return binding;
}

std::vector<Binding> bindings_of(const CsgArguments& options) {
    std::vector<Binding> bindings;
    for (const std::string& text : options.bindings) {
        const Binding binding = binding_of(text);
        for (const Binding& other : bindings) {
            if (other.name == binding.name) {
                throw CLI::ValidationError("NAME=FILE", binding.name + " is given twice");
            }
        }
        bindings.push_back(binding);
    }
    if (bindings.size() > csg_most_operands) {
        throw CLI::ValidationError("NAME=FILE", "at most " + std::to_string(csg_most_operands) + " files");
    }
    return bindings;
}

std::vector<CsgToken> tokens_of(const CsgArguments& options, const std::vector<Binding>& bindings) {
    std::vector<std::string> names;
    names.reserve(bindings.size());
    for (const Binding& binding : bindings) names.push_back(binding.name);
    try {
        return parse_expression(options.expression, names);
    } catch (const ExpressionFault& fault) {
        throw CLI::ValidationError("EXPR", fault.what());
    }
}

std::vector<Operand> open_operands(const std::vector<Binding>& bindings, const std::string& output) {
    std::vector<Operand> operands;
    for (const auto& [name, path] : bindings) {
        Operand operand;
        if (is_tree_name(path)) {
            operand.tree = std::make_unique<TreeOperand>(path);
        } else {
            refuse_same_file("--output", output, "the input", path);
            operand.mesh = std::make_unique<MeshOperand>(path);
        }
        operands.push_back(std::move(operand));
    }
    return operands;
}

void require_same_cube(const TreeFile& file, const WorldCube& cube) {
    if (same_cube(file.facts().cube, cube)) return;
    throw BadInput("the frames differ: " + file.path() + " covers " + frame_text(file.facts().cube) +
                   ", not " + frame_text(cube));
}

// The cube asked for, that of the octree files, or the default for all meshes together.
WorldCube cube_for(const std::vector<Operand>& operands, const SolidOptions& options) {
    std::optional<WorldCube> cube = parse_frame(options.frame);
    Mesh all;
    for (const Operand& operand : operands) {
        if (operand.tree) {
            if (!cube) cube = operand.tree->file.facts().cube;
            require_same_cube(operand.tree->file, *cube);
            continue;
        }
        const Mesh& mesh = operand.mesh->mesh;
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const std::uint32_t corner : mesh.corners) all.corners.push_back(first + corner);
    }
    return cube ? *cube : default_cube(all);
}

CsgOptions options_for(const std::vector<Operand>& operands, const CsgArguments& options) {
    CsgOptions csg;
    std::optional<LeafRule> leaves = options.leaves;
    int greatest = 0;
    for (const Operand& operand : operands) {
        if (!operand.tree) continue;
        const TreeFile& file = operand.tree->file;
        greatest = std::max(greatest, file.depth());
        if (!leaves) leaves = file.facts().leaves;
        if (*leaves != file.facts().leaves) {
            throw BadInput(file.path() + " has " + leaf_rule_name(file.facts().leaves) + " leaves, not " +
                           leaf_rule_name(*leaves) + " ones");
        }
        if (options.depth && *options.depth < file.depth()) {
            throw BadInput(file.path() + " has a depth of " + std::to_string(file.depth()) +
                           "; --depth may not be less");
        }
    }
    csg.depth = options.depth.value_or(greatest != 0 ? greatest : CsgOptions().depth);
    csg.leaves = leaves.value_or(LeafRule::conservative);
    if (csg.leaves == LeafRule::centre && csg.depth == max_depth) {
        throw CLI::ValidationError("--depth", "centre leaves end at depth 19");
    }
    return csg;
}

std::string expression_limits() {
    return "at most " + std::to_string(csg_most_operands) + " names, " + std::to_string(csg_most_tokens) +
           " names and operators, and " + std::to_string(csg_most_repeated) +
           " names that stand twice or more";
}

[[noreturn]] void refuse(const CsgFault& fault, const std::vector<Operand>& operands) {
    if (fault.status == Status::expression_too_large) {
        throw CLI::ValidationError("EXPR", "too large: " + expression_limits());
    }
    const bool of_tree = fault.operand < operands.size() && operands[fault.operand].tree;
    if (of_tree) operands[fault.operand].tree->file.refuse(fault.status, fault.offset);
    throw BadInput(describe(fault.status));
}

TreeOutcome run_pass(CsgConversion& job, const std::vector<CsgToken>& tokens,
                     const std::vector<Operand>& operands, const CsgOptions& options, NodePool* pool,
                     Progress& progress) {
    std::vector<CsgOperand> views;
    views.reserve(operands.size());
    for (const Operand& operand : operands) {
        views.push_back(operand.tree ? CsgOperand(operand.tree->stream) : CsgOperand(*operand.mesh->operand));
    }
    const CsgFault begun = job.begin(tokens.data(), static_cast<std::uint32_t>(tokens.size()), views.data(),
                                     static_cast<std::uint32_t>(views.size()), options, pool);
    if (begun.status != Status::ok) refuse(begun, operands);
    drive(job, progress, pool == nullptr ? 0 : 1, 2);
    const CsgOutcome outcome = job.finish();
    if (outcome.built.status != Status::ok) refuse(outcome.fault, operands);
    return outcome.built;
}

void print_stats(std::ostream& out, const CsgConversion& job, const Octree& tree,
                 const std::vector<Operand>& operands) {
    std::uint64_t faces = 0;
    for (const Operand& operand : operands) faces += operand.mesh ? operand.mesh->faces.size() : 0;
    out << "octants " << job.octants_visited() << '\n'
        << "nodes " << measure(tree).nodes << '\n'
        << "face_list_bytes " << faces * sizeof(std::uint32_t) << '\n';
}

void run_csg(const CsgArguments& options, const Console& console) {
    const std::vector<Binding> bindings = bindings_of(options);
    const std::vector<CsgToken> tokens = tokens_of(options, bindings);
    OutputFile::probe(options.output);
    const std::vector<Operand> operands = open_operands(bindings, options.output);
    const WorldCube cube = cube_for(operands, options.solid);
    const CsgOptions csg = options_for(operands, options);
    for (const Operand& operand : operands) {
        if (operand.mesh) operand.mesh->put_into(cube, options.solid);
    }

    // Twice: the first pass only counts the nodes, so that the second has exactly the memory it needs.
    const auto job = std::make_unique<CsgConversion>();
    std::optional<Progress> progress(std::in_place, console, "converting");
    const TreeOutcome counted = run_pass(*job, tokens, operands, csg, nullptr, *progress);
    HostPool pool(counted.nodes_needed);
    const TreeOutcome result = run_pass(*job, tokens, operands, csg, &pool.pool(), *progress);
    progress.reset();

    OutputFile output(options.output);
    write_tree(output, result.tree, {cube, csg.leaves});
    if (options.stats) print_stats(console.out, *job, result.tree, operands);
    finish_printing(console);
    output.commit();
}

} // namespace

void add_csg(CLI::App& app, const Console& console) {
    CLI::App* command =
        app.add_subcommand("csg", "Convert an expression over solids and octrees in one walk");
    const auto options = std::make_shared<CsgArguments>();
    command->add_option("EXPR", options->expression, "Expression over the names")->required()->type_name("");
    command
        ->add_option(
            "NAME=FILE", options->bindings,
            "What a name stands for: a mesh file (.off, .stl, .obj, .poly) or an octree file (.osem)")
        ->required()
        ->type_name("");
    add_tree_output(*command, "-o,--output", options->output, "Octree file to write")
        ->required()
        ->type_name("OUT.osem");
    command
        ->add_option(
            "--depth", options->depth,
            "Depth of the tree, 1 to 20 (19 with centre). Default: the greatest of the octree files, "
            "or 8")
        ->check(CLI::Range(1, max_depth).description(""))
        ->type_name("N");
    add_choice<LeafRule>(*command, "--leaves", options->leaves,
                         "Leaves of the meshes: conservative or centre. Default: as the octree files, or "
                         "conservative",
                         {{"conservative", LeafRule::conservative}, {"centre", LeafRule::centre}})
        ->type_name("RULE");
    add_solid_options(*command, options->solid);
    command->add_flag("--stats", options->stats, "Print octants visited, nodes and the face lists' bytes");
    command->footer(
        std::string(expression_help) +
        "\nNothing is converted by itself: an octant in which the expression is decided is not\n"
        "entered. A name that stands twice is one operand, so a - a is empty. Octree files are read\n"
        "where they lie. Without octree files or --frame the default cube is that of all meshes.\n"
        "An expression has " +
        expression_limits() + ".");
    command->callback([options, &console] { run_csg(*options, console); });
}

} // namespace osem::host
