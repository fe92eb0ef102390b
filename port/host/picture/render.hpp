// Trees and solids as pictures.
#ifndef OSEM_HOST_RENDER_HPP
#define OSEM_HOST_RENDER_HPP

#include "console/progress.hpp"
#include "picture/camera.hpp"
#include "picture/image.hpp"
#include "picture/lines.hpp"

namespace osem::host {

enum class Style {
    faces,    ///< shaded, every face of a leaf or of the solid as it is
    smooth,   ///< shaded, as the smooth surface that small leaves stand for
    wireframe ///< lines, hidden ones removed
};

/// How subjects are drawn.
struct Look {
    Style style = Style::faces;
    Lines lines = Lines::leaves; ///< of a wireframe
};

/// A square picture of `size` pixels a side of one subject, as a camera aimed at all `together` sees it. Four
/// rays a pixel are cast for a shaded picture, nine for a wireframe of up to 2048 pixels a side. Boundary
/// leaves are steel blue, black leaves and solids warm grey. Memory: 29 bytes a ray, for a solid 61.
Image render(const Subject& subject, const std::vector<Subject>& together, const View& view, int size,
             const Look& look, Progress& progress);

} // namespace osem::host

#endif
