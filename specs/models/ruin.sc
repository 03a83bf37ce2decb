// Gambler's ruin. A walker goes one step to the right or to the left, by a coin that is not fair, until it steps into one
// of two walls, which absorb it: 2 steps to the left of it, or 3 to the right (rule Draw). It may walk for ever, though
// that has probability 0; so it does not come to an end on all runs, but always may, and does with probability 1. With r = 3/2
// it is ruined with the probability (r^2 - r^5) / (1 - r^5), and walks for 2/p - 5/p (1 - r^2) / (1 - r^5) on the average, p = 1/5
// (rules Probability and Expectation).
model ruin

timestep 1

import <solids>

process walker = solids.Cube(1) mass 1 [nil]
fixed ruin   = solids.Cube(1) absorb at translate (-3, 0, 0)
fixed riches = solids.Cube(1) absorb at translate (4, 0, 0)

motion walker = choose { (1, 0, 0) weight 2, (-1, 0, 0) weight 3 }

check ruined    : possibly event absorb(walker, ruin)                          // expect: holds
check rich      : possibly event absorb(walker, riches)                        // expect: holds
check ends      : eventually gone(walker)                                      // expect: violated
check surely    : P >= 1 [ eventually gone(walker) ]                           // expect: holds
check how_often : P = ? [ eventually event absorb(walker, ruin) ]              // expect: 171/211
check by_four   : P = ? [ eventually gone(walker) within 4 ]                   // expect: 373/625
check how_long  : E = ? [ time U gone(walker) ]                                // expect: 1110/211
check drift     : E = ? [ x(walker) at 3/2 ]                                   // expect: -3/10
check may_end   : AG EF gone(walker)                                           // expect: holds
check not_soon  : always not gone(walker) within 2                             // expect: violated
check not_sooner: always not gone(walker) within 3/2                           // expect: holds
check by_steps  : always (gone(walker) or speed2(walker) <= 1)                 // expect: holds
