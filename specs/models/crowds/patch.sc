// n ligands in a room, and a patch with five places in the wall on which they stay.
model patch
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
let long = 2*ceil(n/3) + 7
behaviour Ligand = <dock, {only right}> . nil
behaviour Patch  = <~dock, {only left}> . nil
fixed room = solids.Room(long, 5, 1, 1)
for k in 1..5 { fixed patch[k] = solids.Cube(1) at translate ((long - 1)/2, k - 3, 0) [Patch] }
for i in 1..n { process lig[i] = solids.Cube(1) mass 1
  at translate (2*floor((i - 1)/3) - (long - 1)/2, 2*((i - 1) mod 3) - 2, 0) [Ligand] }
motion lig = choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check bound_at_50 : E = ? [ bonds(dock) at 50 ]
check any_by_20   : P = ? [ eventually bonds(dock) >= 1 within 20 ]
