// How near a plane or a sphere is to a patch of a surface. Before a plane a patch is one node, as no point of a face is
// nearer than all of its nodes. Before a sphere it is a flat face, in the plane an edge: a sphere that is smaller than
// a face comes through between nodes.
//   d = N . sum_i c_i x_i,  less the radius,  c = (-1, shares of the patch's nodes),  dd/dx_i = c_i N
// x_0 is the plane's point or the sphere's centre, N the obstacle's normal at the closest point of the patch.
#pragma once

#include "sim/contact/distance.h"
#include "sim/material/tangent.h"
#include "sim/scene.h"

namespace sim {

// Positions of a patch's nodes, or how they move.
struct Patch {
  int count;
  Vec3 x[3];
};

// m, below 0 inside.
double gap(const Plane& plane, const Patch& at);
double gap(const Sphere& sphere, const Patch& at);

struct Approach {
  Approach(const Plane& plane, const Patch& at);
  Approach(const Sphere& sphere, const Patch& at);

  double d;  // m
  Vec3 normal;
  double c[4] = {};
};

// d2 b/dx2 of a function of d with these derivatives, three numbers for the obstacle's place and for each node. That a
// plane turns is not in it.
PairMatrix approach_tangent(const Plane& plane, const Patch& at, double first, double second, Definiteness fix);
PairMatrix approach_tangent(const Sphere& sphere, const Patch& at, double first, double second, Definiteness fix);

// A part of a move, infinity where nothing is in its way, on all of which d > 0: of a plane all that there is, of a
// sphere what leaves a fifth of the gap, or of the barrier's width dh where that is less, as between two bodies
// (sim/term/contact.cpp). `by`: how the shape's own numbers change; d(at) > 0.
double way_to(const Plane& plane, const Plane& by, const Patch& at, const Patch& move, double dh);
double way_to(const Sphere& sphere, const Sphere& by, const Patch& at, const Patch& move, double dh);

// How a move of the shape shifts its surface at the patch: d changes by N . (sum of shares times moves - shift).
Vec3 shift_of(const Plane& plane, const Plane& by, const Patch& at);
Vec3 shift_of(const Sphere& sphere, const Sphere& by, const Patch& at);

}  // namespace sim
