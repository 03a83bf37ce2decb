// Association and dissociation: three monomers, each between an open site and the end of its cell. Where it stands the draw of
// a step decides: it goes to its site and binds, with probability 1/4, or stays. At each split instant a bond breaks with
// probability 1/5, before the draws, so that a monomer which has just let go may bind again at once.
//
// So each is a chain of two states: bound after a step with probability 1/4 if it was free, and 4/5 + 1/5 * 1/4 = 17/20 if it was
// bound. The second eigenvalue is 17/20 - 1/4 = 3/5, and the stationary probability to be bound is (1/4) / (1 - 3/5) = 5/8; the number of
// those bound is binomial in the long run, with the mean 15/8; after k draws, the first of them at time 0, it is so with 5/8 (1 - (3/5)^k) in place of 5/8. A bond comes back after
// 8/5 steps on the average, 1 over its stationary probability (Kac).
model association

timestep 1 steady

import <solids>

param n = 3

behaviour Monomer = <site, {right}> . omega(site, {right}) chance 1/5 . Monomer
behaviour Site    = <~site, {left}> . omega(site, {left}) . Site

for i in 1..n {
  process m[i] = solids.Cube(1) mass 1 at translate (0, 0, 10*i) [Monomer]
  fixed   s[i] = solids.Cube(1) at translate (1, 0, 10*i) [Site]
  motion  m[i] = choose { (1, 0, 0) weight 1, (0, 0, 0) weight 3 }
}

let bonded = count(i in 1..n: bound(m[i], s[i]))

check by_three  : P = ? [ eventually bound(m[1], s[1]) within 3 ]          // expect: 175/256
check first     : E = ? [ time U bound(m[1], s[1]) ]                       // expect: 3
check mean_at_3 : E = ? [ bonded at 3 ]                                    // expect: 204/125
check mean_at_9 : E = ? [ bonded at 9 ]                                    // expect: 3639966/1953125
check all_at_3  : E = ? [ if bonded = n then 1 else 0 at 3 ]               // expect: 314432/1953125
check none_at_3 : E = ? [ if bonded = 0 then 1 else 0 at 3 ]               // expect: 185193/1953125
check no_free   : P >= 1 [ eventually bonded = n ]                         // expect: holds
