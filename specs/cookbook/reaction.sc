model reaction

import <solids>

behaviour A = <meet, {right}>. rho({<meet, {right}>}). C
behaviour B = <~meet, {left}>. rho({<meet, {left}>}). D
behaviour C = nil
behaviour D = nil

process a = solids.Cube(1) mass 1 velocity (1, 0, 0) [A]
process b = solids.Cube(1) mass 1 velocity (-1, 0, 0) at translate (5, 0, 0) [B]

check reacts   : eventually behaviour(a) = C and behaviour(b) = D
check together : always (behaviour(a) = C => behaviour(b) = D)
check once     : AG (event strong(meet) => AX AG not event strong(meet))
