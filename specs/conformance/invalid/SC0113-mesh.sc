// a mesh file with a comment that is not as it looks (a warning)
shape S = mesh "hidden.off"
process p = S mass 1 [nil]
check still : always x(p) = 1/4
