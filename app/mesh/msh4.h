// The sections of Gmsh's MSH format, version 4.1, text or binary.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_fields.h"

namespace app {

// Physical tags of each entity of the model, by dimension and tag of the entity.
using MshEntities = std::map<std::pair<int, int>, std::vector<int>>;

// From behind the section's name to before its end. Throw FileError. point_numbers: how many say where a point is:
// three, or six in version 4.0.
MshEntities read_msh4_entities(MshFields& in, int point_numbers);
// Of a mesh that is cut into partitions: elements lie in parts of entities, which join the entities.
void read_msh4_partitions(MshFields& in, int point_numbers, MshEntities& entities);
void read_msh4_nodes(MshFields& in, MshContents& contents);
void read_msh4_elements(MshFields& in, const MshEntities& entities, MshContents& contents);

// The total that stands at the head of a section, against the sum of its blocks.
void check_msh4_total(const Cursor& in, std::int64_t total, std::size_t sum, std::string_view what);

}  // namespace app
