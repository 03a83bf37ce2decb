// a drawn face that is not flat
compound Bent = decompose {
  vertices a (0,0,0)  b (1,0,0)  c (1,1,0)  d (0,1,0)
           e (0,0,1)  f (1,0,1)  g (1,1,2)  h (0,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
} mass 1
process p = Bent [nil]
