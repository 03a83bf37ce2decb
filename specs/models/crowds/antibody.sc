// A prozone: n/2 antigens and m antibodies, both with two arms, bind each other into chains. A bridge is an antibody with
// both arms bound. Where antibodies are many they take all arms of the antigens, and there are fewer bridges.
model antibody
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
param m = ceil(n/2)
let half = ceil(n/2)
let long = 2*ceil(max(half, m)/2) + 3
behaviour Antigen  = <ab, {only left}> . Left + <ab, {only right}> . Right
behaviour Left     = <ab, {only right}> . Full
behaviour Right    = <ab, {only left}> . Full
behaviour Full     = nil
behaviour Antibody = <~ab, {only left}> . ByLeft + <~ab, {only right}> . ByRight
behaviour ByLeft   = <~ab, {only right}> . Bridge
behaviour ByRight  = <~ab, {only left}> . Bridge
behaviour Bridge   = nil
fixed room = solids.Room(long, 9, 1, 1)
for i in 1..half { process a[i] = solids.Cube(1) mass 1
  at translate (2*ceil(i/2) - (long - 1)/2, 2*(i mod 2) - 3, 0) [Antigen] }
for i in 1..m { process b[i] = solids.Cube(1) mass 1
  at translate (2*ceil(i/2) - (long - 1)/2, 2*(i mod 2) + 1, 0) [Antibody] }
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check bridges_at_60 : E = ? [ count(p in b: behaviour(p) = Bridge) at 60 ]
check one_by_30     : P = ? [ eventually exists p in b: behaviour(p) = Bridge within 30 ]
