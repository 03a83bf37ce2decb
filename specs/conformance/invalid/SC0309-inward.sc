// every face oriented inward
shape S {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)  d (0,0,1)
  faces    f1 [b,c,a]  f2 [d,b,a]  f3 [c,d,a]  f4 [d,c,b]
}
process p = S mass 1 [nil]
