// n motors in one lane of 2n places, which is closed by a wall: each steps on with probability 1/2 where the place is free.
model traffic
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
fixed lane = solids.Room(2*n, 1, 1, 1)
for i in 1..n { process m[i] = solids.Cube(1) mass 1 at translate (i - n - 1/2, 0, 0) [nil] }
motion m = choose { (1,0,0), (0,0,0) }
check first_at_9  : E = ? [ if x(m[n]) >= 4 then 1 else 0 at 9 ]
check moved_at_20 : E = ? [ count(p in m: x(p) > 0) at 20 ]
