// a cube with a dent
shape S {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)  e (-1,-1,1)  f (1,-1,1)  g (1,1,1)  h (-1,1,1)  t (0,0,0)
  faces    bottom [a,d,c,b]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]  t1 [e,f,t]  t2 [f,g,t]  t3 [g,h,t]  t4 [h,e,t]
}
process p = S mass 1 [nil]
