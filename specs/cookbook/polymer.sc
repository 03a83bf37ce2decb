model polymer

import <solids>

param n = 4

behaviour Head   = <link, {right}>. nil
behaviour Middle = <~link, {left}>. <link, {right}>. nil
behaviour Tail   = <~link, {left}>. nil

process m[1] = solids.Cube(1) mass 1 velocity (1, 0, 0) [Head]
for i in 2..n - 1 { process m[i] = solids.Cube(1) mass 1 at translate (3*(i - 1), 0, 0) [Middle] }
process m[n] = solids.Cube(1) mass 1 at translate (3*(n - 1), 0, 0) [Tail]

check whole   : eventually size(m[1]) = n
check ordered : always forall i in 1..n - 1: x(m[i]) < x(m[i + 1])
check kept    : always momentum.x = 1
