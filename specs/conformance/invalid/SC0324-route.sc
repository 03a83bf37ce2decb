// a box that a VRML file moves while time passes: it is read where it is at the start (a warning)
shape S = mesh "moving.wrl"
process p = S mass 1 velocity (1, 0, 0) [nil]
fixed q = box(1, 1, 1) at translate (5, 0, 0)
check meets : eventually event bounce
