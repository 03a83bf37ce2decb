// A walk on a line of 200 places, to the right with the chance k.
model line
timestep 1
import <solids>
param k in (0, 1)
process w = solids.Cube(1) mass 1 [nil]
fixed low = solids.Cube(1) absorb at translate (-100, 0, 0)
fixed high = solids.Cube(1) absorb at translate (101, 0, 0)
motion w = choose { (1, 0, 0) weight k, (-1, 0, 0) weight 1 - k }
check often : P = ? [ eventually event absorb(w, high) ]
