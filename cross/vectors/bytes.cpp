#include "bytes.hpp"

namespace vectors {

std::uint32_t crc_32(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~crc;
}

void Bytes::put(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) data_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void Bytes::point(const osem::Point& p) {
    for (const std::int32_t coordinate : p.at) i32(coordinate);
}

void Bytes::solid(const osem::Solid& solid) {
    const std::uint32_t rings = solid.ring_count();
    u32(solid.vertex_count);
    u32(solid.corner_count);
    u32(rings);
    u32(solid.face_count);
    u8(solid.is_triangle_mesh() ? 0 : 1);
    for (std::uint32_t i = 0; i < solid.vertex_count; ++i) point(solid.vertices[i]);
    for (std::uint32_t i = 0; i < solid.corner_count; ++i) u32(solid.corners[i]);
    if (solid.is_triangle_mesh()) return;
    for (std::uint32_t i = 0; i <= rings; ++i) u32(solid.ring_starts[i]);
    for (std::uint32_t i = 0; i <= solid.face_count; ++i) u32(solid.face_rings[i]);
}

void Bytes::options(const osem::ConvertOptions& options) {
    u8(static_cast<std::uint64_t>(options.depth));
    u8(static_cast<std::uint64_t>(options.leaves));
    u8(static_cast<std::uint64_t>(options.winding));
}

void Bytes::append(const Bytes& other) { data_.insert(data_.end(), other.data_.begin(), other.data_.end()); }

} // namespace vectors
