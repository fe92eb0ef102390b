#include "mesh/write_surface.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstring>

namespace osem::host {

namespace {

using World = std::array<double, 3>;

World world(const Point& p, const WorldCube& cube) {
    World w = {};
    for (std::size_t axis = 0; axis < 3; ++axis) w[axis] = cube.origin[axis] + p.at[axis] * cube.unit();
    return w;
}

// Gathers text and hands it on in large pieces.
class Text {
  public:
    explicit Text(std::ostream& out) : out_(out) {}
    ~Text() { flush(); }
    Text(const Text&) = delete;
    Text& operator=(const Text&) = delete;

    template <class Number>
    Text& number(Number value) {
        char digits[32];
        if (!text_.empty() && text_.back() != '\n') text_ += ' ';
        text_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
        return *this;
    }
    Text& point(const World& w) { return number(w[0]).number(w[1]).number(w[2]); }
    Text& word(const char* word) {
        text_ += word;
        return *this;
    }
    void end_line() {
        text_ += '\n';
        if (text_.size() > (1U << 16)) flush();
    }

  private:
    void flush() {
        out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

    std::ostream& out_;
    std::string text_;
};

void write_ring(Text& text, const Ring& ring, std::uint32_t first) {
    for (std::uint32_t i = 0; i < ring.count; ++i) text.number(ring.corners[i] + first);
    text.end_line();
}

void write_off(std::ostream& out, const Solid& view, const WorldCube& cube) {
    Text text(out);
    text.word("OFF").end_line();
    text.number(view.vertex_count).number(view.face_count).number(0).end_line();
    for (std::uint32_t v = 0; v < view.vertex_count; ++v) {
        text.point(world(view.vertices[v], cube)).end_line();
    }
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        const Ring ring = view.ring(view.first_ring(face));
        text.number(ring.count);
        write_ring(text, ring, 0);
    }
}

void write_obj(std::ostream& out, const Solid& view, const WorldCube& cube) {
    Text text(out);
    for (std::uint32_t v = 0; v < view.vertex_count; ++v) {
        text.word("v").point(world(view.vertices[v], cube)).end_line();
    }
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        text.word("f");
        write_ring(text, view.ring(view.first_ring(face)), 1);
    }
}

void write_poly(std::ostream& out, const Solid& view, const WorldCube& cube) {
    Text text(out);
    text.number(view.vertex_count).word(" 3 0 0").end_line();
    for (std::uint32_t v = 0; v < view.vertex_count; ++v) {
        text.number(v).point(world(view.vertices[v], cube)).end_line();
    }
    text.number(view.face_count).word(" 0").end_line();
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        text.number(view.end_ring(face) - view.first_ring(face)).end_line();
        for (std::uint32_t r = view.first_ring(face); r < view.end_ring(face); ++r) {
            text.number(view.ring(r).count);
            write_ring(text, view.ring(r), 0);
        }
    }
    text.word("0").end_line();
}

void put_word(char* to, std::uint32_t word) {
    for (int byte = 0; byte < 4; ++byte) to[byte] = static_cast<char>((word >> (8 * byte)) & 0xffU);
}

void put_float(char* to, double value) {
    const auto single = static_cast<float>(value);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);
    put_word(to, bits);
}

void write_stl(std::ostream& out, const Solid& view, const WorldCube& cube) {
    char head[84] = "osem surface";
    put_word(head + 80, view.face_count);
    out.write(head, sizeof head);
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        const Ring ring = view.ring(view.first_ring(face));
        char record[50] = {}; // a null normal: readers take the corners' order
        char* to = record + 12;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const World w = world(view.vertices[ring.corners[i]], cube);
            for (const auto coordinate : w) {
                put_float(to, coordinate);
                to += 4;
            }
        }
        out.write(record, sizeof record);
    }
}

} // namespace

std::optional<SurfaceFormat> surface_format(const std::string& name) {
    std::string end = name.substr(std::min(name.rfind('.'), name.size()));
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (end == ".off") return SurfaceFormat::off;
    if (end == ".obj") return SurfaceFormat::obj;
    if (end == ".stl") return SurfaceFormat::stl;
    if (end == ".poly") return SurfaceFormat::poly;
    return std::nullopt;
}

void write_surface(std::ostream& out, const TreeSurface& surface, const WorldCube& cube,
                   SurfaceFormat format) {
    const Solid view = surface.view();
    switch (format) {
    case SurfaceFormat::off:
        return write_off(out, view, cube);
    case SurfaceFormat::obj:
        return write_obj(out, view, cube);
    case SurfaceFormat::stl:
        return write_stl(out, view, cube);
    case SurfaceFormat::poly:
        return write_poly(out, view, cube);
    }
}

} // namespace osem::host
