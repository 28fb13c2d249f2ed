// gmsh wedge.geo -2 -format msh41 -bin -o wedge.msh
// A stone of an arch in the plane, about the origin: from 0.8 m to 1.1 m, 19.98 degrees wide around the y axis. Turned by
// 20 degrees each, nine of them make half a circle with joints that are 0.3 mm wide.
half = 9.99 * Pi / 180;
Point(1) = {-0.8 * Sin(half), 0.8 * Cos(half), 0};
Point(2) = {0.8 * Sin(half), 0.8 * Cos(half), 0};
Point(3) = {1.1 * Sin(half), 1.1 * Cos(half), 0};
Point(4) = {-1.1 * Sin(half), 1.1 * Cos(half), 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1 : 4};
Plane Surface(1) = {1};
Physical Surface("stone") = {1};
Transfinite Curve {1, 3} = 4;
Transfinite Curve {2, 4} = 4;
Transfinite Surface {1};
