// A ball between two walls, with a law that doubles its velocity after every impact. Each round is four times as fast
// as the one before: after 9/2 no time is left, and no bound ever reaches that instant. Such a run is one like any
// other (rule Run). As the law multiplies with the velocity and asks for nothing else, this one is proved to converge.
model quicken

timestep 100

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}

fixed   west = Cube at translate (-5,0,0)
fixed   east = Cube at translate (5,0,0)
process ball = Cube mass 1 velocity (1,0,0) [nil]

motion ball = (2*vx, 2*vy, 2*vz)

check inside : always -3 <= x(ball) and x(ball) <= 3 within 17/4  // expect: holds
check faster : possibly vx(ball) > 15 within 17/4                 // expect: holds
