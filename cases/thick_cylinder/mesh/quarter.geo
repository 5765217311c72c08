// A quarter of a thick tube, inner radius 10 mm, outer 20 mm: 6 x 8 nine-node quadrilaterals.
//
//     gmsh -2 -format msh22 quarter.geo -o quarter.msh
//     /usr/bin/python3 ../../tools/msh_to_med.py quarter.msh quarter.med
SetFactory("Built-in");
Point(1) = {0, 0, 0};
Point(2) = {0.01, 0, 0}; Point(3) = {0.02, 0, 0};
Point(4) = {0, 0.02, 0}; Point(5) = {0, 0.01, 0};
Line(1) = {2, 3}; Circle(2) = {3, 1, 4}; Line(3) = {4, 5}; Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 7; Transfinite Curve {2, 4} = 9;
Transfinite Surface {1}; Recombine Surface {1};
Mesh.ElementOrder = 2;
Physical Surface("body") = {1};
Physical Curve("along_x") = {1}; Physical Curve("outside") = {2}; Physical Curve("along_y") = {3}; Physical Curve("inside") = {4};
