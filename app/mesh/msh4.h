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

// From behind the section's name to before its end. Throw FileError.
MshEntities read_msh4_entities(MshFields& in);
void read_msh4_nodes(MshFields& in, MshContents& contents);
void read_msh4_elements(MshFields& in, const MshEntities& entities, MshContents& contents);

}  // namespace app
