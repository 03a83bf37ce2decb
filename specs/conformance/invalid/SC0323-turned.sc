// a box that a VRML file turns by an angle: it is turned nearly so (a warning)
shape S = mesh "turned.wrl"
process p = S mass 1 velocity (1, 0, 0) [nil]
fixed q = box(1, 1, 1) at translate (5, 0, 0)
check meets : eventually event bounce
