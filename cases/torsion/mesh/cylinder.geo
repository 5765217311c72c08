// A cylinder of the radius 5 mm and the length 20 mm: a square of cells in the middle, a ring about it, 27-node hexahedra.
//
//     gmsh -3 -format msh22 cylinder.geo -o cylinder.msh
//     /usr/bin/python3 ../../tools/msh_to_med.py cylinder.msh cylinder.med
SetFactory("Built-in");
radius = 0.005; half = 0.0025; length = 0.02;
cells = 2; rings = 1; layers = 3;      // along a side of the square, across the ring, along the axis
diagonal = radius / Sqrt(2);
Point(1) = {0, 0, 0};
Point(2) = {-half, -half, 0}; Point(3) = {half, -half, 0}; Point(4) = {half, half, 0}; Point(5) = {-half, half, 0};
Point(6) = {-diagonal, -diagonal, 0}; Point(7) = {diagonal, -diagonal, 0};
Point(8) = {diagonal, diagonal, 0}; Point(9) = {-diagonal, diagonal, 0};
Line(1) = {2, 3}; Line(2) = {3, 4}; Line(3) = {4, 5}; Line(4) = {5, 2};
Circle(5) = {6, 1, 7}; Circle(6) = {7, 1, 8}; Circle(7) = {8, 1, 9}; Circle(8) = {9, 1, 6};
Line(9) = {2, 6}; Line(10) = {3, 7}; Line(11) = {4, 8}; Line(12) = {5, 9};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {9, 5, -10, -1}; Plane Surface(2) = {2};
Curve Loop(3) = {10, 6, -11, -2}; Plane Surface(3) = {3};
Curve Loop(4) = {11, 7, -12, -3}; Plane Surface(4) = {4};
Curve Loop(5) = {12, 8, -9, -4}; Plane Surface(5) = {5};
Transfinite Curve {1:8} = cells + 1; Transfinite Curve {9:12} = rings + 1;
Transfinite Surface {1:5}; Recombine Surface {1:5};
For s In {1:5}
  out[] = Extrude {0, 0, length} { Surface{s}; Layers{layers}; Recombine; };
  ends[s - 1] = out[0];
  volumes[s - 1] = out[1];
EndFor
Mesh.ElementOrder = 2;
Physical Volume("body") = {volumes[]};
Physical Surface("back") = {1:5};
Physical Surface("front") = {ends[]};
