#include "support/exact_tree.hpp"

#include <numeric>

namespace osem::fuzz {

namespace {

class Growth {
  public:
    Growth(const ExactSolid& solid, const ConvertOptions& options) : solid_(solid), options_(options) {}

    Colour grow(const Octant& octant, const std::vector<std::size_t>& above) {
        const std::vector<std::size_t> met = solid_.meeting(above, octant);
        if (met.empty()) return colour_at(centre(octant, false));
        if (octant.level == options_.depth) {
            if (options_.leaves == LeafRule::conservative) return Colour::boundary;
            return colour_at(centre(octant, true));
        }
        const std::size_t at = masks.size();
        masks.emplace_back(std::uint8_t{0}, std::uint8_t{0});
        unsigned may = 0;
        unsigned must = 0;
        for (unsigned k = 0; k < 8; ++k) {
            const auto bits = static_cast<unsigned>(grow(octant.child(k), met));
            may |= (bits & 1U) << k;
            must |= (bits >> 1) << k;
        }
        const bool uniform = (may == 0 || may == 0xff) && (must == 0 || must == 0xff) && may >= must;
        if (uniform) {
            masks.resize(at);
            return may == 0 ? Colour::white : must == 0 ? Colour::boundary : Colour::black;
        }
        masks[at] = {static_cast<std::uint8_t>(may), static_cast<std::uint8_t>(must)};
        return Colour::grey;
    }

    tests::Masks masks;

  private:
    Colour colour_at(const ScaledPoint& p) const {
        return is_inside(options_.winding, solid_.winding(p)) ? Colour::black : Colour::white;
    }

    const ExactSolid& solid_;
    ConvertOptions options_;
};

} // namespace

bool is_inside(WindingRule rule, int winding) {
    if (rule == WindingRule::nonzero) return winding != 0;
    return rule == WindingRule::positive ? winding > 0 : winding % 2 != 0;
}

tests::Masks exact_masks(const ExactSolid& solid, const ConvertOptions& options) {
    std::vector<std::size_t> all(solid.face_count());
    std::iota(all.begin(), all.end(), 0);
    Growth growth(solid, options);
    const Colour root = growth.grow(root_octant, all);
    if (root == Colour::grey) return growth.masks;
    return {{root == Colour::white ? std::uint8_t{0} : std::uint8_t{0xff},
             root == Colour::black ? std::uint8_t{0xff} : std::uint8_t{0}}};
}

} // namespace osem::fuzz
