// `ritz modes`: the frequencies of the bodies as a table, each mode as a picture.
#include "sim/study/modes.h"

#include <cstdio>
#include <iostream>
#include <numbers>

#include "app/base/exit_code.h"
#include "app/base/number_text.h"
#include "app/base/output_file.h"
#include "app/command/commands.h"
#include "app/picture/picture.h"
#include "app/scene/simulation.h"
#include "render/png.h"
#include "render/renderer.h"

namespace app {
namespace {

constexpr double shown = 0.1;  // largest displacement in a picture, of the body's size

std::string formatted(const char* format, double number) {
  char text[40];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::string picture_name(const sim::BodyRange& body, Eigen::Index mode) {
  char number[24];
  std::snprintf(number, sizeof number, "%02d", static_cast<int>(mode) + 1);
  return body.name + "-" + number + ".png";
}

// Every body at rest, and one of them in the mode.
sim::State state_in(const sim::System& system, const sim::BodyRange& body, const Eigen::VectorXd& shape) {
  sim::State state = system.initial_state();
  const int D = system.dimension();
  state.v.setZero();
  for (const sim::BodyRange& range : system.bodies()) {
    auto x = state.x.segment(Eigen::Index{D} * range.first_node, Eigen::Index{D} * range.node_count);
    x.setZero();
    for (int i = 0; i < range.node_count; ++i)
      x.segment(Eigen::Index{D} * i, range.mesh->dimension()) = range.mesh->X.col(i);
    if (&range != &body) continue;
    const double reach = shape.reshaped(D, range.node_count).colwise().norm().maxCoeff();
    x += shown * range.size / reach * shape;
  }
  return state;
}

class ModeBook {
 public:
  ModeBook(const Options& options, std::filesystem::path folder)
      : options_(options),
        folder_(std::move(folder)),
        simulation_(build_simulation(options)),
        renderer_(*context_, options.width, options.height, options.samples) {
    require_bodies(simulation_.document);
    simulation_.document.look.ghost = true;
    simulation_.document.look.colour = "plain";
    simulation_.document.look.ground = false;  // a mode goes below as well
    // The whole body is seen, whatever the scene looks at.
    Camera& camera = simulation_.document.camera;
    camera.eye.reset();
    camera.target.reset();
    camera.height.reset();
  }

  void write() {
    std::string table = "body,mode,omega,frequency\n";
    std::cout << "body            mode   omega [rad/s]  frequency [Hz]  picture\n";
    for (std::size_t b = 0; b < simulation_.system->bodies().size(); ++b) write_body(b, table);
    write_atomically(folder_ / "modes.csv", table, true);
  }

 private:
  void write_body(std::size_t number, std::string& table) {
    const sim::BodyRange& body = simulation_.system->bodies()[number];
    const sim::Modes modes = sim::vibration_modes(simulation_.document.scene, number, options_.count);
    if (modes.omega.size() == 0) std::cerr << "note: " << body.name << ": all of its nodes are pinned\n";
    if (const auto still = (modes.omega.array() == 0).count(); still > 0)
      std::cerr << "note: " << body.name << ": " << still
                << " of these modes cost no energy: rigid motions, or a flat membrane that moves across itself\n";
    for (Eigen::Index k = 0; k < modes.omega.size(); ++k) {
      const double omega = modes.omega[k], hertz = omega / (2 * std::numbers::pi);
      const std::string picture = picture_name(body, k);
      char line[160];
      std::snprintf(line, sizeof line, "%-16s%4d  %14.8g  %14.8g  %s", body.name.c_str(), static_cast<int>(k) + 1,
                    omega, hertz, picture.c_str());
      std::cout << line << '\n';
      table += body.name + "," + std::to_string(k + 1) + ",";
      append_number(table, omega);
      table += ",";
      append_number(table, hertz);
      table += "\n";
      draw(state_in(*simulation_.system, body, modes.shape.col(k)),
           body.name + ", mode " + std::to_string(k + 1) + ": " + formatted("%.6g", hertz) + " Hz", picture);
    }
  }

  void draw(const sim::State& state, const std::string& title, const std::string& name) {
    simulation_.document.title = title;
    simulation_.document.look.caption.clear();
    const Picture picture(*simulation_.system, simulation_.document, options_.width, options_.height);
    const render::Image image = renderer_.draw(picture.frame({.state = state}));
    write_atomically(folder_ / name, as_text(render::encode_png(image)), false);
  }

  const Options& options_;
  std::filesystem::path folder_;
  Simulation simulation_;
  std::unique_ptr<render::Context> context_ = render::make_offscreen_context();
  render::Renderer renderer_;
};

}  // namespace

int modes(const Options& options) {
  const std::filesystem::path folder =
      options.out.empty() ? std::filesystem::path("out") / "modes" / options.scene.stem() : options.out;
  if (std::filesystem::exists(folder / "modes.csv") && !options.overwrite)
    throw WriteError(folder.string() + ": holds modes already; choose another folder with -o, or give --overwrite");
  ModeBook book(options, folder);
  make_folder(folder);
  book.write();
  std::cerr << "modes.csv and pictures in " << folder.string() << '\n';
  return exit_done;
}

}  // namespace app
