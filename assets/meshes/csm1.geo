// gmsh csm1.geo -2 -order 2 -format msh41 -o csm1.msh
// The flag of Turek and Hron (CSM1): 0.19 <= y <= 0.21, right end x = 0.6, left end on the circle about (0.2, 0.2) of
// radius 0.05. Clamped along the arc.
SetFactory("Built-in");
x0 = 0.2 + Sqrt(0.05^2 - 0.01^2);
Point(1) = {0.2, 0.2, 0};
Point(2) = {x0, 0.19, 0, 0.0010};
Point(3) = {0.6, 0.19, 0, 0.004};
Point(4) = {0.6, 0.21, 0, 0.004};
Point(5) = {x0, 0.21, 0, 0.0010};
Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Curve("clamp") = {4};
Physical Surface("flag") = {1};
