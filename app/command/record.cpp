#include <iostream>
#include <stdexcept>

#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/record/recorder.h"
#include "app/record/replay.h"
#include "app/record/start_picture.h"
#include "app/run/run_loop.h"
#include "app/run/run_start.h"
#include "app/scene/crossed_start.h"
#include "app/scene/deck.h"
#include "render/letters.h"

namespace app {
namespace {

// Told once, before the first frame.
void note_letters(const Simulation& simulation, const Options& options) {
  const Document& document = simulation.document;
  std::string words = document.title + document.look.caption;
  for (const sim::Body& body : document.scene.bodies) words += body.name;
  const std::string lacking = render::letters_that_lack(words);
  if (options.quiet || lacking.empty()) return;
  std::cerr << "note: the font (DejaVu Sans) lacks " << lacking << ": drawn as question marks\n";
}

// A scene whose bodies do not start apart is refused; --still draws where.
std::shared_ptr<const Simulation> built(const Options& options) {
  try {
    return std::make_shared<const Simulation>(build_simulation(options));
  } catch (const CrossedStart& error) {
    if (options.still) draw_start(options, error.places);
    throw;
  }
}

int record_page(const Options& options) {
  if (!options.replay.empty()) return replay(options);
  const auto simulation = built(options);
  note_letters(*simulation, options);
  const RunFolder folder = open_run_folder(options);
  const RunStart start = make_start(*simulation, folder, !options.resume.empty());
  Recorder recorder(simulation, folder, options);
  const Outcome outcome = run_loop(*simulation, options, folder, start, recorder);
  return judged(conclude(*simulation, options, folder, outcome), recorder, folder, options);
}

}  // namespace

// A folder of scenes is recorded page by page, each into a folder of its own; the first that fails ends it.
int record(const Options& options) {
  const std::vector<std::filesystem::path> pages = pages_of(options.scene);
  if (pages == std::vector{options.scene}) return record_page(options);
  if (!options.video.empty() || !options.replay.empty() || !options.resume.empty() || !options.expect.empty())
    throw std::runtime_error("--video, --replay, --resume and --expect are for one scene, and " +
                             options.scene.string() + " is a folder of them");
  std::filesystem::path deck = options.out;
  if (deck.empty())
    deck = std::filesystem::path("out") / std::filesystem::absolute(options.scene / "").parent_path().filename();
  for (const std::filesystem::path& page : pages) {
    Options one = options;
    one.scene = page;
    one.out = deck / page.stem();
    if (!options.quiet) std::cerr << page.string() << '\n';
    if (const int code = record_page(one); code != exit_done) return code;
  }
  return exit_done;
}

}  // namespace app
