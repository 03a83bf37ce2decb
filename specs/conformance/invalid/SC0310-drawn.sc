// two drawn solids
compound Two = decompose {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)  d (0,0,1)
           e (5,0,0)  f (6,0,0)  g (5,1,0)  h (5,0,1)
  faces    base [a,c,b]  left [a,d,c]  front [a,b,d]  slope [b,c,d]
           base' [e,g,f]  left' [e,h,g]  front' [e,f,h]  slope' [f,g,h]
} mass 1
process p = Two [nil]
