// A bivalent ligand crosslinks two receptors of a membrane. With two feet, like an antibody, it wanders over the membrane on a
// lattice; a foot that comes down on a receptor binds it. Receptors are anchored in the membrane, so that ligand and membrane
// are one process then, and where the other foot is over a receptor, too, the second bond closes at once (rule Close).
//
// Bonds break by chance. A foot that has just let go is not ready for a time of 3/2; until then the ligand is held by one foot, and leaves
// if that breaks as well. So what is held by one foot leaves within 3 with probability 37/64 at least, and what is held by two with
// 1/3 at most, though their bonds are the same: this is avidity.
//
// More ligands make fewer crosslinks: each takes a receptor of its own, and is in the way of the others (the prozone effect). At time 12
// there is a crosslink with probability 0.103; with -D ligands=2 it is between 0.030 and 0.032.
model crosslink

timestep 1 steady
bonds cyclic

import <solids>

param ligands = 1

compound Ligand {
  part left  : solids.Cube(1) mass 1 at translate (-1, 0, 0)
  part mid   : solids.Cube(1) mass 1
  part right : solids.Cube(1) mass 1 at translate (1, 0, 0)
  glue left.right ~ mid.left
  glue mid.right ~ right.left
}

behaviour Free      on Ligand = <fab, {only left.bottom}> . ByLeft + <fab, {only right.bottom}> . ByRight
behaviour ByLeft    on Ligand = <fab, {only right.bottom}> . ByBoth + omega(fab, {left.bottom}) chance 1/4 . Free
behaviour ByRight   on Ligand = <fab, {only left.bottom}> . ByBoth + omega(fab, {right.bottom}) chance 1/4 . Free
behaviour ByBoth    on Ligand = omega(fab, {left.bottom}) chance 1/4 . LeftLost + omega(fab, {right.bottom}) chance 1/4 . RightLost
behaviour LeftLost  on Ligand = eps(3/2) . ByRight + omega(fab, {right.bottom}) chance 1/4 . Free
behaviour RightLost on Ligand = eps(3/2) . ByLeft + omega(fab, {left.bottom}) chance 1/4 . Free

behaviour Receptor = <~fab, {only top}> . Taken
behaviour Taken    = omega(fab, {top}) . Receptor
behaviour Membrane = nil

fixed cell = solids.Room(7, 1, 7/2, 1) at translate (0, 0, 5/4) [Membrane]
for i in 1..2 {
  fixed receptor[i] = solids.Cube(1) at translate (2*i - 3, 0, 0) [Receptor]
  bond <anchor, {receptor[i].bottom, cell.floor.top}>
}
for i in 1..ligands {
  process ligand[i] = Ligand at translate (if i = 1 then -2 else 2, 0, 2) [Free]
  motion  ligand[i] = choose { (1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1) }
}

let crosslink = exists i in 1..ligands: bound(ligand[i], receptor[1]) and bound(ligand[i], receptor[2])
let held      = exists i in 1..2: bound(ligand[1], receptor[i])
let by_both   = forall i in 1..2: bound(ligand[1], receptor[i])
let by_one    = held and x(ligand[1]) != 0    // in the middle it has both, or gets them at once

check can       : possibly crosslink                                            // expect: holds
check not_at_once : possibly crosslink within 1/2                                  // expect: violated
check leaves    : AG (by_one => P >= 37/64 [ eventually not held within 3 ])      // expect: holds
check stays     : AG (by_both => P <= 1/3 [ eventually not held within 3 ])       // expect: holds
check not_ever  : AG (by_both => P >= 1 [ eventually not held ])                  // expect: holds
check anchored  : always bonds(anchor) = 2                                        // expect: holds
check at_6      : E = ? [ if crosslink then 1 else 0 at 6 ]                       // expect: 36467/524288
