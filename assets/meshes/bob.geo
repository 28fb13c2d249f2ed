// gmsh bob.geo -2 -format msh41 -bin -o bob.msh
// A ball of radius 0.1 m in the plane at the lower end of a string that is 1 m long and 0.008 m wide and begins at the
// origin, where the group "top" is one node.
half = 0.004;
meet = -1.1 + Sqrt(0.1 * 0.1 - half * half);  // where the sides of the string reach the ball
Point(1) = {0, 0, 0};
Point(2) = {-half, -0.02, 0};
Point(3) = {half, -0.02, 0};
Point(4) = {-half, meet, 0};
Point(5) = {half, meet, 0};
Point(6) = {0, -1.1, 0};
Point(7) = {-0.1, -1.1, 0};
Point(8) = {0, -1.2, 0};
Point(9) = {0.1, -1.1, 0};
Line(1) = {1, 2};
Line(2) = {2, 4};
Line(3) = {5, 3};
Line(4) = {3, 1};
Line(5) = {4, 5};
Circle(6) = {4, 6, 7};
Circle(7) = {7, 6, 8};
Circle(8) = {8, 6, 9};
Circle(9) = {9, 6, 5};
Curve Loop(1) = {1, 2, 5, 3, 4};
Plane Surface(1) = {1};
Curve Loop(2) = {6, 7, 8, 9, -5};
Plane Surface(2) = {2};
Physical Surface("string") = {1};
Physical Surface("ball") = {2};
Physical Point("top") = {1};
Transfinite Curve {2, 3} = 15;
Transfinite Curve {1, 4, 5} = 2;
Transfinite Curve {6, 9} = 7;
Transfinite Curve {7, 8} = 8;
