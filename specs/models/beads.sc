// Two beads that are bound, between two walls. Each bead is kicked by a coin of its own, and the whole takes the mean of
// both kicks (reading I-38): it goes to the right or to the left with probability 1/4 each, and rests with 1/2. Its mean
// square is half of that of a single bead.
model beads

timestep 1 steady

import <solids>

process pair = p : solids.Cube(1) mass 1 [nil] <hold, {p.right, q.left}>
               q : solids.Cube(1) mass 1 at translate (1, 0, 0) [nil]
fixed west = solids.Cube(1) at translate (-3, 0, 0)
fixed east = solids.Cube(1) at translate (4, 0, 0)

motion pair = choose { (1, 0, 0), (-1, 0, 0) }

check rests   : possibly (vx(p) = 0 and x(p) = 1)                     // expect: holds
check goes    : possibly vx(q) = 1                                    // expect: holds
check no_half : always (vx(p) = 0 or abs(vx(p)) = 1)                  // expect: holds
check inside  : always (x(p) >= -2 and x(q) <= 3)                     // expect: holds
check stays   : EG x(p) = 0                                           // expect: holds
