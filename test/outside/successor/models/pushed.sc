// Splits with pushes (I-36): of two bonds at once, at a corner along a line of no rational length, and from what is fixed.
model pushed

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
behaviour Middle on Cube = rho({<x, {left}>, <y, {g}>}) push(1/3). nil + rho({<x, {left}>}) push(2). nil
behaviour Side on Cube   = rho({<x, {right}>}) push(1/2). nil
behaviour Corner on Cube = rho({<y, {a}>}). nil + rho({<y, {a}>}) push(1). nil
behaviour Stuck on Cube  = omega(z, {bottom, top}) push(1). nil

process side   = Cube mass 2 at translate (-2, 1/2, 0) [Side]
process middle = Cube mass 1 [Middle]
process corner = Cube mass 3 at translate (2, 2, 2) [Corner]
fixed wall     = Cube at translate (0, 0, -20) [Stuck]
process stuck  = Cube mass 1 at translate (1, 1, -18) [Stuck]
bond <x, {side.right, middle.left}>
bond <y, {middle.g, corner.a}>
bond <z, {wall.top, stuck.bottom}>
