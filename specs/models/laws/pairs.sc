// Two pairs that have nothing to do with each other, and lots for both at one instant. How many of them go is in the mean 1/3 + 1/2,
// though the two go by one transition where both do: of a split each bond counts (rule Expectation, law Additivity). With -D two=0
// the other pair is alone, and the mean is 1/3. A free end that may go on in several ways has to choose if another one has to as
// well: so the law fails for events that count what is chosen. The two alone have 4/3 and 3/2 of all that is no time, and both 3.
model pairs

param one = 1/3
param two = 1/2
split_step 1

import <solids>

behaviour One  on solids.Cube(1) = omega(a, {right}) chance one . nil
behaviour Two  on solids.Cube(1) = omega(a, {right}) chance two . nil
behaviour Free on solids.Cube(1) = omega(a, {left}) . Low + omega(a, {left}) . High
behaviour Low  on solids.Cube(1) = nil
behaviour High on solids.Cube(1) = nil

process p = solids.Cube(1) mass 1 at translate (0, 0, 0) [One]
process q = solids.Cube(1) mass 1 at translate (1, 0, 0) [Free]
process u = solids.Cube(1) mass 1 at translate (10, 0, 0) [Two]
process v = solids.Cube(1) mass 1 at translate (11, 0, 0) [Free]
bond <a, {p.right, q.left}>
bond <a, {u.right, v.left}>

check released : E = ? [ event weak(a) U time > 1 ]                              // expect: 5/6
check of_one   : E = ? [ event weak(a, p, q) U time > 1 ]                        // expect: 1/3
check of_two   : E = ? [ event weak(a, u, v) U time > 1 ]                        // expect: 1/2
check at_least : P = ? [ eventually event weak(a) within 1 ]                     // expect: 2/3
check changes  : E = ? [ event weak or not event weak U time > 1 ]               // expect: 3
