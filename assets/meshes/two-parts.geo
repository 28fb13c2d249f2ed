// gmsh two-parts.geo -3 -format msh41 -o two-parts.msh
// A ball and a slab that do not touch, in one body: 1.2 m together, elements of 0.1 m beside others of 0.25 m.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 0.25};
Box(2) = {0.45, -0.3, -0.1, 0.5, 0.6, 0.2};
ball() = PointsOf{ Volume{1}; };
slab() = PointsOf{ Volume{2}; };
Characteristic Length{ ball() } = 0.1;
Characteristic Length{ slab() } = 0.25;
Physical Volume("ball") = {1};
Physical Volume("slab") = {2};
