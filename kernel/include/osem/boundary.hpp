// From an octree back to a boundary representation: the closed, oriented surface of its solid.
#ifndef OSEM_BOUNDARY_HPP
#define OSEM_BOUNDARY_HPP

#include <cstdint>

#include "osem/octree.hpp"
#include "osem/solid.hpp"

namespace osem {

struct LinkCycle;

/// Which leaves are the solid; what lies outside the root octant is empty.
enum class SolidPart : std::uint8_t {
    inner, ///< the black leaves
    outer, ///< the black and the boundary leaves
};

/// Exact sizes of a surface.
struct BoundarySizes {
    std::uint32_t vertices;
    std::uint32_t corners;
    std::uint32_t rings; ///< 0 after a counting pass, which cannot know
    std::uint32_t faces; ///< 0 after a counting pass
};

/// One corner of a ring: an entry of the scratch, 28 bytes. What is in it is the job's business.
struct BoundaryCorner {
    Point at;
    std::uint32_t vertex;
    std::uint32_t next;  ///< the ring's next corner
    std::uint32_t ring;  ///< the corner that stands for the ring; of that corner itself: the next hole
    std::uint8_t facing; ///< 2 * axis of the normal + 1 if it points to the positive side
    std::uint8_t in;     ///< the way into the corner, in quarter turns from the plane's first axis
    std::uint8_t out;    ///< the way out of it
    std::uint8_t role;   ///< whether it stands for a ring, and of which kind
};
static_assert(sizeof(BoundaryCorner) == 28, "corners of a surface are packed");

/// Entries of scratch that a surface takes: one a corner. What `corners` is, a counting pass says.
constexpr std::uint32_t boundary_scratch(std::uint32_t corners) { return corners; }

/// Takes a surface piece by piece: first every vertex in ascending order of its index; then face by face and
/// ring by ring the corners, each as a vertex index. A face's outer ring is its first. Each returns false to
/// refuse; `context` is the caller's.
struct BoundarySink {
    bool (*vertex)(void* context, const Point& point);
    bool (*corner)(void* context, std::uint32_t vertex);
    bool (*end_ring)(void* context);
    bool (*end_face)(void* context);
    void* context;
};

/// Outcome of a pass. `double_edges` counts cut edges of length 1 that could not be given a vertex of their
/// own, possible at depth 20 only: see Boundary. With 0 no two edges of the surface join the same vertices.
struct BoundaryOutcome {
    Status status;
    BoundarySizes sizes;
    std::uint32_t scratch_missing; ///< with scratch_too_small: the entries that were missing; else 0
    std::uint32_t double_edges;
};

/// The surface of a tree's solid in progress. A counting pass is begin without scratch, step until done,
/// finish. The surface is begin, step until done, finish, which says the exact sizes; then emit, step until
/// done and finish once more. All state but the scratch is in the job.
///
/// A face is a maximal connected piece of one plane with one side, its squares joined along edges; it is one
/// outer ring (counter-clockwise from outside) and its holes. The rings of a face share no point; a ring may
/// pass through a point twice but never crosses itself. A ring's corners are the vertices on it: the points
/// at which three or more edges of the surface meet. So both faces of an edge are divided at the same
/// points, and check accepts the surface.
///
/// The surface is a 2-manifold: the solid counts as cut where two of its cubes have only an edge or a corner
/// in common. Of the four faces at such an edge the two of one cube belong together; a point has as many
/// vertices as the surface has sheets there, with equal coordinates and different indices, so the faces
/// around a vertex form one cycle. Where the two copies of a cut edge join the same two vertices, one of them
/// gets a vertex of its own within the edge; only an edge of length 1 has no lattice point for it.
///
/// Converting the surface at the tree's depth with conservative leaves gives the tree back, its boundary
/// leaves white (inner) or black (outer), for the faces lie between leaves and meet no open leaf.
///
/// Cost: s solid leaves are visited once a pass (counting, building, emission) with up to 64 descents each;
/// then O(c log c) for c corners, and for every hole a search among the corners of its plane.
class Boundary {
  public:
    /// Starts. The tree's pool and the scratch must be there until the last finish. A null scratch makes a
    /// counting pass.
    void begin(const Octree& tree, SolidPart part, BoundaryCorner* scratch, std::uint32_t scratch_size);

    /// Does up to `units` pieces of work; false when none is left. A piece is a solid leaf, a step of a sort,
    /// a ring to be followed, a hole to be placed, or a face to be emitted.
    bool step(std::uint32_t units);

    /// What has been done: of a surface the sizes, of an emission that all of it was taken. Status: ok;
    /// scratch_too_small (of the sizes only vertices and corners are known then); sink_refused; unfinished
    /// when step had not said that nothing is left.
    BoundaryOutcome finish() const;

    /// Starts to emit the surface, then to be stepped and finished. It may be emitted as often as wanted.
    /// Status: ok; unfinished when there is no surface: only counted, the scratch too small, or work left.
    Status emit(const BoundarySink& sink);

    /// How far the present walk over the leaves is, as a part of root_volume; root_volume once it is over.
    std::uint64_t walked_volume() const;

  private:
    /// In the order of work: up to ready the surface's, from there an emission's.
    enum class Phase : std::uint8_t { idle, gather, sort_out, sort_in, trace, nest, ready, vertices, faces };

    /// Walks the solid leaves, and finds the leaf of any cell from the ancestor that the two share.
    class Walk {
      public:
        void begin(const Octree& tree, SolidPart part);
        bool next(Octant& leaf);
        /// The side of the solid leaf that holds the cell with minimum corner p, 0 where there is none.
        std::int32_t solid_side(const Point& p) const;
        std::uint64_t volume() const;

      private:
        struct Frame {
            Node node;
            std::uint8_t child; ///< the next child
        };
        bool is_solid(Colour colour) const;
        const NodePool* pool_ = nullptr;
        Octant octant_ = root_octant;
        int level_ = 0;
        SolidPart part_ = SolidPart::inner;
        Frame frames_[max_depth] = {};
    };

    bool work();
    bool piece();
    Phase successor() const;
    bool gather();
    bool sort();
    bool trace();
    bool nest();
    bool emit_vertices();
    bool emit_face();
    bool emit_rings(std::uint32_t outer);
    void enter(Phase phase);
    bool is_storing() const { return corners_ != nullptr && sizes_.corners <= capacity_; }

    void visit_leaf(const Octant& leaf);
    void visit_point(const Point& at, std::uint8_t solid);
    void take_cycle(const Point& at, const LinkCycle& cycle);
    void divide_edge(const Point& at, const LinkCycle& cycle, unsigned crease);
    bool is_cut(const Point& at, unsigned axis, unsigned cell) const;
    void add_vertex(const Point& at);
    void add_corner(const Point& at, std::uint8_t facing, unsigned in, unsigned out);

    Octree tree_ = {};
    BoundaryCorner* corners_ = nullptr;
    std::uint32_t capacity_ = 0;
    BoundarySizes sizes_ = {};
    std::uint32_t double_edges_ = 0;
    std::uint32_t position_ = 0; ///< where the phase is in the corners
    std::uint32_t heap_end_ = 0;
    BoundarySink sink_ = {};
    SolidPart part_ = SolidPart::inner;
    Phase phase_ = Phase::idle;
    Status emission_ = Status::ok;
    Walk walk_;
};

/// Arrays for a surface, of at least `vertices`, `corners`, `rings` + 1 and `faces` + 1 entries by its sizes.
struct BoundaryArrays {
    Point* vertices;
    std::uint32_t* corners;
    std::uint32_t* ring_starts;
    std::uint32_t* face_rings;
};

/// Emits a finished surface into arrays, and gives the solid over them. Precondition: `job` has finished a
/// surface with ok. Cost: that of an emission.
Solid boundary_solid(Boundary& job, const BoundaryArrays& arrays);

} // namespace osem

#endif
