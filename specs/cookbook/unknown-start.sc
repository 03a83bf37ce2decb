model unknown_start

param y in [-3, 3]
param delay in [0, 4]

behaviour Waits  = eps(delay). <dock, {right}>. nil
behaviour Target = <~dock, {left}>. nil

process ligand = box(2, 2, 2) mass 1 velocity (1, 0, 0) at translate (-5, 0, 0) * translate (0, y, 0) [Waits]
fixed   target = box(2, 2, 2) [Target]

check docks : eventually bound(ligand, target)
