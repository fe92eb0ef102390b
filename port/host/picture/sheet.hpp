// Several pictures in one.
#ifndef OSEM_HOST_SHEET_HPP
#define OSEM_HOST_SHEET_HPP

#include <string>
#include <vector>

#include "picture/image.hpp"

namespace osem::host {

/// A picture and what is written into its upper left corner.
struct Tile {
    Image image;
    std::string label;
};

/// Puts pictures of one size into a grid, row by row, without gaps; places that are left over are white.
/// Precondition: there is a tile, and columns is at least 1.
Image sheet(const std::vector<Tile>& tiles, int columns);

} // namespace osem::host

#endif
