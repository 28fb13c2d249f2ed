// A window on the desktop: an OpenGL context, what the user does in it, and input for a Gui.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/context.h"
#include "render/gui.h"

namespace render {

// There is no display to open a window on; what() is GLFW's reason.
struct NoDisplay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Button { left, right, middle };

// Keys that stand for something in the program; others are a Gui's.
enum class Key { space, left, right, backspace, escape, tab, f1, page_up, page_down, letter };

// What the user did, in the order it was done. Places are pixels of the framebuffer from its upper left corner.
struct WindowEvent {
  enum class Kind { key, press, release, move, scroll, redraw } kind = Kind::redraw;
  Key key = Key::letter;
  char letter = 0;  // 'A' to 'Z' of a key that is one
  Button button = Button::left;
  bool control = false;
  float x = 0, y = 0;  // of the mouse
  float scroll = 0;    // notches, positive away from the user
};

class Window final : public Context {
 public:
  // Throws NoDisplay. One window at a time.
  Window(int width, int height, const std::string& title);
  ~Window() override;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void make_current() override;
  Getter getter() const override;
  int width() const override;   // of the framebuffer, which may have more pixels than the desktop says
  int height() const override;  // 0 while the window is minimised
  float scale() const;          // pixels of the framebuffer for one of the desktop

  // Gives the gui mouse, keys and clipboard of this window, which must outlive it.
  void serve(Gui& gui);
  // What was done since the last call; waits for something, `seconds` at most.
  std::vector<WindowEvent> events(double seconds);
  bool wants_to_close() const;
  void swap();
  void set_title(const std::string& title);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace render
