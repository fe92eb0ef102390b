// What a winding number means.
#ifndef OSEM_CONVERT_INSIDE_HPP
#define OSEM_CONVERT_INSIDE_HPP

#include "osem/convert.hpp"

namespace osem {

inline bool is_inside(WindingRule rule, std::int32_t winding) {
    switch (rule) {
    case WindingRule::nonzero:
        return winding != 0;
    case WindingRule::odd:
        return (winding & 1) != 0;
    default: // positive
        return winding > 0;
    }
}

} // namespace osem

#endif
