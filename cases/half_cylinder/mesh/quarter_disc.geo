// A quarter of a disc of radius 10 mm in three blocks: symmetry plane x = 0, upper face y = 10 mm, lowest point at the origin.
// Lengths in mm. `n`: elements along each eighth of the circle; `grow`: ratio of neighbouring elements, finest at the lowest point.
If (!Exists(n)) n = 12; EndIf
If (!Exists(grow)) grow = 1.0; EndIf
R = 10; a = 0.45 * R; b = 0.36 * R;
Point(1) = {0, 0, 0};                                  // lowest
Point(2) = {0, R, 0};                                  // centre
Point(3) = {R, R, 0};
Point(4) = {R * Sin(Pi / 4), R - R * Cos(Pi / 4), 0};
Point(5) = {0, R - a, 0};
Point(6) = {a, R, 0};
Point(7) = {b, R - b, 0};
Circle(1) = {1, 2, 4};
Circle(2) = {4, 2, 3};
Line(3) = {5, 7}; Line(4) = {7, 6};
Line(5) = {5, 2}; Line(6) = {2, 6};
Line(7) = {1, 5}; Line(8) = {4, 7}; Line(9) = {3, 6};
Curve Loop(1) = {1, 8, -3, -7}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -4, -8}; Plane Surface(2) = {2};
Curve Loop(3) = {3, 4, -6, -5}; Plane Surface(3) = {3};
Transfinite Curve {1, 3, 6} = n + 1 Using Progression grow;
Transfinite Curve {2, 4, 5} = n / 2 + 1;
Transfinite Curve {7, 8, 9} = n + 1 Using Progression grow;
Transfinite Surface {1, 2, 3};
Recombine Surface {1, 2, 3};
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 0;
Physical Surface("body") = {1, 2, 3};
Physical Curve("axis") = {5, 7};
Physical Curve("contact") = {1, 2};
Physical Curve("upper") = {6, 9};
