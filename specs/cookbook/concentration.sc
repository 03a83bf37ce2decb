model concentration

timestep 1 steady
blocked wait

import <solids>

param ligands = 1

behaviour Ligand = <site, {only left}>. nil
behaviour Site   = <~site, {only right}>. nil

fixed enzyme = solids.Cube(1) at translate (-1, 0, 0) [Site]
fixed room   = solids.Room(9, 1, 1, 1) at translate (3, 0, 0)
for i in 1..ligands {
  process ligand[i] = solids.Cube(1) mass 1 at translate (9 - 2*i, 0, 0) [Ligand]
}

motion choose { (1, 0, 0), (-1, 0, 0) }

check taken : E = ? [ time U bonds(site) = 1 ]
