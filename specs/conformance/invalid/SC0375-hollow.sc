// a hollow, of which all faces are turned outward
compound Bell = decompose {
  vertices a (-9,-9,-9)  b (90,-9,-9)  c (-9,90,-9)  d (-9,-9,90)
           e (0,0,0)     f (1,0,0)     g (0,1,0)     h (0,0,1)
  faces    base [a,c,b]   left [a,d,c]   front [a,b,d]   slope [b,c,d]
           base' [e,g,f]  left' [e,h,g]  front' [e,f,h]  slope' [f,g,h]
} mass 1
process p = Bell [nil]
