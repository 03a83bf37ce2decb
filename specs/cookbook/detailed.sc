model detailed

import <solids>

behaviour Held  = omega(dock, {right}). Free
behaviour Free  = nil
behaviour Holds = omega(dock, {left}). nil
process ligand = solids.Cube(1) mass 1 [Held]
process pocket = solids.Cube(1) mass 1 at translate (1, 0, 0) [Holds]
process tail   = solids.Cube(1) mass 1 at translate (9, 0, 0) [nil]
bond <dock, {ligand.right, pocket.left}>
