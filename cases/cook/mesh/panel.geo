// Cook's panel, 48 mm wide, 44 mm high at the left and 16 mm at the right; nine-node quadrilaterals, lengths in millimetres.
// Mapped: cells x cells. Free: Gmsh's own quadrilaterals of about the same size, with no direction and no two alike.
//
//     gmsh -2 -format msh22 panel.geo -o panel.msh -setnumber cells 8
//     /usr/bin/python3 ../../tools/msh_to_med.py panel.msh mapped_8.med       (16: mapped_16.med; free = 1: free.med)
SetFactory("Built-in");
DefineConstant[ cells = 8, free = 0 ];
Point(1) = {0, 0, 0}; Point(2) = {48, 44, 0}; Point(3) = {48, 60, 0}; Point(4) = {0, 44, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
If (free)
  Transfinite Curve {1:4} = cells / 2 + 1;
  Mesh.SubdivisionAlgorithm = 1;       // each triangle and quadrilateral in three or four: quadrilaterals alone
Else
  Transfinite Curve {1:4} = cells + 1;
  Transfinite Surface {1};
EndIf
Recombine Surface {1};
Mesh.ElementOrder = 2;
Physical Surface("body") = {1};
Physical Curve("held") = {4}; Physical Curve("loaded") = {2};
