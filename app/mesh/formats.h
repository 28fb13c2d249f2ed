// The formats of mesh files: those that are read, and those for which a program that is free converts them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

struct MeshFormat {
  std::string_view endings;  // of file names, in small letters, each followed by a blank
  std::string_view name;     // for messages
  // content: the whole file; name: the file's, for messages and to find a file that belongs to it.
  sim::Mesh (*read)(std::string_view content, std::string_view name, std::vector<std::string>& remarks);
};

std::span<const MeshFormat> mesh_formats();

// By the ending of a file's name, in letters of either size; nullptr when none is read.
const MeshFormat* find_mesh_format(std::string_view file_name);

// What to do with a file that is not read: the command that converts it where one is known, and what is read.
std::string conversion_advice(std::string_view file_name);

}  // namespace app
