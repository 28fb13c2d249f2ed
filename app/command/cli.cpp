#include "app/command/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <ostream>
#include <thread>

#include "app/base/exit_code.h"
#include "app/base/nearest.h"
#include "app/base/shipped.h"
#include "app/command/cli_options.h"
#include "app/command/commands.h"
#include "app/command/manual.h"
#include "app/command/trade_cli.h"
#include "app/command/version.h"
#include "app/scene/basis_cache.h"
#include "render/context.h"

namespace app {
namespace {

constexpr int largest_size = 8192;  // pixels; what software rasterisers draw
constexpr int most_threads = 1024;
constexpr int most = 1'000'000'000;  // of a count

// KEY=VALUE; the value may hold more '='.
void add_override(std::vector<Override>& overrides, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw CLI::ValidationError("--set " + text, "must be KEY=VALUE, as in --set time.step=0.005");
  }
  overrides.push_back({text.substr(0, equals), text.substr(equals + 1), "--set " + text});
}

// "1280x720"
void read_size(Options& options, const std::string& text) {
  const char* const end = text.data() + text.size();
  const auto [x, width_error] = std::from_chars(text.data(), end, options.width);
  const bool has_x = width_error == std::errc{} && x != end && *x == 'x';
  const auto [rest, height_error] = std::from_chars(has_x ? x + 1 : end, end, options.height);
  const auto fits = [](int size) { return size >= 1 && size <= largest_size; };
  if (!has_x || height_error != std::errc{} || rest != end || !fits(options.width) || !fits(options.height)) {
    throw CLI::ValidationError("--size " + text, "must be WIDTHxHEIGHT in pixels, each 1 to 8192, as in 1280x720");
  }
}

void add_scene_options(CLI::App& command, Options& options) {
  add_named(command, "SCENE", options.scene, "Scene file (TOML), or the name of one that `ritz scenes` lists", "TEXT")
      ->required();
  command
      .add_option_function<std::string>(
          "--set", [&options](const std::string& text) { add_override(options.overrides, text); },
          "Set a key of the scene, as in --set time.step=0.005 or --set body.0.material.poisson=0.49; repeatable")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->trigger_on_parse();
  add_named(command, "--settings", options.settings, "TOML file whose keys overlay the scene", "FILE");
  for (const char* const name : {"seconds", "fps"}) {
    const std::string option = std::string("--") + name;
    command
        .add_option_function<std::string>(
            option,
            [&options, option, name](const std::string& value) {
              options.overrides.push_back({std::string("time.") + name, value, option + " " + value});
            },
            name == std::string_view("fps") ? "Frames per simulated second (time.fps)"
                                            : "Simulated time in s (time.seconds)")
        ->type_name("NUMBER")
        ->trigger_on_parse();
  }
  command
      .add_option("--threads", options.threads,
                  "Cores to use, all of them when not given; the results do not depend on it")
      ->check(CLI::Range(1, most_threads))
      ->type_name("N");
  command
      .add_option_function<std::uint64_t>(
          "--seed",
          [&options](const std::uint64_t& seed) {
            options.seed = seed;
            options.overrides.push_back({"seed", std::to_string(seed), "--seed " + std::to_string(seed)});
          },
          "Of everything random in a scene [1]")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N")
      ->trigger_on_parse();
  command.add_flag("--quiet", options.quiet, "No progress; errors only");
}

void add_output_options(CLI::App& command, Options& options) {
  CLI::Option* const out =
      add_named(command, "-o,--out", options.out, "Run folder; out/NAME of the scene file when not given", "DIR");
  add_named(command, "--resume", options.resume, "Go on in this run folder, from its state.bin", "DIR")->excludes(out);
  command.add_flag("--overwrite", options.overwrite, "Replace what an earlier run left in the run folder");
  command.add_flag("--vtu", options.vtu, "Write VTU files and a .pvd for ParaView, one per frame");
}

void add_size_options(CLI::App& command, Options& options, const char* what) {
  command
      .add_option_function<std::string>(
          "--size", [&options](const std::string& text) { read_size(options, text); }, what)
      ->type_name("WxH");
  command.add_option("--samples", options.samples, "Samples per pixel: 1 is fast and jagged, 8 slow and smooth")
      ->check(CLI::IsMember({1, 2, 4, 8}))
      ->type_name("N")
      ->capture_default_str();
}

std::vector<std::string> context_names() {
  std::vector<std::string> names;
  for (const render::OffscreenKind& kind : render::offscreen_kinds()) names.emplace_back(kind.name);
  return names;
}

void add_picture_options(CLI::App& command, Options& options) {
  add_size_options(command, options, "Size of a frame in pixels [1280x720]");
  CLI::Option* const every =
      command.add_option("--every", options.every, "Draw every N-th frame")->check(CLI::Range(1, most))->type_name("N");
  command.add_flag("--still", options.still, "Draw the last frame only")->excludes(every);
  command.add_option("--context", options.context, "What draws without a window, of the kinds that --version lists")
      ->envname("RITZ_CONTEXT")
      ->check(CLI::IsMember(context_names()))
      ->type_name("NAME");
  add_named(command, "--video", options.video, "Make a video with ffmpeg instead of frames: out.mp4 or out.gif",
            "FILE");
  command.add_flag("--panel", options.panel, "Draw the panel of `ritz view` into the frames");
  command.add_option("--replay", options.replay, "Draw a session that `ritz view --log` has written")
      ->type_name("FILE")
      ->check(CLI::ExistingFile)
      ->excludes("--resume", "--still", "--vtu");
}

void add_expect_options(CLI::App& command, Options& options) {
  CLI::Option* const expect =
      add_named(command, "--expect", options.expect,
                "Compare with the frame_*.png of this folder; exit code 4 where one differs", "DIR");
  expect->excludes(command.get_option("--resume"));
  command
      .add_option("--expect-difference", options.expect_difference,
                  "Pixels are equal when no channel differs by more than this, of 255")
      ->check(CLI::Range(0, 255))
      ->needs(expect)
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--expect-share", options.expect_share, "Share of the pixels that may differ")
      ->check(within(0, 1))
      ->needs(expect)
      ->type_name("SHARE")
      ->capture_default_str();
}

void add_trade_output_options(CLI::App& command, Options& options) {
  add_named(command, "-o,--out", options.out, "Folder; out/trade/NAME of the scene file when not given", "DIR");
  command.add_flag("--overwrite", options.overwrite, "Measure anew what an earlier trade left in the folder");
}

void add_stress_options(CLI::App& command, Options& options) {
  add_scene_options(command, options);
  command.get_option("SCENE")->required(false);
  add_named(command, "-o,--out", options.out, "Folder of stress.csv [out/stress]", "DIR");
  command.add_flag("--overwrite", options.overwrite, "Replace the stress.csv of an earlier run");
  command.add_flag("--quick", options.quick, "A part of the matrix, under a minute");
  command
      .add_option("--seeds", options.seeds,
                  "Run each case in which anything is random so often, with seeds from --seed on")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  command
      .add_option("--only", options.only,
                  "The cases with this in their name, as in --only \"start/*tet4*sdirk2\"; * is anything")
      ->type_name("PATTERN");
}

void add_modes_options(CLI::App& command, Options& options) {
  command.add_option("-n,--count", options.count, "How many modes of each body, the slowest first")
      ->check(CLI::Range(1, 1000))
      ->type_name("K")
      ->capture_default_str();
  add_named(command, "-o,--out", options.out, "Folder; out/modes/NAME of the scene file when not given", "DIR");
  command.add_flag("--overwrite", options.overwrite, "Replace what an earlier command left in the folder");
  add_size_options(command, options, "Size of a picture in pixels [1280x720]");
}

void add_residual_options(CLI::App& command, Options& options) {
  add_named(command, "PROBLEM", options.problem,
            "Problem file (TOML); those of assets/lectures/problems when not given", "TEXT");
  add_named(command, "-o,--out", options.out, "Folder; out/residuals or out/residuals/NAME when not given", "DIR");
  command.add_flag("--overwrite", options.overwrite, "Replace what an earlier run left in the folder");
  command.add_flag("--anyway", options.anyway, "Use Ritz's method where L is not self-adjoint, too");
}

void add_window_options(CLI::App& command, Options& options) {
  add_size_options(command, options, "Size of the window in pixels [1280x720]");
  add_named(command, "--log", options.log, "Write every input with its step, for ritz record --replay", "FILE");
  command.add_flag("--overwrite", options.overwrite, "Replace the file of --log");
  add_named(command, "-o,--out", options.out, "Folder of screenshots and saved scenes; the current one when not given",
            "DIR");
}

// The reference of keys needs no scene.
void add_explain_options(CLI::App& command, Options& options) {
  CLI::Option* const keys =
      command.add_flag("--keys", options.keys, "Print the reference of all keys of a scene, in Markdown");
  add_named(command, "--compare", options.compare,
            "Run folder with VTU files, made without a basis, beside which bodies with one are put", "DIR")
      ->excludes(keys);
  command.get_option("SCENE")->required(false);
  command.get_option("SCENE")->excludes(keys);
}

// What is wrong with the first argument, where that is to be a command; empty where nothing is.
std::string unknown_command(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().empty() || arguments.front()[0] == '-') return {};
  std::vector<std::string_view> names;
  for (const Command& command : commands()) names.push_back(command.name);
  if (std::ranges::find(names, arguments.front()) != names.end()) return {};
  return "there is no command \"" + arguments.front() + '"' + suggestion(arguments.front(), names);
}

}  // namespace

std::optional<Options> parse_command_line(const std::vector<std::string>& arguments, std::ostream& out,
                                          std::ostream& err, int& exit_code) {
  Options options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.cache = cache_folder();
  CLI::App app("Animates elastic bodies by the finite element method and draws them without a display.", "ritz");
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", version_text,
                       "Version, commit, compiler, what draws and the instructions of the processor that are used");
  bool manual = false, completion = false;
  app.add_flag("--manual", manual, "Print the manual page, for man");
  app.add_flag("--completion", completion, "Print the completion for bash");
  app.footer(
      "ritz COMMAND --help lists the options of a command. Exit codes: 0 done, 2 bad input,\n"
      "3 numerical failure, 4 frames differ from --expect, 130 interrupted.");

  for (const Command& command : commands()) app.add_subcommand(std::string(command.name), std::string(command.what));
  const auto command = [&](const char* name) -> CLI::App& { return *app.get_subcommand(name); };
  for (const char* const name : {"record", "run", "view", "explain", "trade", "modes"})
    add_scene_options(command(name), options);
  for (const char* const name : {"record", "run"}) add_output_options(command(name), options);
  add_picture_options(command("record"), options);
  add_window_options(command("view"), options);
  add_modes_options(command("modes"), options);
  add_expect_options(command("record"), options);
  add_trade_output_options(command("trade"), options);
  add_trade_options(command("trade"), options);
  add_size_options(command("trade"), options, "Of --show: each picture is half as wide and high [1280x720]");
  add_stress_options(command("stress"), options);
  add_residual_options(command("residuals"), options);
  CLI::App& explain = command("explain");
  add_explain_options(explain, options);
  command("scenes").add_flag("--names", options.names, "Print the names only");

  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    if (const std::string why = unknown_command(arguments); !why.empty()) throw CLI::ParseError(why, exit_bad_input);
    app.parse(reversed);
    if (explain.parsed() && !options.keys && options.scene.empty()) throw CLI::RequiredError("SCENE");
    if (manual || completion) {
      out << (manual ? manual_page(app) : bash_completion(app));
      exit_code = exit_done;
      return std::nullopt;
    }
  } catch (const CLI::ParseError& error) {
    exit_code = app.exit(error, out, err) == 0 ? exit_done : exit_bad_input;
    return std::nullopt;
  }
  if (app.get_subcommands().empty()) {
    out << app.help();
    exit_code = exit_bad_input;  // a script whose command is an empty variable is not to go on
    return std::nullopt;
  }
  options.command = app.get_subcommands().front()->get_name();
  options.scene = find_scene(options.scene);
  return options;
}

}  // namespace app
