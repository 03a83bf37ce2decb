// Two spinning cubes dock, off centre. The pair moves and spins on as one body, by conservation of momentum and of
// angular momentum; some kinetic energy is lost, as in every bond.
model docking
timestep 1/2
dynamics constant_spin
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
behaviour Ready on Cube = <dock, {left, right, top, bottom}>. Docked
behaviour Port  on Cube = <~dock, {left, right, top, bottom}>. Docked
behaviour Docked on Cube = nil

process tug  = Cube mass 2 velocity (1,0,0) spin (0,0,1/4) at translate (-4,-1,0) [Ready]
process ship = Cube mass 3 velocity (-1,0,0) spin (0,0,-1/3) at translate (4,1/2,0) [Port]

let docked = bound(tug, ship)

check docks    : eventually docked within 4                              // expect: holds
check momentum : always momentum.x = -1 and momentum.y = 0               // expect: holds
check angular  : always angular.z = 19/6                                 // expect: holds
check as_one   : always (docked => wz(tug) = wz(ship))                   // expect: holds
check spins_on : AG (docked => wz(tug) > 0)                              // expect: holds
check heats    : AG (event bind => energy < 93/36)                       // expect: holds
check rigid    : AG (docked => AG distance2(tug, ship) < 13/2)           // expect: holds
check for_ever : AG (docked => AG docked)                                // expect: holds
