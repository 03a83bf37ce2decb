// A filament grows at two ends of a fixed seed, which take monomers by chance at different rates; n monomers walk along it.
model filament
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
let long = 4*n + 1
behaviour Monomer = <plus, {only left}> . Plus + <minus, {only right}> . Minus
behaviour Plus  = <~plus, {only right}> . nil
behaviour Minus = <~minus, {only left}> . nil
behaviour Seed  = <~plus, {only right}> . Minus + <~minus, {only left}> . Plus
fixed room = solids.Room(long, 3, 1, 1)
fixed seed = solids.Cube(1) [Seed]
for i in 1..n { process m[i] = solids.Cube(1) mass 1
  at translate ((if i mod 2 = 0 then 1 else -1)*2*ceil(i/2), 1, 0) [Monomer] }
motion m = choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check grown : E = ? [ size(seed) at 40 ]
check two   : P = ? [ eventually size(seed) >= 3 within 20 ]
