// n walkers, each in a room of its own of 2 by 2 places, that draw one of four directions at each step. They do not meet, so
// that the states are those of all walkers together.
model rooms

param n = 3
timestep 1 steady

import <solids>

for i in 1..n {
  fixed room[i] = solids.Room(2, 2, 1, 1) at translate (0, 0, 10*i)
  process w[i] = solids.Cube(1) mass 1 at translate (-1/2, -1/2, 10*i) [nil]
}
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }

check all_right : E = ? [ time U forall q in w: x(q) > 1/4 ]
