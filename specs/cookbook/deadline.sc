model deadline

timestep 1 steady
blocked wait

import <solids>

behaviour Ligand = <site, {right}>. nil
behaviour Site   = <~site, {left}>. nil

process ligand   = solids.Cube(1) mass 1 [Ligand]
fixed   receptor = solids.Cube(1) at translate (3, 0, 0) [Site]
fixed   wall     = solids.Cube(1) at translate (-2, 0, 0)

motion ligand = choose { (1, 0, 0), (-1, 0, 0) }

check in_time : P = ? [ eventually bound(ligand, receptor) within 8 ]
check mostly  : P >= 1/2 [ eventually bound(ligand, receptor) within 8 ]
