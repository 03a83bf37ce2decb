// Square shells of four: a seed for every three bodies stands still; three kinds of walkers fit its corner and each other.
model capsids
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
let shells = ceil(n/3)
behaviour Seed = <e, {only right}> . Rest + <w, {only back}> . Rest2
behaviour Rest  = <w, {only back}> . nil
behaviour Rest2 = <e, {only right}> . nil
behaviour East  = <~e, {only left}> . EastIn
behaviour EastIn = <last, {only back}> . nil
behaviour North = <~w, {only front}> . nil
behaviour Last  = <~last, {only front}> . nil
fixed room = solids.Room(6*shells + 2, 6, 1, 1)
for i in 1..shells {
  let x0 = 6*(i - 1) - 3*(shells - 1)
  fixed seed[i] = solids.Cube(1) at translate (x0, 1/2, 0) [Seed]
  process a[i] = solids.Cube(1) mass 1 at translate (x0 + 2, -3/2, 0) [East]
  process b[i] = solids.Cube(1) mass 1 at translate (x0 - 2, 5/2, 0) [North]
  process d[i] = solids.Cube(1) mass 1 at translate (x0 + 2, 5/2, 0) [Last]
}
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check shells_at_100 : E = ? [ count(s in seed: size(s) = 4) at 100 ]
check one_by_50     : P = ? [ eventually size(seed[1]) = 4 within 50 ]
