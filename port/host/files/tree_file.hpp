// Octrees in files: the kernel's stream, its frame words being the bits of the world cube.
#ifndef OSEM_HOST_TREE_FILE_HPP
#define OSEM_HOST_TREE_FILE_HPP

#include <cstdint>
#include <fstream>
#include <string>

#include "mesh/quantize.hpp"
#include "osem/convert.hpp"
#include "osem/octree.hpp"
#include "osem/status.hpp"
#include "osem/stream.hpp"

namespace osem::host {

class OutputFile;

/// What a tree file says beside the tree.
struct TreeFacts {
    WorldCube cube;
    LeafRule leaves;
};

/// An .osem file open for reading. The constructor reads the header only and refuses a file whose size is
/// not what its node count asks for, so that nothing is allocated on a damaged file's word. Faults are
/// thrown as BadInput with the file's name and, for damage, the offset of the byte.
class TreeFile {
  public:
    explicit TreeFile(const std::string& path);

    const std::string& path() const { return path_; }
    const TreeFacts& facts() const { return facts_; }
    int depth() const { return depth_; }
    /// Nodes of the tree, 0 when its root is a leaf; a pool with room for as many can hold it.
    std::uint32_t nodes() const { return nodes_; }

    /// Reads the tree into `pool`.
    Octree read(NodePool& pool);

    /// The file as the kernel reads it where it lies; stays with this object.
    Source source();

    /// Throws what a fault of the kernel's means for this file.
    [[noreturn]] void refuse(Status status, std::uint64_t offset) const;

  private:
    static bool read_at(void* context, std::uint64_t offset, std::uint8_t* bytes, std::size_t count);
    void read_header(std::uint64_t size);
    [[noreturn]] void damaged(const char* what, std::uint64_t offset) const;

    std::string path_;
    std::ifstream stream_;
    TreeFacts facts_ = {};
    std::uint32_t nodes_ = 0;
    int depth_ = 0;
};

/// Whether a file's name ends as those of octree files do, in letters of either case.
bool is_tree_name(const std::string& path);

/// Takes the bytes of a stream with which the file begins, its header last if the file is a regular one; a
/// refusal is the file's own fault state, which commit() reports.
Sink sink_of(OutputFile& file);

/// Writes a tree into an output file (without commit).
void write_tree(OutputFile& file, const Octree& tree, const TreeFacts& facts);

/// "conservative" or "centre".
const char* leaf_rule_name(LeafRule rule);

/// Whether two cubes are the same bit for bit.
bool same_cube(const WorldCube& a, const WorldCube& b);

} // namespace osem::host

#endif
