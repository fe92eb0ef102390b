// osem info: what an octree file holds.
#include <memory>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "files/decimal.hpp"
#include "files/tree_file.hpp"
#include "measure/mass.hpp"
#include "osem/stream_query.hpp"

namespace osem::host {

namespace {

std::string hexadecimal(std::uint64_t value) {
    std::string text(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) text[i] = "0123456789abcdef"[value & 15U];
    return text;
}

void run_info(const std::string& input, std::ostream& out) {
    TreeFile file(input);
    const StreamMeasures measured = measure(file.source());
    if (measured.status != Status::ok) file.refuse(measured.status, measured.offset);
    const StreamDigest digested = digest(file.source());
    if (digested.status != Status::ok) file.refuse(digested.status, digested.offset);
    const TreeFacts& facts = file.facts();
    const Measures& m = measured.measures;
    out << "depth " << file.depth() << '\n'
        << "leaf_rule " << leaf_rule_name(facts.leaves) << '\n'
        << "frame " << frame_text(facts.cube) << '\n'
        << "nodes " << m.nodes << '\n'
        << "white " << m.white_leaves << '\n'
        << "black " << m.black_leaves << '\n'
        << "boundary " << m.boundary_leaves << '\n'
        << "volume_inner " << m.inner_volume << '\n'
        << "volume_outer " << m.outer_volume << '\n'
        << "volume_inner_world " << decimal(world_volume(m.inner_volume, facts.cube)) << '\n'
        << "volume_outer_world " << decimal(world_volume(m.outer_volume, facts.cube)) << '\n'
        << "digest " << hexadecimal(digested.digest) << '\n';
}

constexpr const char* info_footer =
    "Prints one \"key value\" line each: depth; leaf_rule; frame X,Y,Z,SIDE; nodes; the leaves white, black\n"
    "and boundary; volume_inner (black leaves) and volume_outer (black and boundary leaves) in lattice "
    "cells,\n"
    "2^60 of which fill the root, and _world in cubed world units; digest of the structure.\n"
    "leaf_rule is that of the conversion the octree comes from: conservative, black and white hold in the\n"
    "whole leaf; or centre, they hold at the centres of cells of the conversion's depth. Other commands "
    "keep\n"
    "it. Boundary leaves of a centre octree come from coarsening: octants of several colours. Coarsening by\n"
    "inner, outer or majority leaves no boundary, and only what its mode says holds then.";

} // namespace

void add_info(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("info", "Print depth, counts, volumes and digest of an octree");
    const auto input = std::make_shared<std::string>();
    command->add_option("X", *input, "Octree file")->required()->type_name("");
    command->footer(info_footer);
    command->callback([input, &console] { run_info(*input, console.out); });
}

} // namespace osem::host
