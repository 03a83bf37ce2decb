// A cube hits two that stand abreast, at their common border. One after the
// other (reading I-8), the first that is hit would take all. Resolved together
// (reading I-32) both go on alike, and the cube goes back: momentum and energy
// are kept, 1 = 2/3 + 2/3 - 1/3 and 1 = 4/9 + 4/9 + 1/9.
model abreast
collisions together

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [nil]
process q = Cube mass 1 at translate (0,1,0)  [nil]
process r = Cube mass 1 at translate (0,-1,0) [nil]

check alike  : eventually vx(q) = 2/3 and vx(r) = 2/3    // expect: holds
check back   : eventually vx(p) = -1/3                   // expect: holds
check same   : always vx(q) = vx(r)                      // expect: holds
check energy : always energy = 1/2                       // expect: holds
check one    : eventually event bounce(q, r)             // expect: holds
