// Pushes off the centre of what turns (I-36): where the contact is a part of a face, then at a corner of what spins.
model pushed_turning
dynamics free_body
resolution 1/1024

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
shape Brick = Cube scaled (2, 1, 1/2)
behaviour Later on Brick = eps(1/2). rho({<y, {h}>}) push(1/2). nil

process face   = Brick mass 1 [rho({<x, {right}>}) push(1). Later + rho({<x, {right}>}). Later]
process other  = Cube mass 2 at translate (3, 1, 1/2) [rho({<x, {left}>}) push(1/4). nil]
process corner = Cube mass 1 at translate (-3, 2, 3/2) [rho({<y, {b}>}) push(1). nil]
bond <x, {face.right, other.left}>
bond <y, {face.h, corner.b}>
