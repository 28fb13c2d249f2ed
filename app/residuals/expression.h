// Expressions in x, as a problem file has them: "1 + x", "pi^2 * sin(pi*x)".
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "sim/residual/real.h"

namespace app {

// `at` is the offset in the text of what is wrong.
struct ExpressionError : std::runtime_error {
  std::size_t at;
  ExpressionError(std::size_t at_, const std::string& what_) : std::runtime_error(what_), at(at_) {}
};

// + - * / ^ and parentheses with their usual precedence: -x^2 = -(x^2), 2^3^2 = 2^9. Names are x, pi, e, and the
// functions of one argument sin cos tan exp ln log10 sqrt abs. Throws ExpressionError.
//
// It is not muParser, which knows double and no derivatives: k' and u' are needed to the same digits as k and u (their
// differences have half of them), and errors of 1e-10 are to be told to eight digits.
sim::residual::Function parse_expression(std::string_view text);

}  // namespace app
