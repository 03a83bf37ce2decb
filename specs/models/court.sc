// A walker in a court of three by three places (rule Isometry): a corner, a side and the middle are all that a run to the
// middle can tell apart. From a corner it stays with 1/2 and comes to a side with 1/2; from a side it stays with 1/4, comes
// to a corner with 1/2 and to the middle with 1/4. So the means are 2 + 8 = 10 from a corner and 8 from a side, by hand.
// The question about the last column is the same in one mirror image alone: 12 from the first column, 8 from the second.
model court

timestep 1 steady
blocked wait

import <solids>

fixed wall = solids.Room(3, 3, 1, 1)
process w = solids.Cube(1) mass 1 at translate (-1, -1, 0) [nil]

motion choose { (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0) }

check middle : E = ? [ time U x(w) = 0 and y(w) = 0 ]                        // expect: 10
check soon   : P = ? [ eventually x(w) = 0 and y(w) = 0 within 2 ]           // expect: 1/8
check column : E = ? [ time U x(w) >= 1 ]                                    // expect: 12
