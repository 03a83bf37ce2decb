// A signal passes by contact: one of n walkers has it at first, and who has it hands it on to those it touches.
model signal
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
let long = 2*ceil(n/3) + 1
behaviour Sender   = <s, {only left, only right, only front, only back}> . Gives
behaviour Gives    = rho({<s, {only left, only right, only front, only back}>}) . Sender
behaviour Silent   = <~s, {only left, only right, only front, only back}> . Takes
behaviour Takes    = rho({<s, {only left, only right, only front, only back}>}) . Sender
fixed room = solids.Room(long, 6, 1, 1)
process first = solids.Cube(1) mass 1 at translate (0, 5/2, 0) [Sender]
for i in 1..n - 1 { process w[i] = solids.Cube(1) mass 1
  at translate (2*floor((i - 1)/3) - (long - 1)/2, 2*((i - 1) mod 3) - 5/2, 0) [Silent] }
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check informed_at_40 : E = ? [ count(q in w: behaviour(q) = Sender) at 40 ]
check all_by_100     : P = ? [ eventually forall q in w: behaviour(q) = Sender within 100 ]
