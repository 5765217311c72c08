// The beam behind the cylinder of radius 0.05 m at (0.2, 0.2): its root is the arc of that circle, its end lies at x = 0.6 m,
// it is 0.02 m thick; eight-node quadrilaterals.
//
//     gmsh -2 -format msh22 beam.geo -o beam.msh -setnumber across 6
//     /usr/bin/python3 ../../tools/msh_to_med.py beam.msh beam.med                       (across = 3: coarse.med)
SetFactory("Built-in");
DefineConstant[ across = 6 ];
radius = 0.05; half = 0.01;
root = 0.2 + Sqrt(radius * radius - half * half);
Point(1) = {0.2, 0.2, 0};
Point(2) = {root, 0.2 - half, 0}; Point(3) = {0.6, 0.2 - half, 0};
Point(4) = {0.6, 0.2 + half, 0}; Point(5) = {root, 0.2 + half, 0};
Line(1) = {2, 3}; Line(2) = {3, 4}; Line(3) = {4, 5}; Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 35 * across / 3 + 1; Transfinite Curve {2, 4} = across + 1;
Transfinite Surface {1}; Recombine Surface {1};
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Physical Surface("body") = {1};
Physical Curve("root") = {4}; Physical Curve("end") = {2};
