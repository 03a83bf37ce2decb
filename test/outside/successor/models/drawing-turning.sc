// Rule Draw where bodies turn: what is drawn is a velocity of the centre of mass, from what leaves see of their
// own; the turns of all whose laws are asked have ended while somebody waits, and those of the others go on.
timestep 1
dynamics free_body
round velocity 2^-6
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process a = Cube mass 1 spin (1/4, 0, 1/4) at translate (0, 0, 0) [rho({<hold, {right}>}). nil]
process b = Cube mass 3 velocity (0, 1/2, 0) spin (1/4, 0, 1/4) at translate (2, 0, 0)
  [eps(1/2). rho({<hold, {left}>}). nil]
process c = Cube mass 1 spin (0, 1/2, 1/3) at translate (-7, 1, 0) [nil]
process d = Cube mass 1 spin (0, 0, 1/3) velocity (0, 1, 0) at translate (20, 0, 0) [nil]
process e = Cube mass 1 spin (0, 1/4, 1/3) at translate (-20, 0, 0) [nil]
bond <hold, {a.right, b.left}>
motion a = choose { (vx, vy, vz)/2 + (1, 0, 0), (0, 1/3, 0) weight 2 }
motion b = choose { (0, 0, 0) weight 1 + x*x, (1/3, 0, vz) }
motion c = choose { (2, 0, 0), (-1, 0, 0) weight 0, (2, 1/7, 0) weight 1/3 }
motion d = (vx, vy/2, vz)
