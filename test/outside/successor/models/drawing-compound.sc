// Reading I-38: each leaf draws for itself, and the whole takes the mean of the changes, weighted by mass. One
// leaf has a certain law and one has none; two ways to one velocity are one draw. The law of b diffuses, with a
// kick that is not given.
timestep 1/2 steady
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process a = Cube mass 2 at translate (0, 0, 0) [rho({<hold, {right}>}). nil]
process b = Cube mass 1 velocity (0, 0, 0) at translate (2, 0, 0) [eps(1). rho({<hold, {left}>}). nil]
process c = Cube mass 1 at translate (0, 2, 0) [nil]
process d = Cube mass 1 at translate (0, 4, 0) [nil]
process other = Cube mass 1 at translate (7, 0, 0) [nil]
bond <hold, {a.right, b.left}>
bond <hold, {a.back, c.front}>
bond <hold, {c.back, d.front}>
motion a = choose { (1, 0, 0), (-1, 0, 0) weight 2, (1, 0, 0) weight 1/2 }
motion b = diffuse((1/8, 0, 1/3), (vx, 0, 0))
motion c = (vx, vy + dt, -vz)
motion other = choose { (-1, 0, 0), (-2, 0, 0) weight x*x }
