#include "render/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include <array>
#include <cstdlib>
#include <utility>

namespace render {
namespace {

// GLFW, for as long as there is a window.
struct Library {
  Library() {
#ifdef GLFW_PLATFORM
    // Since 3.4 GLFW tries Wayland first, whose library writes a line of its own where it is told of no folder to look
    // in.
    if (std::getenv("XDG_RUNTIME_DIR") == nullptr) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfwInit() == GLFW_TRUE) return;
    const char* why = nullptr;
    glfwGetError(&why);
    throw NoDisplay(why != nullptr ? why : "GLFW cannot be initialised");
  }
  ~Library() {
    glfwTerminate();
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

GLFWwindow* open_window(int width, int height, const std::string& title) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // pictures are drawn into a framebuffer of their own
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  GLFWwindow* const window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window != nullptr) return window;
  const char* why = nullptr;
  glfwGetError(&why);
  throw NoDisplay(why != nullptr ? why : "no window with OpenGL 3.3 can be opened");
}

// Dear ImGui takes places of the mouse as events since 1.87.
void move_mouse(ImGuiIO& io, ImVec2 place) {
#if IMGUI_VERSION_NUM >= 18700
  io.AddMousePosEvent(place.x, place.y);
#else
  io.MousePos = place;
#endif
}

constexpr std::array<std::pair<int, Key>, 9> known_keys = {{{GLFW_KEY_SPACE, Key::space},
                                                            {GLFW_KEY_LEFT, Key::left},
                                                            {GLFW_KEY_RIGHT, Key::right},
                                                            {GLFW_KEY_BACKSPACE, Key::backspace},
                                                            {GLFW_KEY_PAGE_UP, Key::page_up},
                                                            {GLFW_KEY_PAGE_DOWN, Key::page_down},
                                                            {GLFW_KEY_ESCAPE, Key::escape},
                                                            {GLFW_KEY_TAB, Key::tab},
                                                            {GLFW_KEY_F1, Key::f1}}};

}  // namespace

struct Window::Parts {
  Parts(int width, int height, const std::string& title) : window(open_window(width, height, title)) {}
  ~Parts() { glfwDestroyWindow(window); }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  static Parts& of(GLFWwindow* window) { return *static_cast<Parts*>(glfwGetWindowUserPointer(window)); }
  WindowEvent event(WindowEvent::Kind kind) const;
  void listen();

  Library library;
  GLFWwindow* window;
  double mouse_x = 0, mouse_y = 0;  // in pixels of the desktop
  std::vector<WindowEvent> events;
  const Gui* gui = nullptr;  // that is served
};

// With the mouse and the control key as they were when it happened: asked now, the mouse may have moved on.
WindowEvent Window::Parts::event(WindowEvent::Kind kind) const {
  int desktop = 1, pixels = 1, other = 0;
  glfwGetWindowSize(window, &desktop, &other);
  glfwGetFramebufferSize(window, &pixels, &other);
  const double scale = desktop > 0 ? static_cast<double>(pixels) / desktop : 1;
  WindowEvent event;
  event.kind = kind;
  event.x = static_cast<float>(mouse_x * scale);
  event.y = static_cast<float>(mouse_y * scale);
  event.control = glfwGetKey(window, GLFW_KEY_LEFT_CONTROL) == GLFW_PRESS ||
                  glfwGetKey(window, GLFW_KEY_RIGHT_CONTROL) == GLFW_PRESS;
  return event;
}

// Events are queued, so that a key pressed and let go between two pictures is not missed.
void Window::Parts::listen() {
  glfwSetWindowUserPointer(window, this);
  glfwGetCursorPos(window, &mouse_x, &mouse_y);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
    if (action == GLFW_RELEASE) return;
    Parts& parts = of(w);
    WindowEvent event = parts.event(WindowEvent::Kind::key);
    event.control = (mods & GLFW_MOD_CONTROL) != 0;
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) {
      event.letter = static_cast<char>('A' + (key - GLFW_KEY_A));
      return parts.events.push_back(event);
    }
    for (const auto& [code, known] : known_keys) {
      if (code != key) continue;
      event.key = known;
      parts.events.push_back(event);
    }
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    Parts& parts = of(w);
    WindowEvent event = parts.event(action == GLFW_PRESS ? WindowEvent::Kind::press : WindowEvent::Kind::release);
    event.button = static_cast<Button>(button);  // GLFW numbers them left, right, middle
    event.control = (mods & GLFW_MOD_CONTROL) != 0;
    parts.events.push_back(event);
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    Parts& parts = of(w);
    parts.mouse_x = x;
    parts.mouse_y = y;
    parts.events.push_back(parts.event(WindowEvent::Kind::move));
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double notches) {
    Parts& parts = of(w);
    WindowEvent event = parts.event(WindowEvent::Kind::scroll);
    event.scroll = static_cast<float>(notches);
    parts.events.push_back(event);
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { of(w).events.push_back({}); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).events.push_back({}); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).events.push_back({}); });
}

Window::Window(int width, int height, const std::string& title) : parts_(nullptr) {
  parts_ = std::make_unique<Parts>(width, height, title);
  parts_->listen();
  make_current();
  glfwSwapInterval(1);
}

Window::~Window() = default;

void Window::make_current() {
  if (glfwGetCurrentContext() != parts_->window) glfwMakeContextCurrent(parts_->window);
}

Context::Getter Window::getter() const {
  return glfwGetProcAddress;
}

int Window::width() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(parts_->window, &width, &height);
  return width;
}

int Window::height() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(parts_->window, &width, &height);
  return height;
}

float Window::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(parts_->window, &x, &y);
  return x > 0 ? x : 1;
}

void Window::serve(Gui& gui) {
  gui.use([this] { ImGui_ImplGlfw_InitForOpenGL(parts_->window, true); });
  // The backend counts in pixels of the desktop, everything here in those of the framebuffer.
  const auto feed = [this](int width, int height) {
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    const bool here = glfwGetWindowAttrib(parts_->window, GLFW_HOVERED) == GLFW_TRUE || ImGui::IsAnyMouseDown();
    const bool scaled = io.DisplaySize.x != static_cast<float>(width) || io.DisplaySize.y != static_cast<float>(height);
    if (io.DisplaySize.x > 0 && io.DisplaySize.y > 0 && here && scaled) {
      move_mouse(io, {static_cast<float>(parts_->mouse_x) * static_cast<float>(width) / io.DisplaySize.x,
                      static_cast<float>(parts_->mouse_y) * static_cast<float>(height) / io.DisplaySize.y});
    }
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DisplayFramebufferScale = {1, 1};
  };
  parts_->gui = &gui;
  gui.listen(feed, [this] {
    ImGui_ImplGlfw_Shutdown();
    parts_->gui = nullptr;
  });
}

std::vector<WindowEvent> Window::events(double seconds) {
  const auto collect = [seconds] { seconds > 0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents(); };
  // The backend takes its events to the context that is in use.
  if (parts_->gui != nullptr) {
    parts_->gui->use(collect);
  } else {
    collect();
  }
  return std::exchange(parts_->events, {});
}

bool Window::wants_to_close() const {
  return glfwWindowShouldClose(parts_->window) == GLFW_TRUE;
}

void Window::swap() {
  glfwSwapBuffers(parts_->window);
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(parts_->window, title.c_str());
}

}  // namespace render
