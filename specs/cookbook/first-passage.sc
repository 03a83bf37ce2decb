model first_passage

timestep 1 steady
blocked wait

import <solids>

param far = 5

process walker = solids.Cube(1) mass 1 [nil]
fixed   wall   = solids.Cube(1) at translate (-1, 0, 0)

motion walker = choose { (1, 0, 0), (-1, 0, 0) }

check mean : E = ? [ time U x(walker) = far ]
