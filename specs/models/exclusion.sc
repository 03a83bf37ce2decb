// Two walkers in a row of three places (rule Blocked). They never pass each other, nor take a place together: if both
// are kicked into the middle, neither goes. So each way between two placements is as probable as the way back, and after
// many steps all three placements are equally probable. After n steps both ends are taken with 1/3 + 2/3 (1/4)^n, by hand.
model exclusion

timestep 1 steady
blocked wait

import <solids>

fixed room = solids.Room(3, 1, 1, 1)
process a = solids.Cube(1) mass 1 at translate (-1, 0, 0) [nil]
process b = solids.Cube(1) mass 1 at translate (1, 0, 0) [nil]

motion choose { (1, 0, 0), (-1, 0, 0) }

check in_order : always x(a) <= x(b) - 1                                    // expect: holds
check at_one   : E = ? [ if x(b) - x(a) = 2 then 1 else 0 at 1 ]            // expect: 1/2
check at_two   : E = ? [ if x(b) - x(a) = 2 then 1 else 0 at 2 ]            // expect: 3/8
check at_ten   : E = ? [ if x(b) - x(a) = 2 then 1 else 0 at 10 ]           // expect: 174763/524288
