// A distorted box of 1.0 x 0.8 (x 0.6) for the mesh tests, with one group a side.
SetFactory("Built-in");
If (!Exists(order)) order = 1; EndIf
If (!Exists(hexa)) hexa = 0; EndIf
If (!Exists(incomplete)) incomplete = 0; EndIf
Point(1) = {0, 0, 0, 0.5}; Point(2) = {1, 0.05, 0, 0.5}; Point(3) = {1.1, 0.8, 0, 0.5}; Point(4) = {-0.05, 0.7, 0, 0.5};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 3; Transfinite Curve {2, 4} = 3;
Transfinite Surface {1};
If (hexa) Recombine Surface {1}; EndIf
Mesh.ElementOrder = order; Mesh.SecondOrderIncomplete = incomplete;
