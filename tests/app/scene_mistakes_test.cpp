// Scene files that are refused, and with which words.
#include "sim/mesh/input_error.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

struct BadScene {
  std::string text;
  std::string message;
};

// error: of a scene of this text.
template <class Error>
void expect_messages(const std::vector<BadScene>& cases, const Error& error) {
  for (const BadScene& bad : cases) {
    const std::string message = error(bad.text);
    EXPECT_NE(message.find(bad.message), std::string::npos)
        << bad.text << "\ngave: " << message << "\nnot: " << bad.message;
  }
}

TEST_F(SceneFile, MistakesAreNamedWithTheirLine) {
  const std::vector<BadScene> cases = {
      {"", "scene.toml: 'body' is missing: An elastic body."},
      {"[time]\nfsp = 30\n", "scene.toml:2: unknown key 'time.fsp': did you mean 'fps'?"},
      {"[tiem]\nfps = 30\n", "scene.toml:1: unknown key 'tiem': did you mean 'time'?"},
      {"\nfps = 30\n", "scene.toml:2: unknown key 'fps': did you mean 'time.fps'?"},
      {"[look]\nqqqqqqqqq = 1\n",
       "scene.toml:2: unknown key 'look.qqqqqqqqq': known here are style, colour, range, colour_map, finish, smooth, "
       "background, shadows, ground, ground_height, obstacles, wireframe, ghost, pins, forces, contact_forces, "
       "force_scale, "
       "velocities, "
       "velocity_scale, caption, labels, energies, axes, scale_bar"},
      {body("material = { yuong = 1 }\n"), "scene.toml:3: unknown key 'body.0.material.yuong': did you mean 'young'?"},
      {"[time]\nfps = \n", "scene.toml:2: "},
      {"[[body]]\nmesh = {\n  file = \"a.obj\"\n}\n",
       "saw '\\n'; a table in braces stands on one line: join its lines, or write it as [body.mesh]"},
      {body("") + "[[contact]]\nbetween = [\"body0\", \"cat\"]\n",
       "scene.toml:4: contact.0.between = [\"body0\", \"cat\"]: there is no body \"cat\"; there are: body0"},
      {"[time]\nfps = 1\nfps = 2\n", "scene.toml:3: "},
      {"[time]\nfps = 30.5\n", "scene.toml:2: time.fps = 30.5: must be an integer"},
      {"[time]\nfps = \"fast\"\n", "scene.toml:2: time.fps = \"fast\": must be an integer"},
      {"[time]\nfps = 0\n", "scene.toml:2: time.fps = 0: must be in [1, 1e+06]"},
      {"[time]\nfps = 9223372036854775807\n", "scene.toml:2: time.fps = 9223372036854775807: must be in [1, 1e+06]"},
      {"[time]\nseconds = nan\n", "scene.toml:2: time.seconds = nan: must be finite"},
      {"[time]\nseconds = inf\n", "scene.toml:2: time.seconds = inf: must be finite"},
      {"[time]\nseconds = 0\n", "scene.toml:2: time.seconds = 0: must be in (0, 1e+06]"},
      {"[time]\nsubsteps = \"many\"\n", "scene.toml:2: time.substeps = \"many\": must be an integer or \"auto\""},
      {"[time]\nintegrator = \"euler\"\n",
       "scene.toml:2: time.integrator = \"euler\": must be one of \"symplectic-euler\""},
      {"time = 3\n", "scene.toml:1: time = 3: must be a table"},
      {"body = 3\n", "scene.toml:1: body = 3: must be a list of tables"},
      {"[body]\nname = \"a\"\n",
       "scene.toml:2: 'body.name': body is a list: its entries are numbered from 0, as in 'body.0'"},
      {"body = [3]\n", "scene.toml:1: body.0 = 3: must be a table"},
      {"[world]\ngravity = -9.81\n", "scene.toml:2: world.gravity = -9.81: must be a point [x, y, z], in 2D [x, y]"},
      {"[world]\ngravity = [0, 1, 2, 3]\n", "scene.toml:2: world.gravity = [0, 1, 2, 3]: must be a point"},
      {"[world]\ngravity = [0, nan, 0]\n", "scene.toml:2: world.gravity = [0, nan, 0]: must be finite"},
      {"[look]\nwireframe = 1\n", "scene.toml:2: look.wireframe = 1: must be true or false"},
      {"[look]\nrange = [0, 1, 2]\n", "scene.toml:2: look.range = [0, 1, 2]: must be a list of 2 numbers"},
      {"title = 1979-05-27\n", "scene.toml:1: title = a date or time: must be a string"},
  };
  expect_messages(cases, [&](const std::string& text) { return error(text); });
}

TEST_F(SceneFile, MistakesOfABodyAreNamedWithTheirLine) {
  const std::vector<BadScene> cases = {
      {body("material = { poisson = 0.6 }\n"), "scene.toml:3: body.0.material.poisson = 0.6: must be in (-1, 0.5)"},
      {body("material = { poisson = 0.5 }\n"), "scene.toml:3: body.0.material.poisson = 0.5: must be in (-1, 0.5)"},
      {body("material = { young = 0 }\n"), "scene.toml:3: body.0.material.young = 0: must be > 0"},
      {body("material = { young = -1e6 }\n"), "scene.toml:3: body.0.material.young = -1e+06: must be > 0"},
      {body("material = { density = 0.0 }\n"), "scene.toml:3: body.0.material.density = 0.0: must be > 0"},
      {body("name = \"\"\n"),
       "scene.toml:3: body.0.name = \"\": must be a string without comma, quote or line end, not empty"},
      {body("name = \"a,b\"\n"), "scene.toml:3: body.0.name = \"a,b\": must be a string without comma"},
      {body("name = \"a\"\n") + body("name = \"a\"\n"),
       "scene.toml:6: body.1.name = \"a\": is the name of another one already"},
      {body("pin = [{ axes = \"xw\", box = [[0,0,0],[1,1,1]] }]\n"),
       "scene.toml:3: body.0.pin.0.axes = \"xw\": must be a string of some of x, y, z"},
      {body("pin = [{ axes = \"\", box = [[0,0,0],[1,1,1]] }]\n"), "scene.toml:3: body.0.pin.0.axes = \"\": must be"},
      {body("pin = [{ box = [[0,0,0],[1,-1,1]] }]\n"),
       "scene.toml:3: body.0.pin.0.box = [[0, 0, 0], [1, -1, 1]]: must be [low, high] with no coordinate of low above"},
      {body("pin = [{ box = [[0,0,0],[1,1]] }]\n"),
       "scene.toml:3: body.0.pin.0.box = [[0, 0, 0], [1, 1]]: must be points of the same number of coordinates"},
      {body("pin = [{ sphere = [[0,0,0],0] }]\n"),
       "scene.toml:3: body.0.pin.0.sphere = [[0, 0, 0], 0]: must be [centre, radius]"},
      {body("pin = [{ axes = \"x\" }]\n"), "scene.toml:3: body.0.pin.0: must have exactly one of box, sphere, group"},
      {body("pin = [{ group = \"left\", sphere = [[0,0,0],1] }]\n"),
       "scene.toml:3: body.0.pin.0: must have exactly one of"},
      {body("pin = [{ group = \"lfet\" }]\n"),
       "scene.toml:3: body.0.pin.0.group = \"lfet\": the mesh has no group \"lfet\""},
      {body("traction = [{ group = \"lfet\", value = [0,0,0] }]\n"),
       "scene.toml:3: body.0.traction.0.group = \"lfet\": "},
      {body("traction = [{ group = \"left\" }]\n"),
       "scene.toml:3: body.0.traction.0: 'value' is missing: Force per area at rest."},
      {body("region = [{ material = {} }]\n"), "scene.toml:3: body.0.region.0: 'group' is missing"},
      {body("region = [{ group = \"soft\" }]\n"),
       "scene.toml:3: body.0.region.0.group = \"soft\": the mesh has no group"},
      {body("pin = [{ group = \"left\", motion = { keyframes = [[1, {}], [1, {}]] } }]\n"),
       "scene.toml:3: body.0.pin.0.motion.keyframes.1.0 = 1: must be later than the pose before it"},
      {body("pin = [{ group = \"left\", motion = { keyframes = [[{}, 1]] } }]\n"),
       "scene.toml:3: body.0.pin.0.motion.keyframes.0.0 = { }: must be a number"},
      {body("pin = [{ group = \"left\", motion = { keyframes = [[0, {}, 1]] } }]\n"),
       "scene.toml:3: body.0.pin.0.motion.keyframes.0 = [0, { }, 1]: has too many entries"},
      {body("pin = [{ group = \"left\", motion = { keyframes = [[]] } }]\n"),
       "scene.toml:3: body.0.pin.0.motion.keyframes.0: '0' is missing: Time of the pose."},
      {body("spin = { axis = [0, 0, 0] }\n"),
       "scene.toml:3: body.0.spin.axis = [0, 0, 0]: must be different from zero"},
  };
  expect_messages(cases, [&](const std::string& text) { return error(text); });
}

TEST_F(SceneFile, MistakesBesideABodyAreNamedWithTheirLine) {
  const std::vector<BadScene> cases = {
      {body("[time]\nstep = 0.01\nsubsteps = 2\n"), "scene.toml:3: time: can have only one of substeps, step"},
      {body("[[obstacle]]\nfriction = 0.1\n"), "scene.toml:3: obstacle.0: must have exactly one of plane, sphere"},
      {body("[[obstacle]]\nplane = { point = [0, 0, 0] }\n"), "scene.toml:4: obstacle.0.plane: 'normal' is missing"},
      {body("[[probe]]\nbody = \"b\"\nat = [0, 0, 0]\n"),
       "scene.toml:3: probe.0: 'name' is missing: Name of the probe, with which its columns in probes.csv begin."},
      {body("[[probe]]\nname = \"a\"\nbody = \"b\"\nat = [0, 0, 0]\n"),
       "scene.toml:5: probe.0.body = \"b\": there is no body \"b\"; there are: body0"},
      {body("[camera]\neye = [1, 1, 1]\ntarget = [1, 1, 1]\n"),
       "scene.toml:5: camera.target = [1, 1, 1]: must differ from camera.eye"},
      {body("[camera]\neye = [0, 9, 0]\ntarget = [0, 0, 0]\n"),
       "camera.eye = [0, 9, 0]: up must not lie along the line"},
      {body("[look]\nrange = [2, 1]\n"), "scene.toml:4: look.range = [2, 1]: must be [low, high] with low < high"},
      {body("[look]\ncaption = \"{t} s, {tme}\"\n"),
       "scene.toml:4: look.caption = \"{t} s, {tme}\": {tme} is not known"},
      {body("[look]\naxes = true\n"), "scene.toml:4: look.axes = true: is for 2D only"},
      {body("[look]\ncolour_map = \"jet\"\n"), "must be one of \"viridis\""},
      {body("[solver]\nlinear = \"lu\"\n"),
       "solver.linear = \"lu\": must be one of \"auto\", \"two-level\", \"cholmod\", \"pcg\", \"pcg-assembled\""},
      {body("[solver]\ndefiniteness = \"some\"\n"), "must be one of \"clamp\", \"abs\", \"none\""},
      {body("[solver]\non_failure = \"panic\"\n"), "must be one of \"split\", \"accept\", \"stop\""},
      {body("[camera]\nfollow = \"cat\"\n"),
       "scene.toml:4: camera.follow = \"cat\": there is no body \"cat\"; there are: body0"},
      {body("[camera]\nkeyframes = [[1, {}], [1, { turn = 3 }]]\n"),
       "scene.toml:4: camera.keyframes.1.0 = 1: must be later than the pose before it"},
      {body("[camera]\nheight = 2\n"), "scene.toml:4: camera.height = 2: is for 2D only, and the scene is 3D"},
      {body("[world]\ngravity = [0, -1]\n"),
       "scene.toml:4: world.gravity = [0, -1]: must have 3 numbers: the scene is 3D"},
  };
  expect_messages(cases, [&](const std::string& text) { return error(text); });
}

// In the order of the file, whichever way they are found: unknown keys, values, what is missing, what does not fit.
// What may follow from another mistake in the same body is not told.
TEST_F(SceneFile, EveryMistakeIsToldAtOnce) {
  const std::string text =
      "[time]\nfps = 0\nfsp = 3\n"
      "[look]\nrange = [2, 1]\n"
      "[[body]]\nmesh = { box = [1, 1, 1], cells = [1, 1, 1] }\n"
      "material = { poisson = 0.6, model = \"neohookean\" }\npin = [{ group = \"lfet\" }]\n"
      "[[body]]\nmesh = { box = [1, 1, 1], cells = [1, 1, 1] }\n"
      "traction = [{ group = \"lfet\", value = [0, 0, 0] }]\n"
      "[[probe]]\nbody = \"body0\"\nat = [0, 0, 0]\n";
  EXPECT_EQ(
      error(text, {set("world.gravity", "3")}),
      "scene.toml:2: time.fps = 0: must be in [1, 1e+06]\n"
      "scene.toml:3: unknown key 'time.fsp': did you mean 'fps'?\n"
      "scene.toml:5: look.range = [2, 1]: must be [low, high] with low < high\n"
      "scene.toml:8: body.0.material.poisson = 0.6: must be in (-1, 0.5)\n"
      "scene.toml:8: body.0.material.model = \"neohookean\": must be one of \"linear\", \"corotated\", \"stvk\", "
      "\"fixed-corotated\", \"neo-hookean\", \"stable-neo-hookean\"; did you mean \"neo-hookean\"?\n"
      "scene.toml:12: body.1.traction.0.group = \"lfet\": the mesh has no group \"lfet\"; its groups are \"left\", "
      "\"right\", \"bottom\", \"top\", \"back\", \"front\"; did you mean \"left\"?\n"
      "scene.toml:13: probe.0: 'name' is missing: Name of the probe, with which its columns in probes.csv begin.\n"
      "--set world.gravity=3: must be a point [x, y, z], in 2D [x, y]");
}

// A key that is refused is not missed as well, and neither is the one that a misspelt key stood for.
TEST_F(SceneFile, OneMistakeIsToldOnce) {
  EXPECT_EQ(error("body = 3\n"), "scene.toml:1: body = 3: must be a list of tables");
  EXPECT_EQ(error("[[body]]\nmseh = { box = [1, 1, 1], cells = [1, 1, 1] }\n"),
            "scene.toml:2: unknown key 'body.0.mseh': did you mean 'mesh'?");
  EXPECT_EQ(error("[[body]]\nmesh = { bix = [1, 1, 1], cells = [1, 1, 1] }\n"),
            "scene.toml:2: unknown key 'body.0.mesh.bix': did you mean 'box'?");
}

TEST_F(SceneFile, MistakesInAPlaneScene) {
  const std::string plate = "[[body]]\nmesh = { rectangle = [1, 1], cells = [1, 1] }\n";
  const std::vector<BadScene> cases = {
      {"[world]\ngravity = [0, -9.81, 0]\n",
       "scene.toml:4: world.gravity = [0, -9.81, 0]: must have 2 numbers: the scene is 2D"},
      {"pin = [{ box = [[0, 0, 0], [1, 1, 1]] }]\n",
       "scene.toml:3: body.0.pin.0.box = [[0, 0, 0], [1, 1, 1]]: must have points of 2 numbers"},
      {"spin = { axis = [1, 0, 0] }\n", "scene.toml:3: body.0.spin.axis = [1, 0, 0]: must be along [0, 0, 1]"},
      {"[camera]\neye = [0, 0]\n", "scene.toml:4: camera.eye = [0, 0]: is for 3D only, and the scene is 2D"},
  };
  expect_messages(cases, [&](const std::string& text) { return error(plate + text); });
}

TEST_F(SceneFile, MistakesInTheMesh) {
  const std::vector<BadScene> cases = {
      {"", "scene.toml:1: body.0: 'mesh' is missing"},
      {"mesh = {}\n", "scene.toml:2: body.0.mesh: must have exactly one of box, rectangle, sheet, file"},
      {"mesh = { box = [1, 1], cells = [1, 1] }\n", "body.0.mesh.box = [1, 1]: must be a list of 3 numbers"},
      {"mesh = { box = [1, 1, 1] }\n", "scene.toml:2: body.0.mesh: 'cells' is missing"},
      {"mesh = { box = [1, 1, 1], cells = [1, 1] }\n", "body.0.mesh.cells = [1, 1]: must have 3 numbers, one per axis"},
      {"mesh = { box = [1, 1, 1], cells = [1, 1, 0] }\n", "body.0.mesh.cells = [1, 1, 0]: must be in [1, 10000]"},
      {"mesh = { box = [1, 1, 1], cells = [1, 1, 1.5] }\n", "must be a list of 2 or 3 integers"},
      {"mesh = { box = [1, 1, 1], cells = [9999, 9999, 9999] }\n",
       "scene.toml:2: body.0.mesh.cells = [9999, 9999, 9999]: makes more than 2e7 elements"},
      {"mesh = { box = [1, 1, 1], cells = [9, 9, 9], refine = 8 }\n",
       "body.0.mesh.refine = 8: makes more than 2e7 elements"},
      {"mesh = { box = [1, 1, -1], cells = [1, 1, 1] }\n", "body.0.mesh.box = [1, 1, -1]: must be > 0"},
      {"mesh = { rectangle = [1, 1], cells = [1, 1], grading = [1, 1, 1] }\n",
       "body.0.mesh.grading = [1, 1, 1]: must have 2 numbers"},
      {"mesh = { box = [1, 1, 1], cells = [1, 1, 1], element = \"tri3\" }\n",
       "scene.toml:2: body.0.mesh.element = \"tri3\": "},
      {"mesh = { box = [1, 1, 1], cells = [1, 1, 1], element = \"tet5\" }\n",
       "body.0.mesh.element = \"tet5\": must be one of \"tri3\""},
      {"mesh = { file = \"none.msh\" }\n", "scene.toml:2: body.0.mesh.file = \"none.msh\": "},
      {"mesh = { file = \"two.obj\", cells = [1, 1] }\n", "body.0.mesh.cells = [1, 1]: is for generated meshes only"},
      {"mesh = { file = \"two.obj\", element = \"tet4\" }\n",
       "body.0.mesh.element = \"tet4\": the file holds tri3 elements"},
      {"mesh = { file = \"bad.obj\" }\n", "bad.obj"},
  };
  file("two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  file("bad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n");
  expect_messages(cases, [&](const std::string& text) { return error("[[body]]\n" + text); });
}

TEST_F(SceneFile, MistakesInOverrides) {
  struct BadOverride {
    std::string key, value, message;
  };
  for (const BadOverride& bad : {
           BadOverride{"body.0.material.poisson", "0.6", "--set body.0.material.poisson=0.6: must be in (-1, 0.5)"},
           BadOverride{"time.fsp", "3", "--set time.fsp=3: unknown key 'time.fsp': did you mean 'fps'?"},
           BadOverride{"time.fps", "fast", "--set time.fps=fast: must be an integer"},
           BadOverride{"time.fps", "3\nx = 4", "must be an integer"},
           BadOverride{"body.3.material.young", "3", "body.3: there is no body.2 that it could follow"},
           BadOverride{"body.x.material.young", "3", "'body.x': body is a list: its entries are numbered from 0"},
           BadOverride{"body.-1.name", "3", "'body.-1': body is a list"},
           BadOverride{"body.99999999999.name", "3", "'body.99999999999': body is a list"},
           BadOverride{"body[].name", "3", "unknown key 'body[]'"},
           BadOverride{"", "3", "must be a table"},
           BadOverride{"body.0.material", "{ young = -3 }", "body.0.material.young = -3: must be > 0"},
           BadOverride{"body.0.pin", "[{ group = \"nowhere\" }]",
                       "body.0.pin.0.group = \"nowhere\": the mesh has no group"},
           BadOverride{"time.fps.x", "3", "unknown key 'time.fps.x'"},
       }) {
    const std::string message = error(body(""), {set(bad.key, bad.value)});
    EXPECT_NE(message.find(bad.message), std::string::npos)
        << bad.key << "\ngave: " << message << "\nnot: " << bad.message;
    EXPECT_TRUE(message.starts_with("--set ")) << message;
  }
}

TEST_F(SceneFile, FilesThatCannotBeRead) {
  const std::string none = (folder_ / "none.toml").string();
  EXPECT_EQ(error_of([&] { load_scene(none); }), none + ": there is no such file");
  EXPECT_EQ(error_of([&] { load_scene("baer"); }), "baer: there is no such file; did you mean \"bear\"?");
  EXPECT_EQ(error_of([&] { load_scene(folder_.path()); }), folder_.path().string() + ": is a folder, not a scene file");
  EXPECT_EQ(error_of([&] { load_scene(file("a.toml", beam_scene), none); }), none + ": there is no such file");
}

// Whatever is cut off, there is a document or a SceneError.
TEST_F(SceneFile, ASceneCutAnywhereIsReadOrRefused) {
  const std::string text = beam_scene;
  for (std::size_t length = 0; length < text.size(); length += 3) {
    try {
      load(text.substr(0, length));
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find("scene.toml"), std::string::npos);
    }
  }
}

// What the simulator refuses is given the line of its key, or of the table around it.
TEST_F(SceneFile, RefusalsOfTheSimulatorAreLocated) {
  const Document document = load(body("pin = [{ group = \"left\" }]\n"));
  const auto text = [&](const std::string& key) {
    const std::string message = located(sim::InputError(key, "is wrong"), document.places).message;
    return message.substr(message.rfind('/') + 1);
  };
  EXPECT_EQ(text("body.0.pin.0.group"), "scene.toml:3: body.0.pin.0.group = \"left\": is wrong");
  EXPECT_EQ(text("body.0.pin.0"), "scene.toml:3: body.0.pin.0: is wrong");
  EXPECT_EQ(text("body.0.material.young"), "scene.toml:1: body.0.material.young: is wrong");
  EXPECT_EQ(text("body.0.mesh.nothing"), "scene.toml:2: body.0.mesh: is wrong");
  EXPECT_EQ(text("time.integrator"), "scene.toml: time.integrator: is wrong");
  EXPECT_EQ(text("nonsense"), "scene.toml: is wrong");
}

}  // namespace
}  // namespace app
