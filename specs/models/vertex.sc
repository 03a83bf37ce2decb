// A vertex-vertex hit: q flies along a line that takes its corner exactly onto
// a corner of p. Three directions separate the cubes there, the response is
// their cone projection, and as all of the relative velocity lies in the cone,
// equal masses simply exchange velocities.
model vertex

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 [nil]
process q = Cube mass 1 velocity (-3,-2,-1) at translate (8,6,4) [nil]

check hit      : possibly x(q) = 2 and y(q) = 2 and z(q) = 2 and touching(p, q)  // expect: holds
check stops    : eventually speed2(q) = 0                                        // expect: holds
check takes    : eventually vx(p) = -3 and vy(p) = -2 and vz(p) = -1             // expect: holds
check momentum : always momentum.x = -3 and momentum.y = -2 and momentum.z = -1  // expect: holds
check energy   : always energy = 7                                               // expect: holds
check through  : possibly x(q) < 2                                               // expect: violated
