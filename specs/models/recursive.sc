// A recursive channel: a driven cube sticks to a receptor in the floor, lets
// go, falls back at the next movement step, sticks again, for ever. The run
// is a cycle, so exploration is complete.
model recursive

timestep 1
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}

behaviour Free     on Cube = <dock, {bottom}>. omega(dock, {bottom}). Free
behaviour Receptor on Cube = <~dock, {top}>. omega(dock, {top}). Receptor

process p     = Cube mass 1 velocity (0,-1,0) at translate (0,3,0) [Free]
fixed   floor = Cube at translate (0,-1,0) [Receptor]

motion p = (0, -1, 0)

check docks    : eventually bound(p, floor)                        // expect: holds
check undocks  : possibly not bound(p, floor) and y(p) = 1 and behaviour(p) = Free  // expect: holds
check down     : always y(p) >= 1 and x(p) = 0                     // expect: holds
check one_bond : always bonds(dock) <= 1                           // expect: holds
check rises    : possibly y(p) > 3                                 // expect: violated
