// Rule Draw: several that draw, in the order of their places and not of their names, beside one with a certain
// law, one without a law and one that does not draw because something fixed holds it. Velocities are named twice,
// some by way of what is seen, and weights may be 0: then the velocity, which divides by 0, is not asked for.
timestep 1
round velocity 1/2
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process a = Cube mass 2 velocity (0, 1, 0) at translate (6, 0, 0) [nil]
process b = Cube mass 1 at translate (-6, 0, 0) [nil]
process c = Cube mass 1 at translate (0, 0, 0) [nil]
process d = Cube mass 1 velocity (0, 0, 1) at translate (0, 6, 0) [nil]
process e = Cube mass 1 velocity (0, 0, -1) at translate (0, -6, 0) [nil]
process held = Cube mass 1 at translate (0, 20, 0) [nil]
fixed stake = Cube at translate (0, 22, 0) [nil]
bond <hold, {held.back, stake.front}>
motion a = choose { (vx, vy, vz) - (1, 0, 0) weight 2, (vx, vy, vz) weight mass, (0, 1, 0), (-4/3, 0, 0) }
motion b = choose {
  for i in -1..1: (i, 1/5, 0) weight 2 - i*i,
  (1/time, 0, 0) weight if time = 0 then 0 else 1,
  (0, 1/5, 0)
}
motion c = choose { (0, 0, 1/4), (0, dt/3, 1/4) weight 3 }
motion d = (vx, vy - dt, vz)
motion held = choose { (1, 0, 0), (0, 1, 0) }
