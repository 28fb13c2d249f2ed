// The sections of Gmsh's MSH format, version 1: text, $NOD and $ELM, without a head.
#pragma once

#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_fields.h"

namespace app {

// From behind the section's name to before its end. Throws FileError. Nodes are written as in version 2.
void read_msh1_elements(MshFields& in, MshContents& contents);

}  // namespace app
