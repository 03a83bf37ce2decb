model for_ever

param speed = 2/3

import <solids>

fixed   west = solids.Cube(2) at translate (-10, 0, 0)
fixed   east = solids.Cube(2)
process p = solids.Cube(2) mass 1 velocity (speed, 0, 0) at translate (-15/2, 0, 0) [nil]
process q = solids.Cube(2) mass 1 velocity (-1, 0, 0) at translate (-3, 0, 0) [nil]
process r = solids.Cube(2) mass 1 velocity (1, 0, 0) at translate (5, 0, 0) [nil]

check in_order : always x(p) + 2 <= x(q)
check kept_out : always not touching(q, r)
