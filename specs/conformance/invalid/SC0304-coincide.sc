// two vertices at one place
shape S {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)  d (0,0,0)
  faces    f1 [a,c,b]  f2 [a,b,d]  f3 [a,d,c]  f4 [b,c,d]
}
process p = S mass 1 [nil]
