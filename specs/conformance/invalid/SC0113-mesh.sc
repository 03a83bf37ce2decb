// a mesh file with a comment that is not as it looks (a warning)
shape S = mesh "hidden.off"
process p = S mass 1 velocity (1, 0, 0) [nil]
fixed q = box(1, 1, 1) at translate (5, 0, 0)
check meets : eventually event bounce
