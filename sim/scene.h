// A scene as plain data: what a user writes in a TOML file, checked and with every default filled in.
// SI units. Vectors have three numbers; in a 2D scene the third is zero and means nothing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/choices.h"
#include "sim/math/vec3.h"
#include "sim/mesh/mesh.h"
#include "sim/mesh/region.h"

namespace sim {

struct Time {
  double seconds = 2.0;  // s, simulated
  int fps = 60;          // frames per simulated second; frame k is at k/fps exactly
  int substeps = 1;      // steps per frame, h = 1/(fps*substeps); 0 = auto (explicit schemes: what stability needs)
  int unit = 1;          // s; fps, and so h, count in it: fps = 1 and unit = 2 make h = 2 s
  std::string integrator = "backward-euler";  // a row of sim/time/scheme.h
};

struct Solver {
  LinearSolverKind linear = LinearSolverKind::automatic;
  NewtonKind newton = NewtonKind::guarded;
  double tolerance = 1e-4;    // body sizes per second: Newton stops when max |dx|/(g h) is below it
  int max_iterations = 1000;  // Newton iterations per stage; more are not tried even while they make progress
  Definiteness definiteness = Definiteness::clamp;
  OnFailure on_failure = OnFailure::split;
  int lag_iterations = 0;  // how often damping and friction are evaluated anew at a stage's solution
};

struct World {
  Vec3 gravity = {0, -9.81, 0};  // m/s^2
};

struct MaterialSpec {
  std::string model = "stable-neo-hookean";  // a line of sim/material/list.h
  double young = 1e6;                        // Pa, > 0
  double poisson = 0.45;                     // (-1, 0.5)
  double density = 1000;                     // kg/m^3, > 0
  std::string group;                         // "" = the whole body, else the region of the mesh that has this material
};

// A pose along a script: rotate about an axis through a centre, then translate. Linear in between.
struct Keyframe {
  double t = 0;                // s
  Vec3 translate = {0, 0, 0};  // m
  Vec3 axis = {0, 0, 1};       // unit
  Vec3 centre = {0, 0, 0};     // m
  double degrees = 0;
};

struct Pin {
  Region where;
  std::string axes = "xyz";       // which components are prescribed
  std::vector<Keyframe> motion;   // empty: it stays where it is
  std::optional<double> release;  // s; from then on the nodes are free
  bool at_start = false;          // they are held where the body starts, not where it is at rest
};

struct Traction {
  Region where;            // boundary facets all of whose nodes are inside
  Vec3 value = {0, 0, 0};  // Pa, dead load per rest area
  double ramp = 0;         // s to rise from 0 to value (smoothly)
};

// A load normal to the surface as it moves, per area as it is.
struct Pressure {
  std::optional<Region> where;  // boundary facets all of whose nodes are inside; none: the whole surface
  double value = 0;             // Pa, against the outward normal: > 0 presses in
  double ramp = 0;              // s to rise from 0 to value (smoothly)
};

// A dead load at a material point.
struct PointForce {
  Vec3 at = {0, 0, 0};     // material point, m
  Vec3 value = {0, 0, 0};  // N
  double ramp = 0;         // s to rise from 0 to value (smoothly)
};

// What acts on a body from outside.
struct BodyLoads {
  std::vector<Traction> tractions;
  std::vector<Pressure> pressures;
  std::vector<PointForce> forces;

  // When all of them have their values [s].
  double risen() const {
    double end = 0;
    const auto wait = [&](const auto& loads) {
      for (const auto& load : loads) end = std::max(end, load.ramp);
    };
    wait(tractions);
    wait(pressures);
    wait(forces);
    return end;
  }
};

struct Damping {
  double alpha = 0;  // 1/s, times M
  double beta = 0;   // s, times K
};

struct Spin {
  Vec3 axis = {0, 0, 1};  // through the centre of mass
  double rate = 0;        // rad/s
};

// Where the nodes start, if not at rest: a row of the table in sim/body/start.cpp. Without a value: what the row says.
struct Start {
  std::string shape = "rest";
  std::optional<double> amount;        // how much; its unit depends on the shape
  std::optional<Vec3> direction;       // unit
  std::optional<double> perturbation;  // of the body's size: largest random displacement of each component
  std::vector<double> matrix;          // "affine": A by rows, as many numbers as the scene has dimensions squared
  std::vector<Vec3> nodes;             // "nodes": where each node of the mesh is [m]
  int mode = 1;                        // "mode": number of the vibration mode, the slowest is 1
};

// Elements that stand for all of a body, and how often each counts.
struct Cubature {
  std::vector<int> elements;  // numbers in the body's mesh, rising
  std::vector<double> weights;
  double error = 0;  // of the reduced forces at the states of the training, a share of them
  int states = 0;    // of the training
};

// The vectors of a basis, as sim/study/basis.h makes them.
struct BasisVectors {
  Eigen::MatrixXd U;  // D numbers for each node of the body x vectors; U^T M U = 1
  int modes = 0;      // of these, the first vectors that are vibration modes
  std::optional<Cubature> cubature;
};

// A body that moves in a few numbers: x = X + U c.
struct Basis {
  BasisKind kind = BasisKind::derivatives;
  int count = 20;       // vectors
  double cubature = 0;  // error of the forces that is asked for, a share of them; 0: all elements are summed
  // x - X at some times of a run [m], D numbers per node x times: what "snapshots" are made of, and a cubature is
  // trained on.
  std::shared_ptr<const Eigen::MatrixXd> snapshots;
  std::shared_ptr<const BasisVectors> vectors;
};

struct Body {
  std::string name;
  Mesh mesh;                            // already placed (translate, rotate, scale applied)
  double thickness = 1;                 // m; triangles and quads only
  std::vector<MaterialSpec> materials;  // first: the whole body; later ones override a group
  MassMatrix mass = MassMatrix::lumped;
  Damping damping;
  std::vector<Pin> pins;
  BodyLoads loads;
  Vec3 velocity = {0, 0, 0};  // m/s, initial
  Spin spin;
  Start start;
  std::optional<Basis> basis;
  double untangle = 0;  // strength of the pull that undoes inversions and folds: sim/term/untangle.h; 0: none
};

struct Plane {
  Vec3 point, normal;
};
// A surface that no force moves, closed or open: triangles in space, lines in the plane.
struct RigidSurface {
  Eigen::MatrixXd X;      // m, as many numbers a node as the scene has dimensions
  Eigen::MatrixXi faces;  // nodes of a face, as many as the scene has dimensions
};
using ObstacleShape = std::variant<Plane, Sphere, RigidSurface>;
struct Obstacle {
  ObstacleShape shape;
  double friction = 0;                 // Coulomb coefficient
  std::string name = {};               // for messages
  std::vector<Keyframe> motion = {};   // of the whole obstacle; empty: it stays where it is
  std::optional<double> release = {};  // s; from then on it is not there
};

// Bodies that touch each other and do not pass through: two names, the same twice for a body with itself; none: every
// pair of bodies. What is not given follows from the bodies (sim/build/contacts.h).
struct Contact {
  std::vector<std::string> between;
  double friction = 0;              // Coulomb's coefficient
  std::optional<double> distance;   // m, > 0: where the barrier begins
  std::optional<double> stiffness;  // Pa, > 0
  std::optional<double> offset;     // m: how far surfaces stay apart, as thick cloth does
};

// A spring from a material point to a place in space.
struct Spring {
  std::string body;
  Vec3 at = {0, 0, 0};      // material point, m
  Vec3 target = {0, 0, 0};  // m
  double stiffness = 0;     // N/m
};

struct Probe {
  std::string name, body;
  Vec3 at = {0, 0, 0};  // material point, m
};

struct Scene {
  int dimension = 3;  // 2 when every mesh is
  Time time;
  Solver solver;
  World world;
  std::vector<Body> bodies;
  std::vector<Obstacle> obstacles;
  std::vector<Contact> contacts;
  std::vector<Spring> springs;
  std::vector<Probe> probes;
  std::uint64_t seed = 1;  // of everything random
};

}  // namespace sim
