// Bone remodelling, after the phases that the literature tells (the unit of time is a week). Resorption: osteoclasts come down to the
// surface of the bone, seal onto it, dissolve a grain of mineral each in 3 weeks, and leave with it for the marrow, where they end. Reversal:
// osteoblasts come along the surface to the pits, each with osteoid. Formation: the osteoid binds to the floor of its pit, and is mineral after
// 12 weeks. Resting: the osteoblast stays on it as a lining cell, and no osteoclast gets at the new bone.
//
// That nothing is formed before the old bone has gone, and no more than that, needs no signal here: it follows from the room that there is.
// With fewer osteoblasts than osteoclasts (-D osteoblasts=1), as in osteoporosis, a pit stays open for ever.
model bone

timestep 1 steady

import <solids>

param pits = 2
param osteoblasts = 2

behaviour Sealed  on solids.Cube(1) = rho({<mineral, {top}>}) . Pit
behaviour Pit     on solids.Cube(1) = <mineral, {only top}> . Filled
behaviour Filled  on solids.Cube(1) = nil

behaviour Mineral    on solids.Cube(1) = <~resorb, {only top}> . eps(3) . rho({<mineral, {bottom}>}) push(2) . Dissolved
behaviour Dissolved  on solids.Cube(1) = nil
behaviour Osteoclast on solids.Cube(1) = <resorb, {only bottom}> . Active
behaviour Active     on solids.Cube(1) = nil

behaviour Osteoid on solids.Cube(1) = <~mineral, {only bottom}> . Forming
behaviour Forming on solids.Cube(1) = eps(12) . NewBone
behaviour NewBone on solids.Cube(1) = nil
behaviour Osteoblast on solids.Cube(1) = nil

fixed before = solids.Cube(1) at translate (0, 0, 0)
fixed behind = solids.Cube(1) at translate (pits + 1, 0, 0)
for i in 1..pits {
  fixed   bed[i] = solids.Cube(1) at translate (i, 0, -1) [Sealed]
  process old[i] = solids.Cube(1) mass 1 at translate (i, 0, 0) [Mineral]
  bond <mineral, {bed[i].top, old[i].bottom}>
  process osteoclast[i] = solids.Cube(1) mass 1 velocity (0, 0, -1) at translate (i, 0, 1 + i) [Osteoclast]
}
for i in 1..osteoblasts {
  process osteoid[i]    = solids.Cube(1) mass 1 at translate (i, 10, 2) [Osteoid]
  process osteoblast[i] = solids.Cube(1) mass 1 at translate (i, 10, 3) [Osteoblast]
  bond <secrete, {osteoblast[i].bottom, osteoid[i].top}>
  motion osteoid[i]    = if y > 0 then (0, -1, 0) else (0, 0, -1)
  motion osteoblast[i] = if y > 0 then (0, -1, 0) else (0, 0, -1)
}
fixed marrow = solids.Plank(20, 3, 1) absorb at translate (0, 0, 8)

let resorbed = count(i in 1..pits: behaviour(bed[i]) = Pit)
let formed   = count(i in 1..osteoblasts: behaviour(osteoid[i]) = NewBone)

check resorption : eventually resorbed = pits within 5                                       // expect: holds
check reversal   : A[ formed = 0 U[10, 13] exists i in 1..osteoblasts: event bind(mineral, osteoid[i]) ]       // expect: holds
check formation  : AF[24, 25] formed = pits                                                  // expect: holds
check resting    : AG (formed = pits => AG formed = pits)                                     // expect: holds
check balanced   : AF AG bonds(mineral) = pits                                               // expect: holds
check no_more    : always bonds(mineral) <= pits                                             // expect: holds
check coupled    : AG forall i in 1..osteoblasts: event bind(mineral, osteoid[i]) => gone(osteoclast[i])  // expect: holds
