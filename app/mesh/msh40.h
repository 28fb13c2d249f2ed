// The sections of Gmsh's MSH format, version 4.0, text or binary, where they are not those of 4.1.
#pragma once

#include "app/mesh/msh4.h"

namespace app {

// From behind the section's name to before its end. Throw FileError.
void read_msh40_nodes(MshFields& in, MshContents& contents);
void read_msh40_elements(MshFields& in, const MshEntities& entities, MshContents& contents);

}  // namespace app
