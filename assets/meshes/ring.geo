// gmsh ring.geo -3 -format msh41 -bin -o ring.msh
// A torus around the z axis: 1 m from the centre to the middle of the tube, which is 0.25 m in radius.
SetFactory("OpenCASCADE");
Torus(1) = {0, 0, 0, 1, 0.25};
// A thin piece on either side, for pins that pull.
Box(2) = {-1.3, -0.15, -0.3, 0.4, 0.3, 0.6};
Box(3) = {0.9, -0.15, -0.3, 0.4, 0.3, 0.6};
grips() = BooleanIntersection{ Volume{1}; }{ Volume{2, 3}; Delete; };
BooleanFragments{ Volume{1}; Delete; }{ Volume{grips()}; Delete; }
all() = Volume{:};
left() = Volume In BoundingBox {-2, -0.3, -1, -0.5, 0.3, 1};
right() = Volume In BoundingBox {0.5, -0.3, -1, 2, 0.3, 1};
Physical Volume("ring") = all();
Physical Volume("left") = left();
Physical Volume("right") = right();
Mesh.MeshSizeMax = 0.13;
Mesh.OptimizeThreshold = 0.6;
