// Two kinds of bodies that bind when they meet, and let go by chance: how many pairs are there after a while?
model dimers
timestep 1 steady
split_step 1
blocked wait
collisions drawn
import <solids>
param n = 10
let half = ceil(n/2)
let long = 2*ceil(half/2) + 3
behaviour A  = <d, {only right}> . AB
behaviour AB = omega(d, {only right}) rate 1/8 . A
behaviour B  = <~d, {only left}> . BA
behaviour BA = omega(d, {only left}) . B
fixed room = solids.Room(long, 9, 1, 1)
for i in 1..half {
  process a[i] = solids.Cube(1) mass 1 at translate (2*ceil(i/2) - (long - 1)/2, 2*(i mod 2) - 3, 0) [A]
  process b[i] = solids.Cube(1) mass 1 at translate (2*ceil(i/2) - (long - 1)/2, 2*(i mod 2) + 1, 0) [B]
}
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check pairs_at_40 : E = ? [ bonds(d) at 40 ]
check one_by_10   : P = ? [ eventually bonds(d) >= 1 within 10 ]
