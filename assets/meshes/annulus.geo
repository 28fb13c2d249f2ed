// gmsh annulus.geo -2 -format msh41 -o annulus.msh
// A ring in the plane, 1 m across, with a hole of 0.4 m; elements grow from the inside to the outside.
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 0.5};
Disk(2) = {0, 0, 0, 0.2};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
rim() = Boundary{ Surface{3}; };
inner() = Point In BoundingBox {-0.3, -0.3, -1, 0.3, 0.3, 1};
outer() = Point In BoundingBox {0.4, -0.3, -1, 0.6, 0.3, 1};
Characteristic Length{ inner() } = 0.03;
Characteristic Length{ outer() } = 0.12;
Physical Surface("annulus") = {3};
