// a behaviour used on another template than its own
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
shape Wedge {
  vertices a (0,0,0)  b (1,0,0)  c (0,1,0)  d (0,0,1)
  faces    f1 [a,c,b]  f2 [a,b,d]  f3 [a,d,c]  f4 [b,c,d]
}
behaviour B on Wedge = <a, {f1}>. nil
process p = Cube mass 1 [B]
process q = Wedge mass 1 at translate (9,0,0) [B]
