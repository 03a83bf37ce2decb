// parts of one body that do not turn as one
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
compound K {
  part l : Cube mass 1 spin (0,0,1)
  part r : Cube mass 1 spin (0,0,1) at translate (2,0,0)
  glue l.right ~ r.left
}
process k = K [nil]
dynamics constant_spin
