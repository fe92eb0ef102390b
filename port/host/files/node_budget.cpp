#include "files/node_budget.hpp"

#include <charconv>

#include "osem/node_pool.hpp"

namespace osem::host {

std::optional<std::uint32_t> parse_node_budget(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || value > UINT32_MAX) return std::nullopt;
    const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
    if (unit == "MB") {
        value = value * 1024 * 1024 / sizeof(Node);
    } else if (unit == "KB") {
        value = value * 1024 / sizeof(Node);
    } else if (unit == "B") {
        value = value / sizeof(Node);
    } else if (!unit.empty()) {
        return std::nullopt;
    }
    if (value > NodePool::max_capacity) return std::nullopt;
    return static_cast<std::uint32_t>(value);
}

} // namespace osem::host
