// Expressions of the command line, such as (part - hole1) - hole2 & zone.
#ifndef OSEM_HOST_EXPRESSION_HPP
#define OSEM_HOST_EXPRESSION_HPP

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "osem/csg.hpp"

namespace osem::host {

/// What is wrong with an expression, and in which column.
struct ExpressionFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How expressions are written, for a help text.
extern const char* const expression_help;

/// Whether a text may name an operand: a letter or _ and then letters, digits and _.
bool is_operand_name(std::string_view text);

/// The expression in postfix notation; operands are numbered as in `names`. Throws ExpressionFault, also when
/// a name is not used.
std::vector<CsgToken> parse_expression(std::string_view text, const std::vector<std::string>& names);

} // namespace osem::host

#endif
