// gmsh star.geo -3 -format msh41 -o star.msh
// A seven-pointed star, 1 m across: elements of 0.01 m at one tip beside others of 0.1 m and more.
n = 7;
For k In {0:2*n-1}
  r = (k % 2 == 0) ? 0.5 : 0.19;
  size = (k == 0) ? 0.01 : (k % 2 == 0 ? 0.06 : 0.1);
  Point(k + 1) = {r*Cos(Pi*k/n), r*Sin(Pi*k/n), 0, size};
EndFor
Point(100) = {0, 0, 0, 0.2};
For k In {1:2*n}
  Line(k) = {k, (k % (2*n)) + 1};
EndFor
Curve Loop(1) = {1:2*n};
Plane Surface(1) = {1};
Point{100} In Surface{1};
out[] = Extrude {0, 0, 0.15} { Surface{1}; };
Physical Volume("star") = {out[1]};
Mesh.CharacteristicLengthExtendFromBoundary = 1;
