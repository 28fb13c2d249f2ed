// The panel: every value of the scene, made from the key table, with plots of the run and buttons. Widgets of Dear
// ImGui in the frame that is under way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/options.h"
#include "app/panel/field.h"
#include "app/panel/sections.h"
#include "app/scene/document.h"
#include "app/session/input.h"
#include "app/session/monitor.h"
#include "sim/system.h"

namespace app {

// What a key or a button asks for.
enum class Action {
  play,
  step,
  back,
  reset,
  restart,
  reload,
  save,
  screenshot,
  help,
  hide_panel,
  page_back,
  page_on,
  wireframe,
  quit,
};

// What the panel shows.
struct PanelState {
  const Document& document;  // the values as they are
  const sim::System& system;
  const std::vector<Override>& waiting;  // for the restart
  const std::vector<Sample>& samples;
  double t = 0;  // s
  std::int64_t step = 0;
  bool playing = false;
  double factor = 1;  // simulated over wall time
  std::string message = {};
  bool clock = true;  // show what the wall clock says; not in recorded frames, which are the same every time
};

// What was done in the panel during a frame.
struct PanelRequests {
  std::vector<Action> actions;
  std::vector<SetKey> changes;
};

class Panel {
 public:
  // Pixels at the left edge of a window, or of a frame, of this size that the panel takes.
  static int width(int whole_width, int whole_height);
  // Height of its letters, pixels.
  static float text_size(int whole_width, int whole_height);

  // At the left edge, of this size.
  PanelRequests draw(const PanelState& state, int width, int height);

 private:
  void draw_head(const PanelState& state, PanelRequests& requests) const;
  void draw_keys(const PanelState& state, PanelRequests& requests);
  void draw_group(const Group& group, const PanelState& state, PanelRequests& requests);
  void draw_entry(const Entry& entry, const PanelState& state, PanelRequests& requests);

  std::optional<Edit> edit_;
};

// The keys of the keyboard, over the picture.
void draw_help(int width, int height);

}  // namespace app
