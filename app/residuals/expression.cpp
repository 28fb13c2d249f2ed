#include "app/residuals/expression.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "app/base/nearest.h"
#include "sim/residual/jet.h"

namespace app {
namespace {

using sim::residual::Jet;
using sim::residual::Real;

using Unary = Jet (*)(Jet);
using Binary = Jet (*)(Jet, Jet);

struct Call {
  std::string_view name;
  Unary apply;
};
constexpr Call calls[] = {
    {"sin", sim::residual::sin},   {"cos", sim::residual::cos}, {"tan", sim::residual::tan},
    {"exp", sim::residual::exp},   {"ln", sim::residual::log},  {"log10", sim::residual::log10},
    {"sqrt", sim::residual::sqrt}, {"abs", sim::residual::abs},
};

struct Constant {
  std::string_view name;
  Real value;
};
constexpr Constant constants[] = {{"pi", std::numbers::pi_v<Real>}, {"e", std::numbers::e_v<Real>}};

// A step of the evaluation, on a stack: pushes a constant or x, or replaces the top one or two.
struct Step {
  Unary unary = nullptr;
  Binary binary = nullptr;
  Jet constant = {};
  bool is_x = false;
};

Jet evaluate(const std::vector<Step>& steps, std::size_t depth, Real x) {
  std::vector<Jet> stack;
  stack.reserve(depth);
  for (const Step& step : steps) {
    if (step.unary) {
      stack.back() = step.unary(stack.back());
    } else if (step.binary) {
      const Jet right = stack.back();
      stack.pop_back();
      stack.back() = step.binary(stack.back(), right);
    } else {
      stack.push_back(step.is_x ? Jet{x, 1} : step.constant);
    }
  }
  return stack.back();
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// By recursive descent:  sum = product {(+|-) product}   product = sign {(*|/) sign}   sign = (+|-) sign | power
//                        power = atom [^ sign]           atom = number | name | function ( sum ) | ( sum )
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<Step> parse() {
    sum();
    if (peek() == ')') fail("a ')' without its '('");
    if (peek() != '\0' || at_ < text_.size()) fail("an operator is missing before '" + rest() + "'");
    return std::move(steps_);
  }

 private:
  static constexpr int deepest_allowed = 200;  // parentheses, signs and powers inside each other

  [[noreturn]] void fail(const std::string& what) const { throw ExpressionError(at_, what); }

  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  // What stands here, as far as a message needs it.
  std::string rest() const { return std::string(text_.substr(at_, 12)); }

  void enter() {
    if (++depth_ > deepest_allowed) fail("nested more than " + std::to_string(deepest_allowed) + " times");
  }

  void sum() {
    enter();
    product();
    while (true) {
      if (take('+')) {
        product();
        steps_.push_back({.binary = sim::residual::operator+});
      } else if (take('-')) {
        product();
        steps_.push_back({.binary = sim::residual::operator-});
      } else {
        break;
      }
    }
    --depth_;
  }

  void product() {
    sign();
    while (true) {
      if (take('*')) {
        sign();
        steps_.push_back({.binary = sim::residual::operator*});
      } else if (take('/')) {
        sign();
        steps_.push_back({.binary = sim::residual::operator/});
      } else {
        return;
      }
    }
  }

  void sign() {
    enter();
    if (take('-')) {
      sign();
      steps_.push_back({.unary = sim::residual::operator-});
    } else if (take('+')) {
      sign();
    } else {
      power();
    }
    --depth_;
  }

  void power() {
    atom();
    if (!take('^')) return;
    sign();
    steps_.push_back({.binary = sim::residual::pow});
  }

  void atom() {
    const char c = peek();
    if (is_digit(c) || c == '.') return number();
    if (is_letter(c)) return name();
    if (!take('(')) {
      fail(at_ == text_.size() ? "a number, x or '(' is missing at the end"
                               : "a number, x or '(' is missing before '" + rest() + "'");
    }
    sum();
    close();
  }

  void close() {
    if (!take(')')) fail("a ')' is missing");
  }

  void number() {
    Real value = 0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
    if (error != std::errc{}) fail("'" + rest() + "' is not a number");
    at_ = stop - text_.data();
    steps_.push_back({.constant = {value, 0}});
  }

  void name() {
    const std::size_t begin = at_;
    std::size_t end = begin;
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
    const std::string_view word = text_.substr(begin, end - begin);
    if (word == "x") {
      at_ = end;
      steps_.push_back({.is_x = true});
    } else if (const auto* constant = std::ranges::find(constants, word, &Constant::name);
               constant != std::end(constants)) {
      at_ = end;
      steps_.push_back({.constant = {constant->value, 0}});
    } else if (const auto* call = std::ranges::find(calls, word, &Call::name); call != std::end(calls)) {
      at_ = end;
      if (!take('('))
        fail("'" + std::string(word) + "' needs its argument in parentheses: " + std::string(word) + "(x)");
      sum();
      close();
      steps_.push_back({.unary = call->apply});
    } else {
      refuse_name(word);
    }
  }

  [[noreturn]] void refuse_name(std::string_view word) const {
    std::vector<std::string_view> known = {"x"};
    for (const Constant& constant : constants) known.push_back(constant.name);
    for (const Call& call : calls) known.push_back(call.name);
    std::string message = "unknown name '" + std::string(word) + "': ";
    if (const std::string_view meant = nearest(word, known); !meant.empty()) {
      fail(message + "did you mean '" + std::string(meant) + "'?");
    }
    message += "known are";
    for (const std::string_view other : known) message.append(" ").append(other);
    fail(message);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Step> steps_;
};

}  // namespace

sim::residual::Function parse_expression(std::string_view text) {
  std::vector<Step> steps = Parser(text).parse();
  const std::size_t depth = steps.size();
  return [steps = std::move(steps), depth](Real x) { return evaluate(steps, depth, x); };
}

}  // namespace app
