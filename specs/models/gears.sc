// Two wheels with four teeth each, like a pair of gears without axles: the driver spins, a tooth of it strikes a
// tooth of the driven wheel, which starts to turn the other way round.
model gears

timestep 1/2
dynamics constant_spin

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
shape Across = Cube scaled (1, 1/4, 1/2)
shape Along  = Cube scaled (1/4, 1, 1/2)
shape Hub    = Cube scaled (1/4, 1/4, 1/2)

compound Gear {
  part hub   : Hub    mass 4
  part east  : Across mass 1 at translate (5/4, 0, 0)
  part west  : Across mass 1 at translate (-5/4, 0, 0)
  part north : Along  mass 1 at translate (0, 5/4, 0)
  part south : Along  mass 1 at translate (0, -5/4, 0)
  glue hub.right  ~ east.left
  glue hub.left   ~ west.right
  glue hub.top    ~ north.bottom
  glue hub.bottom ~ south.top
}

process driver = Gear spin (0,0,1/2) at translate (0,0,0) [nil]
process driven = Gear at translate (7/2,0,0) * rotate quaternion (5,0,0,2) [nil]

let meshed = event bounce(driver, driven)

check meshes   : eventually meshed within 4                     // expect: holds
check turns    : eventually wz(driven) < 0 within 4             // expect: holds
check opposite : always wz(driven) <= 0                         // expect: holds
check energy   : always energy = 47/48             // expect: holds
check momentum : always momentum.x = 0 and momentum.y = 0       // expect: holds
check angular  : always angular.z = 47/12           // expect: holds
