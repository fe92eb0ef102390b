#include "mesh/write_off.hpp"

#include <charconv>
#include <string>

#include "mesh/triangulate.hpp"

namespace osem::host {

namespace {

bool has_holes(const Solid& solid, std::uint32_t face) {
    return solid.end_ring(face) - solid.first_ring(face) > 1;
}

// Gathers lines and hands them on in large pieces.
class OffWriter {
  public:
    explicit OffWriter(std::ostream& out) : out_(out) {}
    ~OffWriter() { flush(); }

    template <class Number>
    void number(Number value) {
        char digits[16];
        text_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
        text_ += ' ';
    }
    void end_line() {
        text_.back() = '\n';
        if (text_.size() > (1U << 16)) flush();
    }
    void polygon(const std::uint32_t* corners, std::uint32_t count) {
        number(count);
        for (std::uint32_t i = 0; i < count; ++i) number(corners[i]);
        end_line();
    }

  private:
    void flush() {
        out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

    std::ostream& out_;
    std::string text_;
};

} // namespace

void write_off(std::ostream& out, const IntegerSolid& solid) {
    const Solid view = solid.view();
    std::vector<Triangle> triangles;
    std::uint32_t polygons = 0;
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        if (!has_holes(view, face)) {
            ++polygons;
            continue;
        }
        const auto pieces = triangulate_face(view, face);
        triangles.insert(triangles.end(), pieces.begin(), pieces.end());
    }

    out << "OFF\n";
    OffWriter writer(out);
    writer.number(view.vertex_count);
    writer.number(polygons + triangles.size());
    writer.number(0);
    writer.end_line();
    for (const Point& vertex : solid.vertices) {
        for (const std::int32_t coordinate : vertex.at) writer.number(coordinate);
        writer.end_line();
    }
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        if (has_holes(view, face)) continue;
        const Ring ring = view.ring(view.first_ring(face));
        writer.polygon(ring.corners, ring.count);
    }
    for (const Triangle& triangle : triangles) writer.polygon(triangle.data(), 3);
}

} // namespace osem::host
