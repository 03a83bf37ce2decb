// A graze: an edge of q slides across an edge of p at one instant, and
// neither feels anything. It is no event, yet they touch.
model graze

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Sticky  on Cube = <~a, {right, back}>. nil
behaviour Sticky' on Cube = <a, {left, front}>. nil

process p = Cube mass 1 [Sticky]
process q = Cube mass 1 velocity (1,-1,0) at translate (0,4,0) [Sticky']

check meets  : possibly touching(p, q)                               // expect: holds
check where  : possibly touching(p, q) and x(q) = 2 and y(q) = 2     // expect: holds
check only   : always (touching(p, q) => x(q) = 2)                   // expect: holds
check apart  : always not touching(p, q)                             // expect: violated
check free   : always bonds(a) = 0 and vx(q) = 1                     // expect: holds
check soon   : possibly touching(p, q) within 1                      // expect: violated
