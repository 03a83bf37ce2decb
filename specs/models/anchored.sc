// A ligand and a partner that bind for a while, on a floor of 5 by 3 places. If the partner is fixed, the ligand is always
// found at one of the places when it draws. If the partner walks too (`-D walks=1`), a bound pair draws the mean of two kicks,
// half a place for example, and two that meet on the way bind there. So the places become finer, and the states many.
model anchored

timestep 1 steady
split_step 1
blocked wait
collisions drawn

import <solids>

param walks = 0   // 1: the partner walks, 0: it is fixed

behaviour Free   = <d, {only right}> . Bound
behaviour Bound  = omega(d, {only right}) chance 1/8 . Free
behaviour Open   = <~d, {only left}> . Taken
behaviour Taken  = omega(d, {only left}) . Open

fixed room = solids.Room(5, 3, 1, 1)
process ligand = solids.Cube(1) mass 1 at translate (-2, 0, 0) [Free]
for i in 1..1 - walks { fixed   partner[i] = solids.Cube(1) at translate (2, 0, 0) [Open] }
for i in 1..walks     { process walker[i]  = solids.Cube(1) mass 1 at translate (2, 0, 0) [Open] }
motion choose { (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0) }

check bound_at_8 : E = ? [ bonds(d) at 8 ]                                  // expect: 143041109/2147483648
