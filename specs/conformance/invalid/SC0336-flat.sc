// a vertex and an edge of a drawing that are inside a face of the solid, or on an edge that goes straight on
compound Slab = decompose {
  vertices a (0,0,0)  m (1,0,0)  b (2,0,0)  c (2,1,0)  d (0,1,0)
           e (0,0,1)  n (1,0,1)  f (2,0,1)  g (2,1,1)  h (0,1,1)
  faces    bottom [a,d,c,b,m]  front0 [a,m,n,e]  front1 [m,b,f,n]
           right [b,c,g,f]  back [c,d,h,g]  left [d,a,e,h]  top0 [e,n,g,h]  top1 [n,f,g]
} mass 1
process p = Slab [<dock, {m}>. nil]
process q = Slab at translate (5, 0, 0) [<dock, {[m, n], [n, g], front1, [a, m]}>. nil]
process r = Slab at translate (9, 0, 0) [<dock, {[b, g], [e, h, g, n], p1.middle}>. nil]
