model simple

import <solids>

behaviour Held  = omega(dock, {right}). nil
behaviour Holds = omega(dock, {left}). nil
process ligand = solids.Cube(1) mass 1 [Held]
process pocket = solids.Cube(1) mass 1 at translate (1, 0, 0) [Holds]
bond <dock, {ligand.right, pocket.left}>
