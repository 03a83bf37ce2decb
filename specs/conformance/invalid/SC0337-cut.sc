// faces that cut each other: a spike of one end goes through the other
compound Knot = decompose {
  vertices a (0,0,0)  b (9,0,0)  c (0,9,0)  d (0,0,9)
           e (1,1,-1) f (2,1,-1) g (1,2,-1) h (1,1,5)
  faces    base [a,c,b]  left [a,d,c]  front [a,b,d]  slope [b,c,d]
           under [e,g,f]  side [e,h,g]  near [e,f,h]  far [f,g,h]
} mass 1
process p = Knot [nil]
