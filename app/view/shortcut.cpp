#include "app/view/shortcut.h"

namespace app {

std::optional<Action> action_of(const render::WindowEvent& event) {
  switch (event.key) {
    case render::Key::space:
      return Action::play;
    case render::Key::right:
      return Action::step;
    case render::Key::left:
      return Action::back;
    case render::Key::backspace:
      return Action::reset;
    case render::Key::f1:
      return Action::help;
    case render::Key::tab:
      return Action::hide_panel;
    case render::Key::page_up:
      return Action::page_back;
    case render::Key::page_down:
      return Action::page_on;
    case render::Key::escape:
      return std::nullopt;
    case render::Key::letter:
      break;
  }
  if (!event.control) return event.letter == 'W' ? std::optional(Action::wireframe) : std::nullopt;
  if (event.letter == 'L') return Action::reload;
  if (event.letter == 'S') return Action::save;
  if (event.letter == 'P') return Action::screenshot;
  if (event.letter == 'Q') return Action::quit;
  return std::nullopt;
}

}  // namespace app
