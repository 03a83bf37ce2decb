// two vertices with one name
shape S {
  vertices a (0,0,0)  b (1,0,0)  a (0,1,0)  d (0,0,1)
  faces    f1 [a,d,b]
}
process p = S mass 1 [nil]
