Include "box.geo";
If (hexa)
  out[] = Extrude {0.1, 0, 0.6} { Surface{1}; Layers{2}; Recombine; };
Else
  out[] = Extrude {0.1, 0, 0.6} { Surface{1}; Layers{2}; };
EndIf
Physical Volume("body") = {out[1]};
Physical Surface("back") = {1}; Physical Surface("front") = {out[0]};
Physical Surface("bottom") = {out[2]}; Physical Surface("right") = {out[3]}; Physical Surface("top") = {out[4]}; Physical Surface("left") = {out[5]};
