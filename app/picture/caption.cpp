#include "app/picture/caption.h"

#include <string_view>

#include "app/base/text.h"
#include "app/scene/caption_names.h"

namespace app {
namespace {

std::string text_of(CaptionValue value, const sim::System& system, const Moment& moment) {
  const auto measures = [&] { return system.measure(moment.state); };
  switch (value) {
    case CaptionValue::t:
      return formatted("%.2f", system.time(moment.state.step));
    case CaptionValue::frame:
      return std::to_string(moment.frame);
    case CaptionValue::steps:
      return std::to_string(moment.state.step);
    case CaptionValue::step:
      return formatted("%.4g", system.step_seconds());
    case CaptionValue::energy: {
      const sim::Measures now = measures();
      return formatted("%.4g", now.kinetic + now.elastic + now.potential);
    }
    case CaptionValue::kinetic:
      return formatted("%.4g", measures().kinetic);
    case CaptionValue::elastic:
      return formatted("%.4g", measures().elastic);
    case CaptionValue::potential:
      return formatted("%.4g", measures().potential);
    case CaptionValue::iterations:
      return std::to_string(moment.newton);
    case CaptionValue::min_J:
      return formatted("%.3f", moment.min_J);
    case CaptionValue::nodes:
      return std::to_string(system.counts().nodes);
    case CaptionValue::elements:
      return std::to_string(system.counts().elements);
  }
  return {};
}

}  // namespace

std::string caption(const std::string& text, const sim::System& system, const Moment& moment) {
  std::string result;
  for_each_caption_part(
      text, [&](std::string_view plain) { result += plain; },
      [&](std::string_view name) {
        const auto value = find_caption_value(name);
        result += value ? text_of(*value, system, moment) : "{" + std::string(name) + "}";
      });
  return result;
}

}  // namespace app
