// a face with a reflex corner
shape S {
  vertices a (0,0,0)  b (4,0,0)  c (1,1,0)  d (0,4,0)  t (1,1,3)
  faces    base [a,d,c,b]  s1 [a,b,t]  s2 [b,c,t]  s3 [c,d,t]  s4 [d,a,t]
}
process p = S mass 1 [nil]
