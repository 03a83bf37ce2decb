// A gas of three cubes that tumble: off-centre hits make them spin. Velocities and orientations are rounded, which keeps
// numbers short, and checks leave some room for it. At last they fly apart.
model tumbling

dynamics free_body
timestep 1/2
round orientation 2^-20
round velocity 2^-20

param drift = 1/1000

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 velocity (1,0,0) at translate (-4,0,0) [nil]
process q = Cube mass 1 spin (0,0,1/2) at translate (0,1/2,0) [nil]
process r = Cube mass 2 velocity (-1/2,0,0) at translate (5,1,1/2) [nil]

check meet     : eventually event bounce(p, q) within 4                                  // expect: holds
check energy   : always energy > 5/6 - drift and energy < 5/6 + drift                  // expect: holds
check momentum : always momentum.x < drift and momentum.x > -drift                       // expect: holds
check tumbles  : possibly spin2(p) > 0                                                   // expect: holds
check still    : always spin2(r) = 0                                                     // expect: violated
check apart    : AF AG not touching(p, q)                                                // expect: holds
