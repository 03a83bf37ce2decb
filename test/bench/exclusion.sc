// n walkers on a floor of k by k places, that do not take a kick that is blocked. They start in the first corner, row by
// row; the goal is the opposite one. Walkers are alike for what any of them does (any), and one is not like the others for
// what it does itself (first).
model exclusion

param n = 3
param k = 4
timestep 1 steady
blocked wait

import <solids>

fixed room = solids.Room(k, k, 1, 1) at translate (k/2, k/2, 0)
for i in 1..n {
  process w[i] = solids.Cube(1) mass 1 at translate (1/2 + ((i-1) mod k), 1/2 + floor((i-1)/k), 0) [nil]
}
motion choose { (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0) }

check any   : E = ? [ time U exists q in w: (x(q) > k-1 and y(q) > k-1) ]
check first : E = ? [ time U (x(w[1]) > k-1 and y(w[1]) > k-1) ]
check soon  : P = ? [ eventually exists q in w: (x(q) > k-1 and y(q) > k-1) within 2*k ]
