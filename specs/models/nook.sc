// A walker in a room with a nook that is as wide as the walker. It draws a kick at each step. A kick into a wall is not
// taken (`blocked wait`, rule Blocked): the walker waits there for its next draw, and leaves the nook at last. By hand,
// the mean time is 7. If the walker bounced, it would bounce for ever within one instant between the walls of the nook.
model nook

timestep 1 steady
blocked wait

import <solids>

fixed block = solids.Cube(1) at translate (-1, 1/2, 0)
fixed room  = solids.Room(3, 2, 3, 1)
fixed goal  = solids.Cube(1) absorb at translate (1, 1/2, 0)

process walker = solids.Cube(1) mass 1 at translate (0, 1/2, 0) [nil]
motion walker = choose { (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0) }

check leaves   : P = ? [ eventually gone(walker) ]                          // expect: 1
check how_long : E = ? [ time U gone(walker) ]                              // expect: 7
check by_two   : P = ? [ eventually gone(walker) within 2 ]                 // expect: 15/32
check no_bounce: always not event bounce(walker)                            // expect: holds
