// gmsh bracket.geo -2 -format msh41 -o bracket.msh   (-order 2: tri6)
// An L-shaped bracket in the plane: 0.3 m x 0.3 m, arms 0.08 m wide, an inner corner of radius 0.05 m. Two bolts hold
// it by the holes in its upright arm ("clamp"); the end of the other arm is "right", the hole near it "load".
SetFactory("OpenCASCADE");
w = 0.3; a = 0.08; f = 0.05;

Point(1) = {0, 0, 0};
Point(2) = {a, 0, 0};
Point(3) = {a, w - a - f, 0};
Point(4) = {a + f, w - a - f, 0};
Point(5) = {a + f, w - a, 0};
Point(6) = {w, w - a, 0};
Point(7) = {w, w, 0};
Point(8) = {0, w, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Circle(3) = {3, 4, 5};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 1};

Circle(8) = {a / 2, 0.05, 0, 0.018};
Circle(9) = {a / 2, 0.17, 0, 0.018};
Circle(10) = {0.24, w - a / 2, 0, 0.022};
Curve Loop(1) = {1 : 7};
Curve Loop(2) = {8};
Curve Loop(3) = {9};
Curve Loop(4) = {10};
Plane Surface(1) = {1 : 4};

Physical Surface("bracket") = {1};
Physical Curve("clamp") = {8, 9};
Physical Curve("load") = {10};
Physical Curve("right") = {5};
Mesh.MeshSizeMax = 0.013;
Mesh.MeshSizeFromCurvature = 16;
Mesh.Algorithm = 6;
