// two solids in one template
shape S {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)  d (0,0,1)  aa (5,0,0)  bb (6,0,0)  cc (5,1,0)  dd (5,0,1)
  faces    f1 [a,c,b]  f2 [a,b,d]  f3 [a,d,c]  f4 [b,c,d]  g1 [aa,cc,bb]  g2 [aa,bb,dd]  g3 [aa,dd,cc]  g4 [bb,cc,dd]
}
process p = S mass 1 [nil]
