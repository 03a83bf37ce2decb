// Rule Draw with movement steps of single processes (I-31): whoever collides is not asked, and draws later, at the
// same instant or at another one. The one with the certain law, whose step is over at that instant, waits for the
// draw.
timestep 1 local
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour To on Cube = <go, {right}>. eps(1/2). rho({<go, {right}>}). nil
behaviour Fro on Cube = <~go, {left}>. eps(1/2). rho({<go, {left}>}). nil
process a = Cube mass 1 velocity (1, 0, 0) at translate (0, 0, 0) [To]
process b = Cube mass 1 velocity (-1, 0, 0) at translate (3, 0, 0) [Fro]
process c = Cube mass 1 velocity (1, 0, 0) at translate (-6, 0, 0) [nil]
process d = Cube mass 1 at translate (-6, 4, 0) [nil]
motion a = choose { (1, 0, 0) weight 2, (-2, dt, 0) }
motion b = choose { (-1, 0, 0) }
motion c = choose { (vx, vy, vz)/2 + (1, 0, 0) weight 3, (0, 2, 0) weight 2 }
motion d = (vx, vy + 1 - 4*dt, vz)
