// Where the law Convergence fails for the timestep: a cube is thrown so that its top would be exactly as high as the
// bottom of a block when it comes to it, and slide along below. Under a law of motion in steps it flies higher, by half of
// g times the time times the step, however short the steps are: it hits the front of the block and is thrown back.
// With a block that is higher by a little, all steps that are short enough agree.
//
//   scc check specs/models/laws/brink.sc -D step=1/64
model brink

param g    = 2
param step = 1/4
timestep step

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process ball  = Cube mass 1 velocity (4,0,4) [nil]
fixed   block = Cube at translate (10,0,6)                               // its front is reached at time 2
process other = Cube mass 1 velocity (4,0,4) at translate (0,10,0) [nil]
fixed   above = Cube at translate (10,10,7)

motion ball  = (vx, vy, vz - g*dt)
motion other = (vx, vy, vz - g*dt)

check hits : eventually vx(ball) = -4 within 3     // expect: holds
check free : always vx(other) = 4 within 3         // expect: holds
