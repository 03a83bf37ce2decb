// implications whose left sides never hold (warnings), and some that are in order
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process p = Cube mass 1 velocity (1,0,0) [nil]
process q = Cube mass 1 at translate (4,0,0) [nil]
process r = Cube mass 1 at translate (9,9,9) [nil]
check direct  : always (bonds() > 0 => speed2(p) = 0)
check both    : always ((touching(p, q) => x(p) = 2) and (touching(p, r) => x(p) = 0))
check bounded : always (x(p) >= 2 => energy = 0) within 1
check some    : always forall b in Cube: (touching(b, r) => y(b) = 9)
check none    : AG forall b in Cube: (x(b) < 0 => y(b) = 9)
check before  : possibly (x(p) > 100 and y(p) > 0)
