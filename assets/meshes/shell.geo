// gmsh shell.geo -3 -format msh41 -o shell.msh
// A dome, 1 m across, open below, and a single layer of tets thick: its wall is 0.02 m.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 0.5, 0, Pi/2, 2*Pi};
Sphere(2) = {0, 0, 0, 0.48, 0, Pi/2, 2*Pi};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("shell") = {3};
Mesh.CharacteristicLengthMin = 0.12;
Mesh.CharacteristicLengthMax = 0.16;
