// Bases that are kept in files: the same bits with and without them, and no trust in what is damaged or of another
// scene.
#include "app/scene/basis_cache.h"

#include <fstream>

#include "app/scene/basis_file.h"
#include "app/scene/simulation.h"
#include "sim/stepper.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

class BasisCache : public SceneFile {
 protected:
  const std::string beam_ =
      "[[body]]\nname = \"beam\"\nmesh = { rectangle = [4, 1], cells = [8, 2] }\nmaterial = { young = 1e6 }\n"
      "pin = [{ group = \"left\" }]\nbasis = { kind = \"derivatives\", count = 5, cubature = 0.05 }\n";
  const std::filesystem::path cache_ = folder_ / "cache";

  Simulation built(const std::filesystem::path& cache, const std::vector<Override>& overrides = {}) const {
    Options options;
    options.scene = file("scene.toml", beam_);
    options.overrides = overrides;
    options.cache = cache;
    return build_simulation(options);
  }
  std::filesystem::path kept(const std::vector<Override>& overrides = {}) const {
    return basis_file(cache_, load(beam_, overrides));
  }
  static std::uint64_t stepped(const Simulation& simulation) {
    const auto stepper = sim::make_stepper(*simulation.system, 1);
    sim::State state = simulation.system->initial_state();
    for (int k = 0; k < 5; ++k) EXPECT_EQ(stepper->step(state).failure, "");
    return sim::hash(state);
  }
  // What building says where the file is what it is now; it is whole afterwards.
  std::string said() const {
    const Simulation simulation = built(cache_);
    EXPECT_EQ(stepped(simulation), stepped(built({})));
    EXPECT_TRUE(built(cache_).document.remarks.empty());
    return simulation.document.remarks.empty() ? "" : simulation.document.remarks.front();
  }
};

TEST_F(BasisCache, HasTheSameBitsAsWhatIsMadeAnew) {
  const Simulation without = built({}), made = built(cache_);
  EXPECT_GT(made.basis_seconds, 0);
  ASSERT_TRUE(std::filesystem::exists(kept()));
  const Simulation taken = built(cache_);
  EXPECT_EQ(taken.basis_seconds, made.basis_seconds) << "what was taken tells what making it took";
  const sim::BasisVectors &a = *without.document.scene.bodies[0].basis->vectors,
                          &b = *taken.document.scene.bodies[0].basis->vectors;
  EXPECT_EQ(a.U, b.U);
  EXPECT_EQ(a.modes, b.modes);
  EXPECT_EQ(a.cubature->elements, b.cubature->elements);
  EXPECT_EQ(a.cubature->weights, b.cubature->weights);
  EXPECT_EQ(a.cubature->error, b.cubature->error);
  EXPECT_EQ(a.cubature->states, b.cubature->states);
  EXPECT_EQ(stepped(without), stepped(made));
  EXPECT_EQ(stepped(without), stepped(taken));
  EXPECT_EQ(said(), "");
}

TEST_F(BasisCache, IsNotTrustedWhereItIsDamaged) {
  EXPECT_EQ(said(), "");
  const std::string whole = read_all(kept());
  std::string bytes = whole;
  bytes[bytes.size() / 2] ^= 1;
  write_all(kept(), bytes);
  EXPECT_NE(said().find("is damaged (wrong checksum); they are made anew"), std::string::npos);
  EXPECT_EQ(read_all(kept()).size(), whole.size());
  write_all(kept(), whole.substr(0, whole.size() / 2));
  EXPECT_NE(said().find("made anew"), std::string::npos);
  write_all(kept(), "no such thing");
  EXPECT_NE(said().find("no file of bases"), std::string::npos);
}

TEST_F(BasisCache, IsNotTrustedWhereItIsOfAnotherScene) {
  const std::vector<Override> stiffer = {set("body.0.material.young", "2e6")};
  built(cache_, stiffer);
  std::filesystem::rename(kept(stiffer), kept());
  EXPECT_NE(said().find("are of another scene; they are made anew"), std::string::npos);
}

// A file with the right key and a right checksum may still be another program's.
TEST_F(BasisCache, NumbersThatNoBasisHasAreRefused) {
  const Simulation simulation = built({});
  const sim::Scene& scene = simulation.document.scene;
  const auto refused = [&](const auto& change) {
    auto vectors = std::make_shared<sim::BasisVectors>(*scene.bodies[0].basis->vectors);
    change(*vectors);
    return error_of([&] { decode_bases(encode({1, {vectors}}, 7), 7, scene, "file"); });
  };
  using Vectors = sim::BasisVectors;
  EXPECT_EQ(refused([](Vectors&) {}), "");
  for (const std::string& error :
       {refused([](Vectors& v) { v.U.conservativeResize(Eigen::NoChange, 4); }),
        refused([](Vectors& v) { v.U(3, 2) = std::nan(""); }), refused([](Vectors& v) { v.modes = 6; })})
    EXPECT_EQ(error, "file: the vectors hold numbers that no basis of this body has");
  for (const std::string& error :
       {refused([](Vectors& v) { v.cubature->elements.back() = 32; }),
        refused([](Vectors& v) { std::swap(v.cubature->elements[0], v.cubature->elements[1]); }),
        refused([](Vectors& v) { v.cubature->weights[0] = -1; }), refused([](Vectors& v) { v.cubature->states = 0; })})
    EXPECT_EQ(error, "file: the vectors hold numbers that no cubature has");
  EXPECT_EQ(refused([](Vectors& v) { v.cubature.reset(); }), "file: the vectors are of another cubature");
}

TEST_F(BasisCache, IsCalledAfterAllThatDeterminesWhatIsMade) {
  for (const auto& [key, value] : {std::pair{"body.0.basis.count", "6"},
                                   {"body.0.basis.kind", "modes"},
                                   {"body.0.basis.cubature", "0.04"},
                                   {"body.0.mesh.cells", "[9, 2]"},
                                   {"body.0.material.poisson", "0.2"},
                                   {"body.0.pin.0.group", "right"},
                                   {"body.0.mass", "consistent"},
                                   {"world.gravity", "[0.0, -5.0]"},
                                   {"body.0.velocity", "[0.0, 1.0]"}})
    EXPECT_NE(kept({set(key, value)}), kept()) << key;
  for (const auto& [key, value] : {std::pair{"time.integrator", "trapezoidal"},
                                   {"time.fps", "25"},
                                   {"solver.tolerance", "1e-6"},
                                   {"look.colour", "stress"},
                                   {"obstacle.0.sphere", "[[0.0, -9.0], 1.0]"}})
    EXPECT_EQ(kept({set(key, value)}), kept()) << key;
}

TEST_F(BasisCache, ThatCannotBeWrittenIsTold) {
  write_all(folder_ / "file", "in the way");
  const Simulation simulation = built(folder_ / "file/cache");
  ASSERT_EQ(simulation.document.remarks.size(), 1U);
  EXPECT_NE(simulation.document.remarks[0].find("not kept for the next run"), std::string::npos);
  EXPECT_EQ(stepped(simulation), stepped(built({})));
}

}  // namespace
}  // namespace app
