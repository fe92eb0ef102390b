#include "mesh/orient.hpp"

#include <algorithm>
#include <map>

#include "mesh/coordinates.hpp"
#include "mesh/edge_uses.hpp"
#include "mesh/shell_test.hpp"
#include "mesh/volume.hpp"

namespace osem::host {

namespace {

constexpr std::uint32_t none = UINT32_MAX;

// Faces joined by edges that exactly two faces share, turned alike.
struct Shell {
    std::vector<std::uint32_t> faces;
    Point low{{root_side, root_side, root_side}};
    Point high{{0, 0, 0}};
    bool inside_out = false;
    bool in_cavity = false; ///< inside an odd number of other shells
};

class Orienter {
  public:
    explicit Orienter(IntegerSolid& solid)
        : solid_(solid), view_(solid.view()), face_of_(faces_of_corners(solid)),
          uses_(edge_uses(solid, view_.vertex_count, next_corners(solid))), shell_of_(view_.face_count, none),
          turned_(view_.face_count, false) {}

    void operator()() {
        pair_up();
        for (std::uint32_t face = 0; face < view_.face_count; ++face) {
            if (shell_of_[face] == none) collect_shell(face);
        }
        for_each_edge(uses_, [this](const EdgeUse* first, const EdgeUse* end) { check_closed(first, end); });
        for (Shell& shell : shells_) measure(shell);
        for (Shell& shell : shells_) nest(shell);
        turn_faces();
    }

  private:
    std::string name(const EdgeUse& use) const {
        return "edge " + to_text(solid_.file_coordinates[use.low]) + " - " +
               to_text(solid_.file_coordinates[use.high]);
    }

    // Whether the edge runs from its lower vertex to its higher, as its face is turned now.
    bool runs_up(const EdgeUse& use) const {
        return (solid_.corners[use.corner] == use.low) != turned_[face_of_[use.corner]];
    }

    void pair_up() {
        partner_.assign(solid_.corners.size(), nullptr);
        for_each_edge(uses_, [this](const EdgeUse* first, const EdgeUse* end) {
            if (end - first != 2) return;
            partner_[first->corner] = first + 1;
            partner_[first[1].corner] = first;
        });
    }

    // Spreads over edges with two faces; these must use the edge in opposite directions.
    void collect_shell(std::uint32_t start) {
        const auto number = static_cast<std::uint32_t>(shells_.size());
        shells_.emplace_back();
        std::vector<std::uint32_t>& faces = shells_.back().faces;
        shell_of_[start] = number;
        faces.push_back(start);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const std::uint32_t face = faces[i];
            const std::uint32_t end = view_.first_corner(view_.end_ring(face));
            for (std::uint32_t corner = view_.first_corner(view_.first_ring(face)); corner < end; ++corner) {
                if (partner_[corner] == nullptr) continue;
                const EdgeUse& theirs = *partner_[corner];
                const EdgeUse& ours = *partner_[theirs.corner];
                const std::uint32_t other = face_of_[theirs.corner];
                if (shell_of_[other] == none) {
                    shell_of_[other] = number;
                    faces.push_back(other);
                    turned_[other] = runs_up(theirs) == runs_up(ours);
                } else if (runs_up(theirs) == runs_up(ours)) {
                    throw BadInput("the surface has one side only: its facets cannot be turned alike at " +
                                   name(ours));
                }
            }
        }
    }

    // Every shell must be closed on its own, also where it meets others along an edge.
    void check_closed(const EdgeUse* first, const EdgeUse* end) const {
        if (end - first == 2) return;
        if (end - first == 1) {
            throw BadInput("the surface is not closed: only one facet has " + name(*first));
        }
        std::map<std::uint32_t, std::int64_t> balance;
        for (const EdgeUse* use = first; use != end; ++use) {
            balance[shell_of_[face_of_[use->corner]]] += runs_up(*use) ? 1 : -1;
        }
        for (const auto& [shell, sum] : balance) {
            if (sum == 0) continue;
            throw BadInput("which facets belong together cannot be told at " + name(*first) + ", shared by " +
                           std::to_string(end - first) +
                           " of them; facets inside the solid do not belong to its "
                           "surface");
        }
    }

    void measure(Shell& shell) const {
        WideSum front;
        WideSum back;
        for (const std::uint32_t face : shell.faces) {
            add_volume6(turned_[face] ? back : front, view_, face);
            const std::uint32_t end = view_.first_corner(view_.end_ring(face));
            for (std::uint32_t corner = view_.first_corner(view_.first_ring(face)); corner < end; ++corner) {
                const Point& p = view_.vertices[view_.corners[corner]];
                for (int axis = 0; axis < 3; ++axis) {
                    shell.low.at[axis] = std::min(shell.low.at[axis], p.at[axis]);
                    shell.high.at[axis] = std::max(shell.high.at[axis], p.at[axis]);
                }
            }
        }
        shell.inside_out = front < back;
    }

    void nest(Shell& shell) const {
        for (const Shell& other : shells_) {
            if (&other != &shell && box_in_box(shell, other) && lies_inside(shell, other)) {
                shell.in_cavity = !shell.in_cavity;
            }
        }
    }

    static bool box_in_box(const Shell& inner, const Shell& outer) {
        for (int axis = 0; axis < 3; ++axis) {
            if (inner.low.at[axis] < outer.low.at[axis] || inner.high.at[axis] > outer.high.at[axis]) {
                return false;
            }
        }
        return true;
    }

    // Decided by the first corner that is not on the other shell. Shells do not cross, so any one will do.
    bool lies_inside(const Shell& shell, const Shell& other) const {
        for (const std::uint32_t face : shell.faces) {
            const std::uint32_t end = view_.first_corner(view_.end_ring(face));
            for (std::uint32_t corner = view_.first_corner(view_.first_ring(face)); corner < end; ++corner) {
                const Point& p = view_.vertices[view_.corners[corner]];
                const auto touches = [&](std::uint32_t f) { return lies_on(view_, f, p); };
                if (std::any_of(other.faces.begin(), other.faces.end(), touches)) continue;
                return encloses(other, p);
            }
        }
        return lies_inside_by_a_corner_within(shell, other);
    }

    // Whether p, moved by (e, e^2, e^3) for an infinitesimal e > 0, is in what a shell encloses.
    bool encloses(const Shell& shell, const Point& p) const {
        const auto crosses = [&](std::uint32_t f) { return ray_crosses(view_, f, p); };
        return std::count_if(shell.faces.begin(), shell.faces.end(), crosses) % 2 == 1;
    }

    // Where all corners lie on the other shell, a corner from which that small step leads into the shell
    // tells. All of the shell's inside is on one side of the other, unless that one is inside it.
    bool lies_inside_by_a_corner_within(const Shell& shell, const Shell& other) const {
        if (!box_in_box(other, shell)) {
            for (const std::uint32_t face : shell.faces) {
                const std::uint32_t end = view_.first_corner(view_.end_ring(face));
                for (std::uint32_t corner = view_.first_corner(view_.first_ring(face)); corner < end;
                     ++corner) {
                    const Point& p = view_.vertices[view_.corners[corner]];
                    if (encloses(shell, p)) return encloses(other, p);
                }
            }
        }
        const std::uint32_t corner = view_.first_corner(view_.first_ring(shell.faces[0]));
        throw BadInput("all corners of the shell at " +
                       to_text(solid_.file_coordinates[view_.corners[corner]]) +
                       " lie on another shell, so which of the two is inside cannot be told");
    }

    void turn_faces() {
        for (const Shell& shell : shells_) {
            for (const std::uint32_t face : shell.faces) {
                if (turned_[face] == (shell.inside_out != shell.in_cavity)) continue;
                ++solid_.reoriented_faces;
                for (std::uint32_t r = view_.first_ring(face); r < view_.end_ring(face); ++r) {
                    std::reverse(solid_.corners.data() + view_.first_corner(r),
                                 solid_.corners.data() + view_.first_corner(r + 1));
                }
            }
        }
    }

    IntegerSolid& solid_;
    Solid view_;
    std::vector<std::uint32_t> face_of_;
    std::vector<EdgeUse> uses_;
    std::vector<const EdgeUse*> partner_; ///< the other use of a corner's edge, where there are just two
    std::vector<std::uint32_t> shell_of_;
    std::vector<bool> turned_; ///< faces to be read backwards to fit the first of their shell
    std::vector<Shell> shells_;
};

} // namespace

void orient_even_odd(IntegerSolid& solid) { Orienter{solid}(); }

} // namespace osem::host
