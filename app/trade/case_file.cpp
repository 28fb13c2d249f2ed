#include "app/trade/case_file.h"

#include <toml++/toml.h>

#include <bit>
#include <cstring>

#include "app/base/text.h"
#include "app/base/version.h"
#include "app/scene/value_text.h"

namespace app {
namespace {

constexpr std::string_view end_of_head = "---\n";
static_assert(std::endian::native == std::endian::little, "the numbers of a path are stored as they lie in memory");

std::string head(const CaseRun& run) {
  std::string text;
  const auto line = [&](std::string_view name, const std::string& value) {
    text.append(name).append(" = ").append(value) += '\n';
  };
  line("version", quoted_text(ritz_version));
  line("label", quoted_text(run.which.label));
  line("axis", std::to_string(static_cast<int>(run.which.axis)));
  line("id", quoted_text(std::to_string(run.id)));
  line("status", std::to_string(static_cast<int>(run.status)));
  line("reason", quoted_text(run.reason));
  line("order", std::to_string(run.order));
  line("dofs", std::to_string(run.dofs));
  line("not_converged", std::to_string(run.not_converged));
  line("dimension", std::to_string(run.path.dimension));
  line("frames", std::to_string(run.path.frames()));
  line("numbers", std::to_string(run.path.frames() > 0 ? run.path.x.front().size() : 0));
  line("timed", std::to_string(run.timed.size()));
  std::string settings, seconds;
  for (const auto& [key, value] : run.which.settings)
    settings += (settings.empty() ? "" : ", ") + quoted_text(key) + ", " + quoted_text(value);
  for (const double s : run.work.seconds) seconds += (seconds.empty() ? "" : ", ") + number_literal(s);
  line("settings", "[" + settings + "]");
  line("seconds", "[" + seconds + "]");
  return text;
}

// The numbers of a run one after the other, the same way for writing and for reading.
template <class Run, class F>
void for_each_number(Run& run, const F& f) {
  auto& work = run.work;
  for (auto* x : {&run.training, &run.step, &work.cpu, &work.steps, &work.newton, &work.force_evaluations,
                  &work.factorisations, &work.linear})
    f(*x);
  for (auto& [counts, seconds] : run.timed) {
    for (auto* x : {&counts.steps, &counts.force_evaluations, &counts.factorisations, &counts.linear}) f(*x);
    f(seconds);
  }
  for (auto& t : run.path.t) f(t);
  for (auto& x : run.path.x)
    for (auto& number : x) f(number);
  for (auto& m : run.path.measures) {
    for (auto* energy : {&m.kinetic, &m.elastic, &m.potential}) f(*energy);
    for (auto& p : m.p) f(p);
    for (auto& L : m.L) f(L);
  }
}

// Empty vectors of the right lengths.
void make_room(const toml::table& table, CaseRun& run) {
  const auto frames = static_cast<std::size_t>(table["frames"].value_or(0));
  run.path.dimension = table["dimension"].value_or(3);
  run.path.t.resize(frames);
  run.path.x.assign(frames, Eigen::VectorXd::Zero(table["numbers"].value_or(0)));
  run.path.measures.resize(frames);
  run.timed.resize(static_cast<std::size_t>(table["timed"].value_or(0)));
}

CaseRun read_head(const toml::table& table) {
  CaseRun run;
  run.which.label = table["label"].value_or(std::string());
  run.which.axis = static_cast<Axis>(table["axis"].value_or(0));
  run.id = std::stoull(table["id"].value_or(std::string("0")));
  run.status = static_cast<CaseStatus>(table["status"].value_or(0));
  run.reason = table["reason"].value_or(std::string());
  run.order = table["order"].value_or(0);
  run.dofs = table["dofs"].value_or(0);
  run.not_converged = table["not_converged"].value_or(0);
  if (const toml::array* settings = table["settings"].as_array())
    for (std::size_t k = 0; k + 1 < settings->size(); k += 2)
      run.which.settings.emplace_back((*settings)[k].value_or(std::string()),
                                      (*settings)[k + 1].value_or(std::string()));
  if (const toml::array* seconds = table["seconds"].as_array())
    for (const toml::node& s : *seconds) run.work.seconds.push_back(s.value_or(0.0));
  make_room(table, run);
  return run;
}

}  // namespace

std::string encode(const CaseRun& run) {
  std::string bytes = head(run).append(end_of_head);
  for_each_number(run, [&](const double& x) {
    const auto raw = std::bit_cast<std::array<char, sizeof(double)>>(x);
    bytes.append(raw.data(), raw.size());
  });
  return bytes;
}

std::optional<CaseRun> decode_case(std::string_view bytes) {
  const std::size_t end = bytes.find(end_of_head);
  if (end == std::string_view::npos) return std::nullopt;
  try {
    const toml::table table = toml::parse(bytes.substr(0, end));
    if (table["version"].value_or(std::string()) != ritz_version) return std::nullopt;
    CaseRun run = read_head(table);
    bytes.remove_prefix(end + end_of_head.size());
    std::size_t numbers = 0;
    for_each_number(run, [&](double&) { ++numbers; });
    if (bytes.size() != numbers * sizeof(double)) return std::nullopt;
    for_each_number(run, [&](double& x) {
      std::memcpy(&x, bytes.data(), sizeof x);
      bytes.remove_prefix(sizeof x);
    });
    return run;
  } catch (const std::exception&) {  // damaged: it is run again
    return std::nullopt;
  }
}

}  // namespace app
