// gmsh bob.geo -2 -format msh41 -bin -o bob.msh
// A ball of radius 0.1 m in the plane at the lower end of a string that is 1 m long and 0.01 m wide and begins at the
// origin, where the group "top" is one node.
Point(1) = {0, 0, 0};
Point(2) = {-0.005, -0.02, 0};
Point(3) = {0.005, -0.02, 0};
angle = Asin(0.005 / 0.1);
Point(4) = {-0.005, -1.1 + 0.1 * Cos(angle), 0};
Point(5) = {0.005, -1.1 + 0.1 * Cos(angle), 0};
Point(6) = {0, -1.1, 0};
Point(7) = {-0.1, -1.1, 0};
Point(8) = {0, -1.2, 0};
Point(9) = {0.1, -1.1, 0};
Line(1) = {1, 2};
Line(2) = {2, 4};
Circle(3) = {4, 6, 7};
Circle(4) = {7, 6, 8};
Circle(5) = {8, 6, 9};
Circle(6) = {9, 6, 5};
Line(7) = {5, 3};
Line(8) = {3, 1};
Curve Loop(1) = {1 : 8};
Plane Surface(1) = {1};
Physical Surface("bob") = {1};
Physical Point("top") = {1};
Transfinite Curve {2, 7} = 13;
Transfinite Curve {1, 8} = 2;
Transfinite Curve {3, 4, 5, 6} = 6;
