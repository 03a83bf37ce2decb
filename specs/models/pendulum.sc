// A ball between two walls: what happens when. Each way takes it 6 units of time, so that it hits the east
// wall at 3, 15, 27, ... and the west wall at 9, 21, ... Bounds of time count from the instant that a formula
// is about.
model pendulum

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed   west = Cube scaled (1,5,5) at translate (-5,0,0)
fixed   east = Cube scaled (1,5,5) at translate (5,0,0)
process ball = Cube mass 1 velocity (1,0,0) [nil]

check east_first : A[ not event bounce(ball, west) U event bounce(ball, east) ]             // expect: holds
check in_turn    : AG (event bounce(ball, east) => AX event bounce(ball, west))             // expect: holds
check six_later  : event bounce(ball, east) leads_to[6, 6] event bounce(ball, west)         // expect: holds
check sooner     : event bounce(ball, east) leads_to event bounce(ball, west) within 5      // expect: violated
check at_three   : EF[3, 3] event bounce(ball, east) and not EF[4, 14] event bounce(east)   // expect: holds
check returns    : AG AF[0, 12] x(ball) = 0                                                 // expect: holds
check strictly   : AG AF[1, 7] x(ball) = 0                                                  // expect: holds
check too_strict : AG AF[1, 6] x(ball) = 0                                                  // expect: violated
check stays_out  : EF EG[<= 3] x(ball) > 3/2                                                // expect: violated
check stays_long : EF EG[<= 3] x(ball) >= 3/2                                               // expect: holds
check away       : AG (event bounce(ball, east) => A[ vx(ball) < 0 U[6, 6] x(ball) = -3 ])  // expect: holds
check one_a_time : always not (event bounce(ball, east) and event bounce(ball, west))       // expect: holds
