// Where a step of all is no step of one: the ball falls as its steps have it, and those end when two bodies collide that
// are far away. Undisturbed it has the velocity -1 from time 1 on and is at -1 at time 2. The collision at 2/3 ends the
// first step there: then it has -2/3, and -5/3 from 5/3 on. With `timestep 1 local` it is undisturbed.
model company

timestep 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process ball = Cube mass 1 [nil]
process p    = Cube mass 1 velocity (3,0,0) at translate (0,1000,0) [nil]
process q    = Cube mass 1 at translate (4,1000,0) [nil]

motion ball = (vx, vy, vz - dt)

check disturbed : EF[2,2] z(ball) = -11/9    // expect: holds
check alone     : EF[2,2] z(ball) = -1       // expect: violated
