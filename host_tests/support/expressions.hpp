// Random expressions, and what they mean point by point: every operand is 0 or 1 there, wherever it stands.
#ifndef OSEM_SUPPORT_EXPRESSIONS_HPP
#define OSEM_SUPPORT_EXPRESSIONS_HPP

#include <random>
#include <vector>

#include "osem/csg.hpp"

namespace osem::tests {

using Tokens = std::vector<CsgToken>;

extern const std::vector<Operator> operators;

/// A random expression in which `places` operands stand, any of them anywhere, with complements here and
/// there.
Tokens any_expression(unsigned places, unsigned operand_count, std::mt19937& random);
/// One in which every operand stands once.
Tokens read_once_expression(unsigned operand_count, std::mt19937& random);

/// The value where the operands have these colours, by trying everything that they can be: what is boundary
/// or grey is either.
Colour colour_at(const Tokens& tokens, const std::vector<Colour>& colours);

/// Whether the value depends on an operand that is grey.
bool depends_on_grey(const Tokens& tokens, const std::vector<Colour>& colours);

} // namespace osem::tests

#endif
