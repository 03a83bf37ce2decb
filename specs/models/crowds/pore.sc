// Two rooms and a pore as wide as a body between them: n bodies start on the left.
model pore
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
let wide = 2*ceil(n/4) + 1
fixed room = solids.Room(17, wide, 1, 1)
fixed upper = box(1, (wide - 1)/2, 1) at translate (0, (wide + 1)/4, 0)
fixed lower = box(1, (wide - 1)/2, 1) at translate (0, -(wide + 1)/4, 0)
for i in 1..n { process p[i] = solids.Cube(1) mass 1
  at translate (-8 + 2*((i - 1) mod 4), 2*floor((i - 1)/4) - (wide - 1)/2, 0) [nil] }
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check through_at_100 : E = ? [ count(q in p: x(q) > 0) at 100 ]
check first_by_50    : P = ? [ eventually exists q in p: x(q) > 0 within 50 ]
