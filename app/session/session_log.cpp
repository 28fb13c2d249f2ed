#include "app/session/session_log.h"

#include "app/base/text.h"
#include "app/scene/value_text.h"

namespace app {
namespace {

// The keys of an input, one a line.
struct Writer {
  int dimension;
  std::string text = {};

  void line(const char* key, const std::string& value) { text.append(key).append(" = ").append(value).append("\n"); }
  void point(const char* key, const sim::Vec3& v) {
    std::string list = "[";
    for (int i = 0; i < dimension; ++i) list += (i > 0 ? ", " : "") + number_literal(v[i]);
    line(key, list + "]");
  }

  void operator()(const SetKey& input) {
    line("do", "\"set\"");
    line("key", quoted_text(input.key));
    line("value", input.value);
  }
  void operator()(const MoveCamera& input) {
    line("do", "\"camera\"");
    if (input.eye) point("eye", *input.eye);
    if (input.target) point("target", *input.target);
    if (input.height) line("height", number_literal(*input.height));
  }
  void operator()(const Pull& input) {
    line("do", "\"pull\"");
    line("body", quoted_text(input.body));
    point("at", input.at);
    point("target", input.target);
  }
  void operator()(const PullTo& input) {
    line("do", "\"pull-to\"");
    point("target", input.target);
  }
  void operator()(const Release&) { line("do", "\"release\""); }
  void operator()(const StepBack&) { line("do", "\"back\""); }
  void operator()(const Reset&) { line("do", "\"reset\""); }
  void operator()(const Restart&) { line("do", "\"restart\""); }
};

}  // namespace

std::string event_text(const Event& event, int dimension) {
  Writer writer{dimension};
  writer.text = "\n[[input]]\n";
  writer.line("step", std::to_string(event.step));
  std::visit(writer, event.input);
  return writer.text;
}

SessionLog::SessionLog(const Options& options, int dimension)
    : file_(options.log, OutputFile::Mode::create), dimension_(dimension) {
  const std::string scene = options.scene.string();
  std::string text = "# A session of `ritz view`; draw it again with\n#   ritz record " + scene + " --replay " +
                     options.log.string() + "\nscene = " + quoted_text(scene) + "\n";
  if (!options.settings.empty()) text += "settings = " + quoted_text(options.settings.string()) + "\n";
  std::string set;
  for (const Override& each : options.overrides) {
    set += (set.empty() ? "" : ", ") + quoted_text(each.key + "=" + each.value);
  }
  if (!set.empty()) text += "set = [" + set + "]\n";
  file_.write(text);
  file_.flush();
}

void SessionLog::write(const Event& event) {
  file_.write(event_text(event, dimension_));
  file_.flush();
}

void SessionLog::end(std::int64_t steps, const sim::State& state) {
  file_.write("\n[end]\nsteps = " + std::to_string(steps) + "\nstate_hash = \"" + hexadecimal(sim::hash(state)) +
              "\"\n");
  file_.close();
}

}  // namespace app
