model diffusion

timestep 1/4 steady

import <solids>

process p = solids.Cube(1) mass 1 [nil]
fixed room = solids.Room(9, 9, 9, 1)

motion p = diffuse(1/2)
