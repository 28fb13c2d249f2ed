// The sections of Gmsh's MSH format, version 2 (2.0 to 2.2), text or binary.
#pragma once

#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_fields.h"

namespace app {

// From behind the section's name to before its end. Throw FileError.
void read_msh2_nodes(MshFields& in, MshContents& contents);
void read_msh2_elements(MshFields& in, MshContents& contents);

}  // namespace app
