// a tip under a turning face: time cannot pass, and no collision would help
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
shape Spike {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)  tip (0,0,3)
  faces    bottom [a,d,c,b]  front [a,b,tip]  right [b,c,tip]  back [c,d,tip]  left [d,a,tip]
}
fixed spike = Spike at translate (0, 0, -4)
dynamics constant_spin
process p = Cube mass 1 spin (1, 0, 0) [nil]
check turns : possibly z(p) > 1 within 1
