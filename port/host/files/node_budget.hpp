// How many nodes a --fit value allows.
#ifndef OSEM_HOST_NODE_BUDGET_HPP
#define OSEM_HOST_NODE_BUDGET_HPP

#include <cstdint>
#include <optional>
#include <string_view>

namespace osem::host {

/// "600": nodes of a pool; "8KB": as many nodes as 8 x 1024 bytes hold (units B, KB, MB). None when the text
/// is neither, or more than a pool can hold.
std::optional<std::uint32_t> parse_node_budget(std::string_view text);

} // namespace osem::host

#endif
