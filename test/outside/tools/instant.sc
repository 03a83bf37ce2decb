// What happens does so at once, and no action takes time: two cubes that touch and approach each other bind or let go.
model instant

import <solids>

behaviour Left  on solids.Cube(1) = <b, {right}>. rho({<b, {right}>}). Done
behaviour Right on solids.Cube(1) = <~b, {left}>. rho({<b, {left}>}). Done
behaviour Done  on solids.Cube(1) = nil

process u = solids.Cube(1) mass 1 velocity (1, 0, 0) [Left]
process v = solids.Cube(1) mass 1 at translate (1, 0, 0) [Right]

check binds : E = ? [ time U bound(u, v) ]
check done  : E = ? [ time U behaviour(u) = Done ]
check never : E = ? [ time U vx(u) > 1 ]
check soon  : E <= 1/2 [ time U behaviour(u) = Done ]
check late  : E >= 1/2 [ time U behaviour(v) = Done ]
