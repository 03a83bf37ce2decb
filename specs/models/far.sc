// A walker goes one step to the right with 2/5 and to the left with 3/5. It is absorbed 2 steps to the left. With r = 3/2
// it gets n steps to the right with the probability (r^2 - 1) / (r^(n + 2) - 1): rare, and reached level by level (law
// Splitting).
model far
timestep 1 steady
import <solids>
param n = 20
process walker = solids.Cube(1) mass 1 [nil]
fixed ruin   = solids.Cube(1) absorb at translate (-3, 0, 0)
motion walker = choose { (1, 0, 0) weight 2, (-1, 0, 0) weight 3 }
check rich : P = ? [ eventually (not gone(walker) and x(walker) >= n) ] // expect: 1048576/6275373061
