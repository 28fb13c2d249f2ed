// What `ritz explain` prints, against what is known of the scene without it.
#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/scene/key_reference.h"
#include "app/scene/simulation.h"
#include "tests/app/session_scene.h"

namespace app {
namespace {

class Explain : public SessionScene {
 protected:
  static std::string said(const Options& options) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(explain(options), exit_done);
    return testing::internal::GetCapturedStdout();
  }
  // What is said behind a name, to the end of its line.
  static std::string said(const std::string& text, const std::string& name) {
    const std::size_t line = text.find("\n  " + name + "  ");
    if (line == std::string::npos) return "not said";
    const std::size_t value = text.find_first_not_of(' ', line + 3 + name.size());
    return text.substr(value, text.find('\n', value) - value);
  }
  Options with(const std::string& key, const std::string& value) const {
    Options changed = options();
    changed.overrides.push_back({key, value, "--set " + key + "=" + value});
    return changed;
  }
};

TEST_F(Explain, SaysTheTimesOfTheRun) {
  const std::string text = said(options());
  EXPECT_TRUE(text.starts_with("beam\ntime\n")) << text;
  EXPECT_EQ(said(text, "integrator"), "backward-euler");
  EXPECT_EQ(said(text, "seconds"), "0.5 s");
  EXPECT_EQ(said(text, "frames"), "11 at 20 per second, frame 0 the initial state");
  EXPECT_EQ(said(text, "steps"), "20, 2 per frame");
  EXPECT_EQ(said(text, "step h"), "0.025 s");
  const double stable = std::stod(said(text, "stable h"));
  EXPECT_NEAR(stable, build_simulation(options()).system->stable_step(), 0.006 * stable);
  EXPECT_EQ(said(said(with("time.integrator", "sdirk2")), "integrator"), "sdirk2");
}

// A static system weighs with consistent mass; the limit is that of the mass that the scene names.
TEST_F(Explain, AStaticSceneHasTheLimitOfItsOwnMass) {
  const auto limit = [&](const std::string& integrator, const std::string& mass) {
    Options changed = with("time.integrator", integrator);
    changed.overrides.push_back({"body.0.mass", mass, "--set body.0.mass=" + mass});
    return std::stod(said(said(changed), "stable h"));
  };
  for (const char* const mass : {"lumped", "consistent"})
    EXPECT_EQ(limit("static", mass), limit("backward-euler", mass)) << mass;
  EXPECT_LT(limit("static", "consistent"), 0.9 * limit("static", "lumped"));
}

// 4 x 2 x 2 cells of six tets each, 5 x 3 x 3 nodes, of which the 3 x 3 at the left are held. An edge of the mesh is an
// edge of a cell (96), a diagonal of a face between cells (68) or of a cell (16): two blocks of the matrix for each,
// and one for each node.
TEST_F(Explain, CountsTheMeshAndTheMatrix) {
  const std::string text = said(options());
  EXPECT_EQ(said(text, "nodes"), "45");
  EXPECT_EQ(said(text, "elements"), "96");
  EXPECT_EQ(said(text, "dofs"), "135, of which 108 free");
  EXPECT_EQ(said(text, "nonzeros"), std::to_string(9 * (45 + 2 * (96 + 68 + 16))));
  EXPECT_EQ(said(said(with("time.integrator", "central-difference")), "nonzeros"), "none: no matrix is formed");
}

TEST_F(Explain, SaysTheMemoryThatTheSystemCounts) {
  const auto bytes_said = [](const std::string& text) {
    const std::string memory = said(text, "memory"), about = "about ";
    EXPECT_TRUE(memory.starts_with(about)) << memory;
    EXPECT_TRUE(memory.ends_with(" MB, and 80 MB more to draw")) << memory;
    return 1e6 * std::stod(memory.substr(about.size()));
  };
  for (const Options& size : {options(), with("body.0.mesh.cells", "[16, 8, 8]")}) {
    const auto bytes = static_cast<double>(build_simulation(size).system->counts().bytes);
    EXPECT_NEAR(bytes_said(said(size)), bytes, 0.05 * bytes);
  }
}

TEST_F(Explain, NamesTheTermsOfTheScene) {
  EXPECT_NE(said(options()).find("terms\n  elastic beam: stable-neo-hookean, 96 tet4, 96 points\n"
                                 "  gravity: g = (0, -9.81, 0) m/s^2\ncounts\n"),
            std::string::npos)
      << said(options());
  EXPECT_EQ(said(with("world.gravity", "[0, 0, 0]")).find("gravity:"), std::string::npos);
}

// Those that were given, with unit and place; a value that is the default is no news, wherever it was given.
TEST_F(Explain, ListsTheKeysThatDiffer) {
  Options changed = with("time.fps", "40");
  changed.overrides.push_back({"time.integrator", "backward-euler", "--set time.integrator=backward-euler"});
  const std::string text = said(changed);
  const std::string file = (folder_ / "beam.toml").string();
  EXPECT_NE(text.find("\n  body.0.material.young = 1e+05  [Pa]  (" + file + ":9)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  body.0.pin.0.group = \"left\"  (" + file + ":10)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  time.fps = 40  [1/s]  (--set time.fps=40)\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("time.fps = 20"), std::string::npos);
  EXPECT_EQ(text.find("density ="), std::string::npos) << "1000 is the default";
  EXPECT_EQ(text.find("time.integrator ="), std::string::npos);
}

TEST_F(Explain, EndsWithWhatTheUserShouldKnow) {
  const auto warns = [&](const std::string& text) {
    return text.find("\nnote: locking: \"beam\"") != std::string::npos;
  };
  EXPECT_FALSE(warns(said(options())));
  EXPECT_TRUE(warns(said(with("body.0.material.poisson", "0.49"))));
}

TEST(ExplainKeys, PrintsTheReferenceAndReadsNoScene) {
  Options keys;
  keys.scene = "there is no such file";
  keys.keys = true;
  testing::internal::CaptureStdout();
  EXPECT_EQ(explain(keys), exit_done);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), key_reference_markdown());
  keys.keys = false;
  EXPECT_NE(error_of([&] { explain(keys); }), "");
}

}  // namespace
}  // namespace app
