// A scene file, read: what is simulated, how it is seen, and where each key stands.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/body_mesh.h"
#include "app/scene/exhibit_spec.h"
#include "app/scene/look.h"
#include "app/scene/obstacle_mesh.h"
#include "app/scene/scene_error.h"
#include "sim/scene.h"

namespace app {

struct Document {
  std::filesystem::path folder;  // of the scene file: files that exhibits name are told from there
  std::string title;
  sim::Scene scene;
  std::vector<MeshSpec> meshes;               // body by body: the description that scene.bodies[i].mesh was made from
  std::vector<ObstacleMesh> obstacle_meshes;  // obstacle by obstacle
  std::vector<std::filesystem::path> start_files;  // body by body: that scene.bodies[i].start.nodes came from; or empty
  std::vector<char> without_basis;                 // body by body: basis.kind is "none", whatever else it says
  std::vector<std::filesystem::path> basis_folders;  // body by body: the run whose states its basis has; or empty
  std::vector<std::optional<Vec3>> references;       // probe by probe: the displacement it should have at the end [m]
  Camera camera;
  Look look;
  std::vector<ExhibitSpec> exhibits;
  std::vector<std::string> remarks;  // what the user should know: step chosen, elements mended
  Places places;                     // of every key that was given
};

}  // namespace app
