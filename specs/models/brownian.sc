// A ligand that diffuses in a flat box until it finds its pocket: kicks along a lattice, such that its mean squared
// displacement in a step is that of diffusion with the constant 1/8 in each of two directions (rule Diffuse). It is thrown
// back by walls, and binds when it hits the open face of the pocket. Steps keep their beat, and the lattice has its
// points where the box has room for the ligand, so that there are few states.
model brownian

timestep 1 steady

import <solids>

behaviour Seeking = <dock, {right}>. nil

process ligand = solids.Cube(1) mass 1 at translate (-5/2, 1/2, 0) [Seeking]
fixed pocket = solids.Cube(1) at translate (5/2, -3/2, 0) [<~dock, {left}>. nil]
fixed box = solids.Room(6, 4, 1, 1) at translate (0, 0, 0)

motion ligand = diffuse((1/8, 1/8, 0), (0, 0, 0), 1)

check finds  : possibly bound(ligand, pocket)                    // expect: holds
check always_may : AG EF bound(ligand, pocket)                   // expect: holds
check surely : eventually bound(ligand, pocket)                  // expect: violated
check almost : P >= 1 [ eventually bound(ligand, pocket) ]       // expect: holds
check by_ten : P = ? [ eventually bound(ligand, pocket) within 10 ]   // expect: 5413133/2147483648
check mean   : E = ? [ time U bound(ligand, pocket) ]            // expect: 126280323808/573735017
check knocks : E >= 44 [ event bounce U bound(ligand, pocket) ]  // expect: holds
check soon   : always not bound(ligand, pocket) within 11/2      // expect: holds
check at_six : always not bound(ligand, pocket) within 6         // expect: violated
check inside : always abs(x(ligand)) <= 5/2 and abs(y(ligand)) <= 3/2   // expect: holds
