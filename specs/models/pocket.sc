// An enzyme that spins, with a pocket that must face its ligand to bind it.
//
// The pocket is a floor between two jaws, and turns past the x axis. Two ligands of one kind come along that axis at
// the same time, from both sides. When they arrive the pocket faces the one on the right, which binds to the floor;
// the one on the left meets the back of the enzyme and bounces off. With `-D late=10` the pocket has turned on when
// the right one arrives, and it is knocked away by a jaw instead.
//
// What is bound turns with the enzyme. After a while it reacts and is let go as a product: it keeps the velocity of
// its place and flies off along the tangent.
model pocket

param late = 0

timestep 1/2
dynamics constant_spin
round orientation 2^-40
round velocity 2^-40

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
shape Floor  = Cube scaled (1/4, 2, 1)
shape Jaw    = Cube scaled (3/4, 1/4, 1)
shape Ligand = Cube scaled (1/2, 1/2, 1/2)

compound Enzyme {
  part floor : Floor mass 40
  part upper : Jaw   mass 15 at translate (1, 7/4, 0)
  part lower : Jaw   mass 15 at translate (1, -7/4, 0)
  glue floor.right ~ upper.left
  glue floor.right ~ lower.left
}

behaviour Empty   on Enzyme = <~site, {floor.right}>. Loaded
behaviour Loaded  on Enzyme = eps(2). rho({<site, {floor.right}>}). Empty
behaviour Free    on Ligand = <site, {left, right}>. Bound
behaviour Bound   on Ligand = eps(2). rho({<site, {left, right}>}). Product
behaviour Product on Ligand = nil

process enzyme = Enzyme spin (0,0,1/4) at rotate quaternion (2,0,0,-1) [Empty]
process right  = Ligand mass 1 velocity (-2,0,0) at translate (8 + late,0,0) [Free]
process left   = Ligand mass 1 velocity (2,0,0) at translate (-8,0,0) [Free]

let drift = 1/1000000000

check binds     : eventually bound(enzyme, right)                                           // expect: holds
check bounces   : eventually event bounce(enzyme, left) within 5                            // expect: holds
check only_one  : always not bound(enzyme, left)                                            // expect: holds
check carried   : AG (event bind => wz(right) = wz(enzyme))                                 // expect: holds
check reacts    : event bind leads_to event strong(site) within 2                           // expect: holds
check flies_off : eventually behaviour(right) = Product and speed2(right) > 1/100           // expect: holds
check momentum  : always momentum.x < drift and momentum.x > -drift                         // expect: holds
