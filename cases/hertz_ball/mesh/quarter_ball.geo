// A quarter of the lower half of a ball of radius 10 mm: symmetry planes x = 0 and y = 0, upper face z = 10 mm, lowest point at
// the origin. Lengths in mm. `h`: size of the elements within 1 mm of the lowest point; by 0.3 mm a mm they grow from there.
If (!Exists(h)) h = 0.1; EndIf
SetFactory("OpenCASCADE");
R = 10; e = 1e-3;
Sphere(1) = {0, 0, R, R, -Pi / 2, 0, Pi / 2};
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.15*(Sqrt(x*x + y*y + z*z) - 1 + Abs(Sqrt(x*x + y*y + z*z) - 1))", h);
Background Field = 1;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
across_x() = Surface In BoundingBox {-e, -e, -e, e, R + e, R + e};
across_y() = Surface In BoundingBox {-e, -e, -e, R + e, e, R + e};
upper() = Surface In BoundingBox {-e, -e, R - e, R + e, R + e, R + e};
contact() = Surface{:};
contact() -= {across_x(), across_y(), upper()};
Physical Volume("body") = {1};
Physical Surface("across_x") = {across_x()};
Physical Surface("across_y") = {across_y()};
Physical Surface("upper") = {upper()};
Physical Surface("contact") = {contact()};
