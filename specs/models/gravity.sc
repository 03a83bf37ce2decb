// A cube falls on a floor under a law of motion: at each movement step it gains
// g*dt of downward velocity. A collision may end a step early; as dt is the
// time since the last update (reading I-10), so none of the fall is lost.
model gravity

param g = 8
timestep 1/4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}

fixed   floor = Cube scaled (10,1,10) at translate (0,-1,0)
process ball  = Cube mass 2 velocity (1,0,0) at translate (0,17/4,0) [nil]

motion ball = (vx, vy - g*dt, vz)

check above   : always y(ball) >= 1 within 3                     // expect: holds
check lands   : eventually touching(ball, floor) within 5/4      // expect: holds
check rises   : possibly vy(ball) > 0 within 2                   // expect: holds
check steady  : always vx(ball) = 1 within 3                     // expect: holds
check high    : possibly y(ball) > 17/4 within 3/4               // expect: violated
