// gmsh bear.geo -3 -format msh41 -bin -o bear.msh   (with -setnumber fine 1 -o bear-fine.msh: the fine one; with
// -setnumber fine -1 -o bear-coarse.msh: one to be had by the dozen)
// A gummy bear, 1 m tall, standing on the plane y = 0 and looking along +z: a union of ellipsoids with flat soles.
SetFactory("OpenCASCADE");
DefineConstant[ fine = {0, Choices{-1, 0, 1}, Name "Fine mesh"} ];

// An ellipsoid: a ball of radius 1 at the origin, scaled to the semi-axes a, b, c, turned about z, moved to x, y, z.
Macro Blob
  Sphere(part) = {0, 0, 0, 1};
  Dilate {{0, 0, 0}, {a, b, c}} { Volume{part}; }
  Rotate {{0, 0, 1}, {0, 0, 0}, turn} { Volume{part}; }
  Translate {x, y, z} { Volume{part}; }
  part += 1;
Return

part = 1;
// chest
x = 0; y = 0.42; z = 0;  a = 0.205; b = 0.22; c = 0.165; turn = 0;  Call Blob;
// belly
x = 0; y = 0.285; z = 0.03;  a = 0.235; b = 0.19; c = 0.2;  Call Blob;
// head
x = 0; y = 0.715; z = 0.02;  a = 0.225; b = 0.2; c = 0.185;  Call Blob;
// muzzle
x = 0; y = 0.665; z = 0.185;  a = 0.1; b = 0.075; c = 0.085;  Call Blob;
// ears, arms, legs: side = -1 is the bear's right
For side In {-1 : 1 : 2}
  x = side * 0.155; y = 0.89; z = 0.01;  a = 0.085; b = 0.11; c = 0.06; turn = -side * Pi / 5;  Call Blob;
  x = side * 0.245; y = 0.47; z = 0.075;  a = 0.15; b = 0.085; c = 0.085; turn = -side * Pi / 8;  Call Blob;
  x = side * 0.145; y = 0.11; z = 0.085;  a = 0.115; b = 0.15; c = 0.165; turn = side * Pi / 12;  Call Blob;
EndFor
Box(part) = {-1, 0, -1, 2, 2, 2};

parts() = BooleanUnion{ Volume{1}; Delete; }{ Volume{2 : part - 1}; Delete; };
bear() = BooleanIntersection{ Volume{parts()}; Delete; }{ Volume{part}; Delete; };

// A surface belongs to a group when its bounding box, wider than itself, is inside the box.
Physical Volume("bear") = bear();
Physical Surface("feet") = Surface In BoundingBox {-1, -0.01, -1, 1, 0.01, 1};
Physical Surface("left_arm") = Surface In BoundingBox {-0.1, 0.2, -1, 1, 0.7, 1};
Physical Surface("right_arm") = Surface In BoundingBox {-1, 0.2, -1, 0.1, 0.7, 1};
Physical Surface("head") = Surface In BoundingBox {-0.46, 0.36, -1, 0.42, 2, 1};

// Sizes that leave no bad tets in the creases: the smallest dihedral angle is 10.1 degrees (fine: 11.8).
Mesh.MeshSizeMax = fine > 0 ? 0.0297 : (fine < 0 ? 0.11 : 0.0479);
Mesh.MeshSizeMin = fine > 0 ? 0.02 : (fine < 0 ? 0.07 : 0.03);
Mesh.Smoothing = fine > 0 ? 4 : 1;
Mesh.OptimizeThreshold = 0.7;
