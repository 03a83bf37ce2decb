// Where Confluence fails: two bounces share no process, and yet one takes part
// in the other when it comes second. The outer two hit the inner two, which
// rest against each other. One after the other (reading I-8) both bounces are
// possible in either order. Resolved together (reading I-32) the first of them
// makes the inner two collide, so that what is left is one cluster of three.
model row
collisions together

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 velocity (1,0,0)  at translate (-3,0,0) [nil]
process q = Cube mass 1 at translate (-1,0,0) [nil]
process r = Cube mass 1 at translate (1,0,0)  [nil]
process s = Cube mass 1 velocity (-1,0,0) at translate (3,0,0) [nil]

check each  : possibly vx(q) = 1 and vx(r) = -1           // expect: violated
check one   : possibly vx(q) = 1 and vx(r) = 0            // expect: holds
check apart : eventually vx(p) = -1 and vx(s) = 1         // expect: holds
