// Scene files: what is read, and that a scene written out reads back equal.
#include "app/scene/keys.h"
#include "app/scene/scene_text.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

constexpr const char* plane_scene = R"([world]
gravity = [0, -2]
[[body]]
mesh = { rectangle = [2, 1], cells = [2, 2], element = "quad4", translate = [1, 0], rotate = { degrees = 90 }, scale = 2 }
thickness = 0.1
velocity = [1, 2]
spin = { rate = 3 }
pin = [{ box = [[0, 0], [1, 1]] }]
[[probe]]
name = "p"
body = "body0"
at = [0, 1]
[camera]
target = [0, 1]
height = 4
)";

TEST_F(SceneFile, EveryFieldIsFilled) {
  const Document document = load(beam_scene);
  const sim::Scene& scene = document.scene;
  EXPECT_EQ(document.title, "beam");
  EXPECT_EQ(scene.dimension, 3);
  EXPECT_EQ(scene.time.seconds, 1.5);
  EXPECT_EQ(scene.time.fps, 50);
  EXPECT_EQ(scene.time.substeps, 5);
  EXPECT_EQ(scene.time.integrator, "backward-euler");
  ASSERT_EQ(scene.bodies.size(), 1U);
  const sim::Body& beam = scene.bodies[0];
  EXPECT_EQ(beam.mesh.element_count(), 4 * 2 * 2 * 6);
  EXPECT_EQ(document.meshes[0].element, "tet4");
  ASSERT_EQ(beam.materials.size(), 1U);
  EXPECT_EQ(beam.materials[0].young, 2e5);
  EXPECT_EQ(beam.materials[0].density, 1000);
  EXPECT_EQ(beam.damping.beta, 0.01);
  ASSERT_EQ(beam.pins.size(), 2U);
  EXPECT_EQ(std::get<sim::Box>(beam.pins[0].where).high, Vec3(1e-6, 2, 2));
  EXPECT_EQ(beam.pins[0].release, 1.5);
  EXPECT_EQ(std::get<sim::Sphere>(beam.pins[1].where).radius, 0.1);
  EXPECT_EQ(beam.pins[1].axes, "xy");
  ASSERT_EQ(beam.pins[1].motion.size(), 2U);
  EXPECT_EQ(beam.pins[1].motion[1].t, 1.0);
  EXPECT_EQ(beam.pins[1].motion[1].translate, Vec3(0, 1, 0));
  EXPECT_EQ(beam.pins[1].motion[1].axis, Vec3(0, 1, 0));
  EXPECT_EQ(beam.pins[1].motion[1].degrees, 90);
  ASSERT_EQ(beam.loads.tractions.size(), 1U);
  EXPECT_EQ(std::get<sim::InGroup>(beam.loads.tractions[0].where).name, "right");
  EXPECT_EQ(beam.loads.tractions[0].value, Vec3(0, 5, 0));
  ASSERT_EQ(scene.obstacles.size(), 2U);
  EXPECT_EQ(std::get<sim::Plane>(scene.obstacles[0].shape).normal, Vec3(0, 0.6, 0.8));
  EXPECT_EQ(std::get<sim::Sphere>(scene.obstacles[1].shape).centre, Vec3(9, 0, 0));
  ASSERT_EQ(scene.probes.size(), 1U);
  EXPECT_EQ(scene.probes[0].at, Vec3(4, 0.5, 0.5));
  EXPECT_EQ(document.camera.eye, Vec3(2, 0.5, 7));
  EXPECT_FALSE(document.camera.target);
  EXPECT_EQ(document.look.range, (std::array<double, 2>{0, 1e5}));
  ASSERT_EQ(document.remarks.size(), 1U);
  EXPECT_EQ(document.remarks[0], "time.step = 0.004 s: 5 steps per frame, h = 0.004 s");
}

TEST_F(SceneFile, WhatIsEasilyMeantOtherwiseIsRemarked) {
  const std::string box = "[[body]]\nname = \"box\"\nmesh = { box = [1, 1, 1], cells = [1, 1, 1] }\n";
  const std::string sheet = "[[body]]\nname = \"sheet\"\nmesh = { rectangle = [1, 1], cells = [1, 1] }\n";
  EXPECT_EQ(load(sheet).remarks, std::vector<std::string>{}) << "in the plane";
  EXPECT_EQ(
      load(box + sheet).remarks,
      std::vector<std::string>{"sheet: a surface in space, taken as a membrane of thickness 1 m (body.thickness)"});
  EXPECT_EQ(load(box + sheet + "thickness = 1\n").remarks, std::vector<std::string>{});
  EXPECT_EQ(load(box + "[look]\nground_height = 0.25\n").remarks,
            std::vector<std::string>{"look.ground_height: the floor hides box, which begins 0.25 m below it"});
  EXPECT_EQ(load(box + "[look]\nground_height = 0\n").remarks, std::vector<std::string>{});
}

TEST_F(SceneFile, APlaneSceneHasTwoNumbers) {
  const Document document = load(plane_scene);
  const sim::Scene& scene = document.scene;
  EXPECT_EQ(scene.dimension, 2);
  EXPECT_EQ(scene.world.gravity, Vec3(0, -2, 0));
  EXPECT_EQ(scene.bodies[0].name, "body0");
  EXPECT_EQ(scene.bodies[0].velocity, Vec3(1, 2, 0));
  EXPECT_EQ(scene.bodies[0].spin.rate, 3);
  // [0, 2] x [0, 1], scaled by 2, turned by 90 degrees: [-2, 0] x [0, 4], moved by 1.
  const Eigen::MatrixXd& X = scene.bodies[0].mesh.X;
  ASSERT_EQ(X.rows(), 2);
  EXPECT_NEAR(X.row(0).minCoeff(), -1, 1e-12);
  EXPECT_NEAR(X.row(0).maxCoeff(), 1, 1e-12);
  EXPECT_NEAR(X.row(1).maxCoeff(), 4, 1e-12);
}

TEST_F(SceneFile, APlaneMeshBesideASolidIsAMembrane) {
  const Document document =
      load("[[body]]\nmesh = { rectangle = [1, 1], cells = [1, 1], translate = [0, 0, 2] }\n" + body("name = \"b\"\n"));
  EXPECT_EQ(document.scene.dimension, 3);
  EXPECT_EQ(document.scene.bodies[0].mesh.X.rows(), 3);
  EXPECT_EQ(document.scene.bodies[0].mesh.X.row(2).minCoeff(), 2);
}

TEST_F(SceneFile, RegionsStartFromTheMaterialOfTheBody) {
  const Document document = load(
      body("region = [{ group = \"left\", material = { young = 5.0 } }]\nmaterial = { young = 7.0, poisson = 0.1 }\n"));
  const auto& materials = document.scene.bodies[0].materials;
  ASSERT_EQ(materials.size(), 2U);
  EXPECT_EQ(materials[1].group, "left");
  EXPECT_EQ(materials[1].young, 5.0);
  EXPECT_EQ(materials[1].poisson, 0.1);
}

TEST_F(SceneFile, ExplicitSchemesChooseTheirSteps) {
  EXPECT_EQ(load(body("[time]\nintegrator = \"symplectic-euler\"\n")).scene.time.substeps, 0);
  EXPECT_EQ(load(body("[time]\nintegrator = \"symplectic-euler\"\nsubsteps = 9\n")).scene.time.substeps, 9);
  EXPECT_EQ(load(body("[time]\nintegrator = \"symplectic-euler\"\nsubsteps = \"auto\"\n")).scene.time.substeps, 0);
  EXPECT_EQ(load(body("")).scene.time.substeps, 1);
}

TEST_F(SceneFile, OverridesWinInTheirOrder) {
  const Document document =
      load(beam_scene,
           {set("time.fps", "24"), set("time.fps", "25"), set("body.0.material.poisson", "0.49"),
            set("time.integrator", "sdirk2"), set("body.0.pin", "[{ group = \"left\" }]"), set("time.substeps", "2"),
            set("look.range", "[1, 2]"), set("body.0.mesh.cells", "[1, 1, 1]"), set("title", "two words")});
  EXPECT_EQ(document.scene.time.fps, 25);
  EXPECT_EQ(document.scene.bodies[0].materials[0].poisson, 0.49);
  EXPECT_EQ(document.scene.bodies[0].materials[0].young, 2e5);
  EXPECT_EQ(document.scene.time.integrator, "sdirk2");
  EXPECT_EQ(document.scene.bodies[0].pins.size(), 1U) << "a list that is given as a whole replaces the old one";
  EXPECT_EQ(document.scene.time.substeps, 2) << "substeps replace the step of the file";
  EXPECT_EQ(document.scene.bodies[0].mesh.element_count(), 6);
  EXPECT_EQ(document.title, "two words");
}

TEST_F(SceneFile, AnOverrideCanTakeAnotherMesh) {
  const Document document = load(body(""), {set("body.0.mesh.sheet", "[1, 1]"), set("body.0.mesh.cells", "[2, 2]")});
  EXPECT_EQ(document.meshes[0].source, MeshSource::sheet);
  EXPECT_EQ(document.scene.bodies[0].mesh.element_count(), 8);
  EXPECT_EQ(document.scene.bodies[0].mesh.X.rows(), 3);
}

TEST_F(SceneFile, SettingsLieOverTheScene) {
  const std::filesystem::path settings =
      file("fast.toml", "time.substeps = 1\n[body.0.material]\nyoung = 9.0\n[look]\nwireframe = true\n");
  const Document document = load_scene(file("scene.toml", beam_scene), settings, {set("look.wireframe", "false")});
  EXPECT_EQ(document.scene.time.substeps, 1);
  EXPECT_EQ(document.scene.time.fps, 50);
  EXPECT_EQ(document.scene.bodies[0].materials[0].young, 9.0);
  EXPECT_EQ(document.scene.bodies[0].materials[0].poisson, 0.3);
  EXPECT_FALSE(document.look.wireframe);

  const std::filesystem::path wrong = file("wrong.toml", "\n[time]\nfps = 0\n");
  const std::string message = error_of([&] { load_scene(file("scene.toml", beam_scene), wrong); });
  EXPECT_TRUE(message.ends_with("wrong.toml:3: time.fps = 0: must be in [1, 1e+06]")) << message;
}

// Names of a table come in the order of their letters: 10 before 2.
TEST_F(SceneFile, EntriesOfAListMayBeNamedByNumber) {
  std::string text = body("");
  for (int i = 0; i < 12; ++i) {
    text +=
        "[probe." + std::to_string(i) + "]\nname = \"p" + std::to_string(i) + "\"\nbody = \"body0\"\nat = [0, 0, 0]\n";
  }
  const Document document = load(text);
  ASSERT_EQ(document.scene.probes.size(), 12U);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(document.scene.probes[i].name, "p" + std::to_string(i));
}

TEST_F(SceneFile, MeshFilesAreFoundFromTheScene) {
  file("meshes/two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  write_all(folder_ / "scenes/a.toml",
            "[[body]]\nmesh = { file = \"../meshes/two.obj\", element = \"tri6\", refine = 1 }\n");
  const Document document = load_scene(folder_ / "scenes/a.toml");
  EXPECT_EQ(document.scene.bodies[0].mesh.element_count(), 8);
  EXPECT_EQ(document.scene.bodies[0].mesh.kind, sim::ElementKind::tri6);
  EXPECT_NE(scene_toml(document, folder_ / "runs/1").find("\"../../meshes/two.obj\""), std::string::npos);
}

// The lists that hold the key have a first entry.
bool in_first_entries(const Key& key, const Document& document) {
  for (std::size_t at = key.path.find("[]."); at != std::string_view::npos; at = key.path.find("[].", at + 1)) {
    const Key& list = *find_key(key.path.substr(0, at + 2));
    if (list.binding.get(document, {}) == Value(std::int64_t{0})) return false;
  }
  return true;
}

// Text -> document -> text -> document -> text.
TEST_F(SceneFile, RoundTrip) {
  for (const std::string& text :
       {std::string(beam_scene), std::string(plane_scene),
        body("name = \"a \\\\ \\u00e9\"\nregion = [{ group = \"left\", material = { poisson = 0.123456789012345678 } "
             "}]\n"),
        std::string("title = \"a \\\"quoted\\\" \\n\\t\\u0001 title\"\n") + body("[look]\ncaption = \"\"\n"),
        body("[time]\nintegrator = \"central-difference\"\nseconds = 0.1\n[world]\ngravity = [1e-300, 0.1, 1e22]\n")}) {
    const Document first = load(text);
    const std::string written = scene_toml(first, folder_.path());
    const Document second = load(written);
    EXPECT_EQ(scene_toml(second, folder_.path()), written);
    for (const Key& key : keys()) {
      if (key.kind == Kind::table || !in_first_entries(key, first)) continue;
      EXPECT_EQ(key.binding.get(first, {}), key.binding.get(second, {})) << key.path;
    }
    EXPECT_EQ(first.scene.bodies[0].mesh.X, second.scene.bodies[0].mesh.X);
  }
}

TEST_F(SceneFile, DumpHoldsEveryDefault) {
  const std::string text = scene_toml(load(body("")), folder_.path());
  for (const char* const line :
       {"fps = 60\n", "tolerance = 1e-04\n", "gravity = [0.0, -9.81, 0.0]\n", "name = \"body0\"\n",
        "element = \"tet4\"", "poisson = 0.45", "grading = [1.0, 1.0, 1.0]", "fov = 30.0\n", "colour = \"plain\"\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << " is not in\n" << text;
  }
  const std::string json = scene_json(load(plane_scene), folder_.path());
  EXPECT_NE(json.find("\"gravity\": [0.0, -2.0]"), std::string::npos) << json;
  EXPECT_EQ(json.find("eye"), std::string::npos) << "a key of 3D scenes";
}

// What a start is given by is read, and written as it was given.
TEST_F(SceneFile, StartsAreGivenByAMatrixNodesOrAFile) {
  const std::string plane = "[[body]]\nmesh = { rectangle = [1, 1], cells = [1, 1] }\n";
  const Document affine = load(plane + "start = { shape = \"affine\", matrix = [[1, 0.2], [0, 0.8]] }");
  EXPECT_EQ(affine.scene.bodies[0].start.matrix, (std::vector<double>{1, 0.2, 0, 0.8}));
  EXPECT_NE(scene_toml(affine, {}).find("matrix = [[1.0, 0.2], [0.0, 0.8]]"), std::string::npos);
  const Document listed = load(plane + "start = { shape = \"nodes\", nodes = [[0, 0], [1, 0], [0, 1], [1, 2]] }");
  ASSERT_EQ(listed.scene.bodies[0].start.nodes.size(), 4U);
  EXPECT_EQ(listed.scene.bodies[0].start.nodes[3], Vec3(1, 2, 0));
  file("x.txt", "0 0\n1 0 # corner\n\n0 1\n1 2\n");
  const Document from_file = load(plane + "start = { shape = \"nodes\", file = \"x.txt\" }");
  EXPECT_EQ(from_file.scene.bodies[0].start.nodes, listed.scene.bodies[0].start.nodes);
  const std::string text = scene_toml(from_file, folder_.path());
  EXPECT_NE(text.find("file = \"x.txt\""), std::string::npos);
  EXPECT_EQ(text.find("nodes = [["), std::string::npos) << "told by the file's name";
  file("bad.txt", "0 0\n1 0 3\n");
  EXPECT_NE(error(plane + "start = { shape = \"nodes\", file = \"bad.txt\" }").find("bad.txt:2"), std::string::npos);
  EXPECT_NE(error(plane + "start = { shape = \"affine\", matrix = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }")
                .find("must have rows of 2 numbers"),
            std::string::npos);
}

}  // namespace
}  // namespace app
