// A motor drives a cube to and fro between two walls: to the right with 3 while it is left of the middle, to the left with
// 1 else. Steps keep their beat (reading I-35), whatever it hits in between: it is always the same places at which the law
// is asked, and so all states are found. With `timestep 1` each collision would begin a step anew, at times that are ever
// finer fractions.
model beat

timestep 1 steady

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process cart = Cube mass 1 at translate (0, 0, 0) [nil]
process load = Cube mass 1 velocity (-1, 0, 0) at translate (5/2, 0, 0) [nil]
fixed west = Cube at translate (-6, 0, 0)
fixed east = Cube at translate (6, 0, 0)

motion cart = (if x < 0 then 3 else -1, 0, 0)

check inside : always x(cart) >= -4 and x(load) <= 4                          // expect: holds
check meets  : AG EF event bounce(cart, load)                                 // expect: holds
check slow   : always speed2(cart) <= 1                                       // expect: violated
