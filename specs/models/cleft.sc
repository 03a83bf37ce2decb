// A ligand is released in a cleft, at the distance d from a receptor and at the height h, and walks at random. How likely
// does it bind within four steps, from anywhere? (Guide, "How likely is it from anywhere in a region?")
//
//   scc check specs/models/cleft.sc --where
model cleft
timestep 1 steady
import <solids>
param d in [0, 3]
param h in [0, 2]
behaviour Site   on solids.Cube(2) = <site, {top}>. nil
behaviour Ligand on solids.Cube(2) = <~site, {bottom}>. nil
fixed membrane   = box(24, 4, 2) at translate (0, 0, -5/2)
fixed receptor   = solids.Cube(2) scaled (1, 1, 1/4) at translate (0, 0, -5/4) [Site]
process ligand   = solids.Cube(2) mass 1 at translate (d, 0, 1/2 + h) [Ligand]
motion ligand    = choose { (1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1) }
check likely : P >= 1/8 [ eventually bound(ligand, receptor) within 4 ] // expect: violated
check rare   : P <= 1/2 [ eventually bound(ligand, receptor) within 4 ] // expect: holds
