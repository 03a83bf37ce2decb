// What absorbs stands still, does nothing and is bound to nobody.
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 absorb at translate (9,0,0) [nil]
fixed open = Cube absorb at translate (0,9,0) [<a, {top}>. nil]
fixed drain = Cube absorb
process q = Cube mass 1 at translate (2,0,0) [nil]
bond <a, {drain.right, q.left}>
