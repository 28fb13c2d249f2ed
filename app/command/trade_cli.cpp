#include "app/command/trade_cli.h"

#include <CLI/CLI.hpp>

#include "app/command/cli_options.h"

namespace app {

namespace {

// Runs beside each other, as pictures.
CLI::Option* add_show_options(CLI::App& command, Options& options) {
  CLI::Option* const show =
      command
          .add_option(
              "--show", options.trade.show_names,
              "Draw reference, scene and advice beside each other, and the runs of these names; with --ablate the "
              "scene, and what it is without the features of these names")
          ->expected(0, -1)
          ->type_name("NAME");
  command.add_flag("--still", options.still, "Of --show, only the frame in which they differ most")->needs(show);
  add_named(command, "--video", options.video, "Of --show, a video made by ffmpeg instead of frames: out.mp4", "FILE")
      ->needs(show);
  // Without a name there is one empty name.
  command.parse_complete_callback([&options, show] {
    options.trade.show = show->count() > 0;
    std::erase(options.trade.show_names, "");
  });
  return show;
}

}  // namespace

void add_trade_options(CLI::App& command, Options& all) {
  TradeOptions& options = all.trade;
  CLI::Option* const minutes = command.add_option("--minutes", options.minutes, "Wall time that may be taken")
                                   ->check(within(0.05, 1e5))
                                   ->type_name("M")
                                   ->capture_default_str();
  command.add_flag("--quick", options.quick, "Under one minute")->excludes(minutes);
  CLI::Option* const target =
      command.add_option("--target", options.target, "Find the fastest settings within this error: 1%, 0.1%, 1px")
          ->type_name("ERROR");
  command
      .add_option("--budget", options.budget,
                  "Find the most accurate settings within this time: 33ms a frame, 60s for the scene, realtime")
      ->type_name("TIME")
      ->excludes(target);
  command.add_flag("--keep-mesh", options.keep_mesh, "Try no other mesh: --target bounds the time error");
  CLI::Option* const show = add_show_options(command, all);
  CLI::Option* const ablate = command.add_flag("--ablate", options.ablate,
                                               "Remove one feature of the scene at a time: what it costs and changes");
  add_named(command, "--compare", options.compare, "A second scene, or settings over this one, on the same diagram",
            "FILE")
      ->excludes(show)
      ->excludes(ablate);
  CLI::Option* const jobs = command.add_flag("--jobs", options.jobs, "List the cases that can be run independently")
                                ->excludes(show)
                                ->excludes(ablate);
  CLI::Option* const one = add_named(command, "--case", options.one_case, "Run one of them", "K")
                               ->excludes(jobs)
                               ->excludes(show)
                               ->excludes(ablate);
  command.add_flag("--collect", options.collect, "Table and advice from the cases that were run")
      ->excludes(jobs)
      ->excludes(one)
      ->excludes(ablate)
      ->excludes("--compare");
}

}  // namespace app
