// The command line: what it fills in, and what it refuses.
#include "app/command/cli.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "app/base/output_file.h"
#include "app/base/processor.h"
#include "app/base/shipped.h"
#include "app/base/version.h"
#include "app/command/commands.h"
#include "render/context.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

struct Result {
  std::optional<Options> options;
  std::string out, err;
  int exit_code = 0;
};

Result parse(const std::vector<std::string>& arguments) {
  Result result;
  std::ostringstream out, err;
  result.options = parse_command_line(arguments, out, err, result.exit_code);
  result.out = out.str();
  result.err = err.str();
  return result;
}

TEST(CommandLine, EveryOptionOfRecordArrives) {
  const Result result =
      parse({"record", "bear.toml", "-o",      "runs/1",      "--size",  "320x180",       "--threads", "2",
             "--seed", "7",         "--quiet", "--overwrite", "--vtu",   "--every",       "3",         "--settings",
             "s.toml", "--video",   "a.mp4",   "--set",       "a.b=c=d", "--seconds=1.5", "--fps",     "24"});
  ASSERT_TRUE(result.options) << result.err;
  const Options& options = *result.options;
  EXPECT_EQ(options.command, "record");
  EXPECT_EQ(options.scene, "bear.toml");
  EXPECT_EQ(options.out, "runs/1");
  EXPECT_EQ(options.width, 320);
  EXPECT_EQ(options.height, 180);
  EXPECT_EQ(options.threads, 2);
  EXPECT_EQ(options.seed, 7U);
  EXPECT_TRUE(options.quiet && options.overwrite && options.vtu);
  EXPECT_FALSE(options.still);
  EXPECT_EQ(options.every, 3);
  EXPECT_EQ(options.settings, "s.toml");
  EXPECT_EQ(options.video, "a.mp4");
  ASSERT_EQ(options.overrides.size(), 4U);
  EXPECT_EQ(options.overrides[0].key, "seed");
  EXPECT_EQ(options.overrides[0].value, "7");
  EXPECT_EQ(options.overrides[1].key, "a.b");
  EXPECT_EQ(options.overrides[1].value, "c=d");
  EXPECT_EQ(options.overrides[1].origin, "--set a.b=c=d");
  EXPECT_EQ(options.overrides[2].key, "time.seconds");
  EXPECT_EQ(options.overrides[2].value, "1.5");
  EXPECT_EQ(options.overrides[2].origin, "--seconds 1.5");
  EXPECT_EQ(options.overrides[3].key, "time.fps");
}

TEST(CommandLine, OverridesKeepTheirOrder) {
  const Result result = parse({"run", "a.toml", "--set", "time.fps=1", "--fps", "2", "--set", "time.fps=3", "--set",
                               "body.0.pin=[{group = \"left\"}]"});
  ASSERT_TRUE(result.options) << result.err;
  ASSERT_EQ(result.options->overrides.size(), 4U);
  EXPECT_EQ(result.options->overrides[0].value, "1");
  EXPECT_EQ(result.options->overrides[1].value, "2");
  EXPECT_EQ(result.options->overrides[2].value, "3");
  EXPECT_EQ(result.options->overrides[3].value, "[{group = \"left\"}]");
}

TEST(CommandLine, DefaultsAreFilledIn) {
  const Result result = parse({"run", "scenes/bear.toml"});
  ASSERT_TRUE(result.options) << result.err;
  EXPECT_EQ(result.options->command, "run");
  EXPECT_GE(result.options->threads, 1);
  EXPECT_EQ(result.options->width, 1280);
  EXPECT_EQ(result.options->height, 720);
  EXPECT_TRUE(result.options->overrides.empty());
  EXPECT_TRUE(result.options->resume.empty());
}

TEST(CommandLine, ExplainPrintsKeysWithoutAScene) {
  const Result keys = parse({"explain", "--keys"});
  ASSERT_TRUE(keys.options) << keys.err;
  EXPECT_EQ(keys.options->command, "explain");
  EXPECT_TRUE(keys.options->keys);
  EXPECT_EQ(parse({"explain"}).exit_code, 2);
  EXPECT_FALSE(parse({"explain", "a.toml"}).options->keys);
}

TEST(CommandLine, HelpIsNotAnError) {
  const Result top = parse({"--help"});
  EXPECT_FALSE(top.options);
  EXPECT_EQ(top.exit_code, 0);
  for (const char* const command : {"record", "run", "explain"}) {
    EXPECT_NE(top.out.find(command), std::string::npos);
    const Result help = parse({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("--set KEY=VALUE"), std::string::npos) << help.out;
  }
  EXPECT_NE(parse({"record", "--help"}).out.find("1280x720"), std::string::npos);
}

TEST(CommandLine, MistakesAreBadInput) {
  const std::vector<std::vector<std::string>> mistakes = {
      {"recrod", "a.toml"},
      {"record"},
      {"record", "a.toml", "b.toml"},
      {"record", "a.toml", "--sizes", "1x1"},
      {"record", "a.toml", "--size", "1280"},
      {"record", "a.toml", "--size", "1280x"},
      {"record", "a.toml", "--size", "x720"},
      {"record", "a.toml", "--size", "0x720"},
      {"record", "a.toml", "--size", "8193x720"},
      {"record", "a.toml", "--size", "-5x720"},
      {"record", "a.toml", "--size", "12.5x720"},
      {"record", "a.toml", "--size", "1280x720x3"},
      {"record", "a.toml", "--every", "0"},
      {"record", "a.toml", "--every", "many"},
      {"record", "a.toml", "--every", "2", "--still"},
      {"record", "a.toml", "--threads", "0"},
      {"record", "a.toml", "--threads", "99999999999"},
      {"record", "a.toml", "--seed", "-1"},
      {"record", "a.toml", "--set", "time.fps"},
      {"record", "a.toml", "--set", "=3"},
      {"record", "a.toml", "--set"},
      {"record", ""},
      {"record", "a.toml", "-o", ""},
      {"record", "a.toml", "--resume", ""},
      {"record", "a.toml", "--video", ""},
      {"record", "a.toml", "--settings", ""},
      {"record", "a.toml", "--expect", ""},
      {"record", "a.toml", "--expect", "d", "--expect-share", "nan"},
      {"view", "a.toml", "--log", ""},
      {"trade", "a.toml", "--minutes", "nan"},
      {"trade", "a.toml", "--compare", ""},
      {"run", "a.toml", "--size", "1x1"},
      {"run", "a.toml", "--resume", "d", "-o", "e"},
      {"explain", "a.toml", "-o", "d"},
      {"explain", "a.toml", "--keys"},
  };
  for (const std::vector<std::string>& arguments : mistakes) {
    const Result result = parse(arguments);
    EXPECT_FALSE(result.options) << testing::PrintToString(arguments);
    EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(arguments);
    EXPECT_FALSE(result.err.empty()) << testing::PrintToString(arguments);
  }
  EXPECT_NE(parse({"record", "a.toml", "--size", "0x720"}).err.find("--size 0x720: must be WIDTHxHEIGHT"),
            std::string::npos);
  EXPECT_NE(parse({"recrod", "a.toml"}).err.find("no command \"recrod\"; did you mean \"record\"?"), std::string::npos);
  EXPECT_NE(parse({"record", "a.toml", "--set", "fps"}).err.find("--set fps: must be KEY=VALUE"), std::string::npos);
}

// Some versions of CLI11 break long lines.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) line += (line.empty() ? "" : " ") + word;
  return line;
}

TEST(CommandLine, AloneItPrintsTheHelp) {
  const Result result = parse({});
  EXPECT_FALSE(result.options);
  EXPECT_EQ(result.exit_code, 2);
  for (const Command& command : commands()) {
    EXPECT_NE(in_one_line(result.out).find(in_one_line(std::string(command.what))), std::string::npos) << result.out;
  }
}

TEST(CommandLine, TheVersionTellsWhatDraws) {
  const Result result = parse({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("ritz " + std::string(ritz_version) + "\n")) << result.out;
  for (const render::OffscreenKind& kind : render::offscreen_kinds()) {
    EXPECT_NE(result.out.find(std::string(kind.name) + ": "), std::string::npos) << result.out;
  }
  EXPECT_NE(result.out.find(__VERSION__), std::string::npos) << result.out;
}

TEST(CommandLine, TheContextIsOneOfThoseThatWereBuilt) {
  const std::string name(render::offscreen_kinds().back().name);
  EXPECT_EQ(parse({"record", "a.toml", "--context", name}).options->context, name);
  EXPECT_EQ(parse({"record", "a.toml", "--context", "vulkan"}).exit_code, 2);
  setenv("RITZ_CONTEXT", name.c_str(), 1);
  EXPECT_EQ(parse({"record", "a.toml"}).options->context, name);
  unsetenv("RITZ_CONTEXT");
  EXPECT_EQ(parse({"record", "a.toml"}).options->context, "");
}

TEST(CommandLine, AShippedSceneIsFoundByItsBareName) {
  const auto scene = [](const std::string& name) { return parse({"run", name}).options->scene; };
  EXPECT_EQ(read_all(scene("bear")), read_all(std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes/bear.toml"));
  EXPECT_TRUE(std::filesystem::exists(scene("benchmarks/cook")));
  EXPECT_EQ(scene("no-such-scene"), "no-such-scene");
  EXPECT_TRUE(std::filesystem::exists(scene("lectures/09-x-ray")));
  EXPECT_TRUE(std::filesystem::is_directory(scene("lectures")));
  const std::vector<std::string> names = shipped_scenes();
  EXPECT_NE(std::ranges::find(names, "bear"), names.end());
  EXPECT_LT(std::ranges::find(names, "twisted-beam"), std::ranges::find(names, "benchmarks/cook"));
}

TEST(CommandLine, TheManualAndTheCompletionHaveEveryCommandAndOption) {
  const std::string manual = parse({"--manual"}).out, completion = parse({"--completion"}).out;
  for (const Command& command : commands()) {
    EXPECT_NE(manual.find(".SS ritz " + std::string(command.name) + "\n"), std::string::npos) << manual;
    EXPECT_NE(completion.find("    " + std::string(command.name) + ") options="), std::string::npos) << completion;
  }
  EXPECT_NE(manual.find(".B \\-o,\\-\\-out DIR"), std::string::npos) << manual;
  EXPECT_NE(completion.find("--expect-share"), std::string::npos) << completion;
}

// The names of what this program was compiled for are known to the check, and this machine has them: it runs.
TEST(Processor, HasWhatThisProgramUses) {
  EXPECT_EQ(first_missing_instruction(needed_instructions), nullptr);
  const char* const others[] = {"of the future", nullptr};
  EXPECT_STREQ(first_missing_instruction(others), "of the future");
}

}  // namespace
}  // namespace app
