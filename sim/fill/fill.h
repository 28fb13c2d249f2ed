// A solid of tets from the surface around it, by isosurface stuffing. [Labelle & Shewchuk 2007]
// Inside is where the surface winds round a point more than half: holes are closed, shells that cross each other
// joined. A lattice of body-centred cubes is cut by that boundary; its vertices that lie nearer to it than a share of
// their edges (0.24999 of long ones, 0.41189 of short ones) are moved onto it, so that no tet is too flat.
#pragma once

#include "sim/fill/shells.h"
#include "sim/mesh/mesh.h"

namespace sim {

struct Filling {
  Mesh mesh;  // tet4; the surface's groups are its own
  Shells shells;
  double smallest_angle = 0;  // degrees, of all dihedral angles
  int crumbs = 0;             // parts of less than 1/100 of the largest one, left out
  int lost = 0;               // parts of the surface that are thinner than the tets, which fill nothing of them
  double spanned = 0;         // the longest side of the body's box, of that of the surface's
};

// size: about the length of the edges [m]. The surface is of triangles in space. Throws InputError (key "mesh.surface",
// "mesh.size") where it encloses nothing, or nothing as large as that, or where the lattice would be too large.
Filling fill(const Mesh& surface, double size);

}  // namespace sim
