// gmsh box.geo -3 -format msh22|msh41 [-bin] -o box-2-text.msh, ...; -order 2: box-second-*.msh; tests/app reads them all.
// A box of 2 x 1 x 1 m in two regions, with a surface and a curve in groups; "stiff" overlaps "all", 7 has no name.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Physical Volume("all") = {1, 2};
Physical Volume("stiff") = {2};
Physical Surface("clamp here", 3) = Surface In BoundingBox {-0.1, -0.1, -0.1, 0.1, 1.1, 1.1};
Physical Surface(7) = Surface In BoundingBox {1.9, -0.1, -0.1, 2.1, 1.1, 1.1};
Physical Curve("edge") = Curve In BoundingBox {1.9, -0.1, 0.9, 2.1, 1.1, 1.1};
Mesh.MeshSizeMin = 1;
Mesh.MeshSizeMax = 1;
