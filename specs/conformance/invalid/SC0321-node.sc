// a mesh file with a shape that is not read
shape S = mesh "swept.wrl"
process p = S mass 1 [nil]
