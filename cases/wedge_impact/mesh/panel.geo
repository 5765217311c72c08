// One panel of the wedge: 0.6 m along its lower, wet face from the apex at the origin, 0.04 m thick, rising at 10 degrees; lengths in metres.
//
//     gmsh -2 -format msh22 panel.geo -o panel.msh
//     /usr/bin/python3 ../../tools/msh_to_med.py panel.msh panel.med
SetFactory("Built-in");
DefineConstant[ along = 60, through = 4 ];
c = Cos(10*Pi/180); s = Sin(10*Pi/180); l = 0.6; t = 0.04;
Point(1) = {0, 0, 0}; Point(2) = {l*c, l*s, 0}; Point(3) = {l*c - t*s, l*s + t*c, 0}; Point(4) = {-t*s, t*c, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = along + 1; Transfinite Curve {2, 4} = through + 1; Transfinite Surface {1};
Recombine Surface {1};
Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;
Physical Surface("body") = {1};
Physical Curve("wet") = {1}; Physical Curve("outer") = {2}; Physical Curve("apex") = {4};
