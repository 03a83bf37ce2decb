// A cube of mass 1 comes with 1 and hits one of mass 2 at rest: they would go on with -1/3 and 2/3. Velocities that are
// multiples of 1/4 alone have it that they go on with -1/4 and 3/4: all numbers stay short, and momentum is not kept.
model rounded

round velocity 1/4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 velocity (1, 0, 0) at translate (-4, 0, 0) [nil]
process q = Cube mass 2 at translate (0, 0, 0) [nil]

check before : always (vx(p) > 0 => momentum.x = 1)                 // expect: holds
check after  : eventually vx(p) = -1/4 and vx(q) = 3/4              // expect: holds
check kept   : always momentum.x = 1                                // expect: violated
check once   : AG (event bounce(p, q) => AX not event bounce)       // expect: holds
