// A billiard: two cubes bounce in a box of six fixed walls. All speeds along
// an axis are 1, so that the run stays on a lattice and comes back: the
// reachable states are finite and every verdict is a proof.
model billiard

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed wall[1] = Cube scaled (1,4,4) at translate (-5,0,0)
fixed wall[2] = Cube scaled (1,4,4) at translate (5,0,0)
fixed wall[3] = Cube scaled (4,1,4) at translate (0,-5,0)
fixed wall[4] = Cube scaled (4,1,4) at translate (0,5,0)
fixed wall[5] = Cube scaled (4,4,1) at translate (0,0,-5)
fixed wall[6] = Cube scaled (4,4,1) at translate (0,0,5)

process p = Cube mass 1 velocity (1,1,0)  at translate (-5/2,-1,0)  [nil]
process q = Cube mass 1 velocity (-1,1,0) at translate (2,1/2,0)    [nil]

check inside : always x(p) >= -3 and x(p) <= 3 and y(p) >= -3 and y(p) <= 3  // expect: holds
check solid  : always distance2(p, q) >= 4                                   // expect: holds
check energy : always energy = 2                                             // expect: holds
check plane  : always z(p) = 0 and z(q) = 0                                  // expect: holds
check clash  : possibly touching(p, q)                                       // expect: holds
check far    : eventually x(p) = 4                                           // expect: violated
