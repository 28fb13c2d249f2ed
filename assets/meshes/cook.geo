// gmsh cook.geo -2 -order 2 -format msh41 -o cook.msh
// Cook's membrane; finest at the upper left corner, where the stress is singular.
SetFactory("Built-in");
Point(1) = {0, 0, 0, 1.5};
Point(2) = {48, 44, 0, 3};
Point(3) = {48, 60, 0, 3};
Point(4) = {0, 44, 0, 0.2};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Curve("left") = {4};
Physical Curve("right") = {2};
Physical Surface("membrane") = {1};
