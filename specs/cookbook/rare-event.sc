model rare_event

timestep 1 steady
blocked wait

import <solids>

process walker = solids.Cube(1) mass 1 [nil]
fixed   ground = solids.Cube(1) absorb at translate (-2, 0, 0)
fixed   top    = solids.Cube(1) absorb at translate (13, 0, 0)

motion walker = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight 3 }

check climbs : P = ? [ eventually event absorb(walker, top) ]
