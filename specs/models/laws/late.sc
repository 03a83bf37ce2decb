// Where the law Convergence fails for the resolution. A cube that turns about its own path meets another one face to
// face, at 1/3. The other one leaves in the direction (1,1,0), on a line on which it slides past the edge of the post. But
// time stops before 1/3, at an instant of a grid, however fine the resolution is: so it leaves a little early and spins a
// little, and hits the post. Where nothing turns (without the spin) it does not.
//
//   scc check specs/models/laws/late.sc -D fineness=1/1000000000
model late

param fineness = 2^-10
resolution fineness

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process ball  = Cube mass 1 velocity (1,0,0) spin (1/4,0,0) at translate (-7/3,0,0) [nil]
process other = Cube mass 1 velocity (0,1,0) at translate (0,-1/3,0) [nil]
fixed   post  = Cube at translate (7,3,0)                      // its edge is at (6,4), and passed with one at (6,4)

check early : always (vx(other) > 0 => vy(other) = 1) within 5   // expect: holds
check hits  : possibly event bounce(other, post) within 8        // expect: holds
