model why

behaviour Ligand = <dock, {right}>. nil
behaviour Pocket = <~dock, {left}>. nil

process ligand   = box(1, 1, 1) mass 1 velocity (1, 0, 0) [Ligand]
process pocket   = box(1, 1, 1) mass 1 at translate (8, 0, 0) [Pocket]
process crosser  = box(1, 1, 1) mass 1 velocity (0, 1, 0) at translate (4, -9/2, 0) [nil]
process far      = box(1, 1, 1) mass 1 velocity (0, 0, 1) at translate (0, 20, 0) [nil]
fixed   ceiling  = box(1, 1, 1) at translate (0, 20, 4)

check docks : eventually bound(ligand, pocket) within 20
