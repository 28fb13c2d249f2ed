#include "app/residuals/problem_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "app/base/nearest.h"
#include "app/residuals/expression.h"

namespace app {
namespace {

using sim::residual::Function;
using sim::residual::Problem;
using sim::residual::Real;

// A key whose value is an expression.
struct FunctionKey {
  std::string_view name, fallback;  // no fallback: it may be absent, or f, it must be there
  Function Problem::*function;
};
constexpr FunctionKey function_keys[] = {{"k", "1", &Problem::k},
                                         {"a", "0", &Problem::a},
                                         {"q", "0", &Problem::q},
                                         {"f", "", &Problem::f},
                                         {"exact", "", &Problem::exact}};
constexpr std::string_view lists[] = {"bases", "methods", "n"};
constexpr int first_terms[] = {1, 2, 4, 8, 16, 32};

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw std::runtime_error(where + ": " + what);
}

std::string given_text(const toml::node& node) {
  std::ostringstream given;
  node.visit([&](const auto& value) { given << value; });
  return given.str();
}

// As much of a long expression as a message has room for, about a character of it.
std::string excerpt(const std::string& text, std::size_t at) {
  constexpr std::size_t most = 60;
  if (text.size() <= most) return text;
  const std::size_t first = std::min(at - std::min(at, most / 2), text.size() - most);
  return (first > 0 ? "..." : "") + text.substr(first, most) + (first + most < text.size() ? "..." : "");
}

class Reader {
 public:
  Reader(const std::filesystem::path& path, const toml::table& table) : path_(path.string()), table_(table) {
    file_.name = path.stem().string();
  }

  ProblemFile read() {
    check_names();
    for (const FunctionKey& key : function_keys) read_function(key);
    if (!file_.problem.f) refuse(path_, "f is missing: the right-hand side, as in f = \"1\"");
    file_.bases = read_names("bases", sim::residual::bases(), "a basis");
    file_.methods = read_names("methods", sim::residual::methods(), "a method");
    read_terms();
    solve();
    return std::move(file_);
  }

 private:
  std::string line(const toml::source_region& source) const { return path_ + ":" + std::to_string(source.begin.line); }

  void check_names() const {
    std::vector<std::string_view> known(std::begin(lists), std::end(lists));
    for (const FunctionKey& key : function_keys) known.push_back(key.name);
    for (const auto& [name, node] : table_) {
      if (std::ranges::find(known, name.str()) != known.end()) continue;
      std::string message = "unknown key '" + std::string(name.str()) + "': ";
      const std::string_view meant = nearest(name.str(), known);
      message += meant.empty() ? "known are k, a, q, f, exact, bases, methods, n"
                               : "did you mean '" + std::string(meant) + "'?";
      refuse(line(name.source()), message);
    }
  }

  void read_function(const FunctionKey& key) {
    const toml::node* const node = table_.get(key.name);
    std::string text(key.fallback);
    if (node) {
      const auto given = node->value_exact<std::string>();
      if (!given) {
        refuse(line(node->source()), std::string(key.name) + " must be an expression in quotes, as in " +
                                         std::string(key.name) + " = \"1 + x\"");
      }
      text = *given;
    } else if (text.empty()) {
      return;
    }
    file_.written[std::string(key.name)] = text;
    try {
      file_.problem.*key.function = parse_expression(text);
    } catch (const ExpressionError& error) {
      refuse(place_in(*node, text, error.at), std::string(key.name) + " = \"" + excerpt(text, error.at) +
                                                  "\": " + error.what() + ", at character " +
                                                  std::to_string(error.at + 1) + " of the expression");
    }
  }

  // Line and column of a character of an expression. Where its text in the file is not the expression itself, but has
  // escapes or several lines, that of its first quote.
  std::string place_in(const toml::node& node, const std::string& text, std::size_t at) const {
    const toml::source_region& source = node.source();
    const bool plain =
        source.begin.line == source.end.line && source.end.column - source.begin.column == text.size() + 2;
    return line(source) + ":" + std::to_string(source.begin.column + (plain ? 1 + at : 0));
  }

  template <class Row>
  std::vector<const Row*> read_names(std::string_view key, std::span<const Row> rows, const std::string& what) const {
    std::vector<const Row*> found;
    const toml::node* const node = table_.get(key);
    for (const Row& row : rows)
      if (!node) found.push_back(&row);
    if (!node) return found;
    std::string known;
    for (const Row& row : rows) known.append(known.empty() ? "" : ", ").append(row.name);
    const toml::array* const list = node->as_array();
    if (!list || list->empty()) refuse(line(node->source()), std::string(key) + " must be a list of some of: " + known);
    for (const toml::node& entry : *list) {
      const std::string name = entry.value_or(given_text(entry));
      const auto row = std::ranges::find(rows, std::string_view(name), &Row::name);
      if (row == rows.end())
        refuse(line(entry.source()),
               std::string(key) + ": '" + name + "' is not " + what + ": must be one of " + known);
      if (std::ranges::find(found, &*row) == found.end()) found.push_back(&*row);
    }
    return found;
  }

  void read_terms() {
    const toml::node* const node = table_.get("n");
    file_.n.assign(std::begin(first_terms), std::end(first_terms));
    if (!node) return;
    const std::string right =
        "n must be a list of integers from 1 to " + std::to_string(most_terms) + ", as in [1, 2, 4]";
    const toml::array* const list = node->as_array();
    if (!list || list->empty()) refuse(line(node->source()), right);
    file_.n.clear();
    for (const toml::node& entry : *list) {
      const auto terms = entry.value_exact<std::int64_t>();
      if (!terms || *terms < 1 || *terms > most_terms)
        refuse(line(entry.source()), right + "; not " + given_text(entry));
      file_.n.push_back(static_cast<int>(*terms));
    }
    std::ranges::sort(file_.n);
    const auto rest = std::ranges::unique(file_.n);
    file_.n.erase(rest.begin(), rest.end());
  }

  // What the functions mean together: a solution, which the exact one, where it is given, must be.
  void solve() {
    try {
      check(file_.problem);
      file_.reference = compute_reference(file_.problem);
      if (file_.exact_is_computed()) {
        file_.problem.exact = file_.reference.u;
      } else {
        check_exact();
      }
    } catch (const sim::residual::ProblemError& error) {
      const toml::node* const node = table_.get(error.key);
      refuse(node ? line(node->source()) : path_, error.what());
    }
  }

  void check_exact() const {
    constexpr int cells = 1000;
    constexpr Real most = 1e-6L;
    Real size = 0, worst = -1, at = 0;
    for (int i = 0; i <= cells; ++i) {
      const Real x = Real(i) / cells, u = file_.reference.u(x).value,
                 apart = std::abs(file_.problem.exact(x).value - u);
      size = std::max(size, std::abs(u));
      if (apart > worst) worst = apart, at = x;
    }
    if (worst <= most * size) return;
    std::ostringstream text;
    text << "exact(" << at << ") = " << file_.problem.exact(at).value << ": must be the solution, which is "
         << file_.reference.u(at).value << " there";
    throw sim::residual::ProblemError("exact", text.str());
  }

  std::string path_;
  const toml::table& table_;
  ProblemFile file_;
};

}  // namespace

ProblemFile read_problem(const std::filesystem::path& path) {
  std::error_code none;
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::exists(path, none)) refuse(path.string(), "there is no such file");
  if (!in || std::filesystem::is_directory(path, none)) refuse(path.string(), "cannot be read: must be a problem file");
  return read_problem(std::string(std::istreambuf_iterator<char>(in), {}), path);
}

ProblemFile read_problem(std::string_view text, const std::filesystem::path& path) {
  try {
    const toml::table table = toml::parse(text, path.string());
    return Reader(path, table).read();
  } catch (const toml::parse_error& error) {
    refuse(path.string() + ":" + std::to_string(error.source().begin.line), std::string(error.description()));
  }
}

}  // namespace app
