The original notation: regions of contact, solids with names.

  $ cp ../../specs/models/patch.osc ../../specs/models/dimer.sc .
  $ scc check patch.osc 2> /dev/null | grep :.holds
  docks: holds (exhaustive), at split step 1/2
  apart: holds (exhaustive), at split step 1/2
  beside: holds (exhaustive), at split step 1/2
  $ scc fmt --check patch.osc
  $ scc translate patch.osc --to refined -o patch.sc
  $ grep -e '^// [a-zP]' -e part -e dock patch.sc
  // and binds by its lower cap to a patch of the plate's surface, a triangle that is
  // no face of any solid.
  // what stands for a sphere is inscribed in it by 8 corners to a turn, at the Hausdorff distance of at most 71945/524288 of its radius
  // balls as polyhedra, as near as a fifth of their radius
  // Plate is cut along the regions of it, into 7 parts
    part p1 : Plate'p1 mass 731/2560*mass_of_all at translate (-21001/8772, 10007/10965, 0)
    part p2 : Plate'p2 mass 207/2560*mass_of_all at translate (-7/20, 3, 0)
    part p3 : Plate'p3 mass 23/512*mass_of_all at translate (1/6, -1/2, 0)
    part p4 : Plate'p4 mass 643/2560*mass_of_all at translate (43861/19290, 6149/3858, 0)
    part p5 : Plate'p5 mass 107/1280*mass_of_all at translate (-863/321, -4541/1605, 0)
    part p6 : Plate'p6 mass 23/128*mass_of_all at translate (11/16, -67/24, 0)
    part p7 : Plate'p7 mass 19/256*mass_of_all at translate (1441/456, -439/228, 0)
  behaviour Open = <dock, {p1.[v8, v10], p2.v4, p3.top, p4.[v2, v6], p5.v8, p6.[v4, v6], p7.v2}>. Held
    omega(dock, {p1.[v8, v10], p2.v4, p3.top, p4.[v2, v6], p5.v8, p6.[v4, v6], p7.v2}). Open
  behaviour Free on Ball = <~dock, {f1_1, f1_2, f1_3, f1_4, f1_5, f1_6, f1_7, f1_8}>. Taken
  behaviour Taken on Ball = omega(dock, {f1_1, f1_2, f1_3, f1_4, f1_5, f1_6, f1_7, f1_8}). nil
  check docks : possibly bound(plate, ball) within 4 // expect: holds
  check apart : AG[<= 4] (bound(plate, ball) => EF[<= 1] not bound(plate, ball)) // expect: holds
  $ scc check patch.sc 2> /dev/null | grep :.holds
  docks: holds (exhaustive), at split step 1/2
  apart: holds (exhaustive), at split step 1/2
  beside: holds (exhaustive), at split step 1/2
  $ scc translate patch.sc --to original -o again.osc
  $ scc translate again.osc --to sc | diff patch.sc -
  113c113,114
  < behaviour Open = <dock, {p1.[v8, v10], p2.v4, p3.top, p4.[v2, v6], p5.v8, p6.[v4, v6], p7.v2}>. Held
  ---
  > behaviour Open =
  >   <dock, {[p1.v8, p1.v10], p2.v4, p3.top, [p4.v2, p4.v6], p5.v8, [p6.v4, p6.v6], p7.v2}>. Held
  115c116
  <   omega(dock, {p1.[v8, v10], p2.v4, p3.top, p4.[v2, v6], p5.v8, p6.[v4, v6], p7.v2}). Open
  ---
  >   omega(dock, {[p1.v8, p1.v10], p2.v4, p3.top, [p4.v2, p4.v6], p5.v8, [p6.v4, p6.v6], p7.v2}). Open
  [1]

Models of the language in it, and back:

  $ scc translate dimer.sc --to original | grep -v '^//'
  model dimer
  
  timestep 1/4
  split_step 1/2
  
  shape Cube =
    polyhedron((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))
  region a on Cube = point((-1, -1, -1))
  region b on Cube = point((1, -1, -1))
  region c on Cube = point((1, 1, -1))
  region d on Cube = point((-1, 1, -1))
  region e on Cube = point((-1, -1, 1))
  region f on Cube = point((1, -1, 1))
  region g on Cube = point((1, 1, 1))
  region h on Cube = point((-1, 1, 1))
  region bottom on Cube = polygon((-1, -1, -1), (-1, 1, -1), (1, 1, -1), (1, -1, -1))
  region top on Cube = polygon((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))
  region left on Cube = polygon((-1, -1, -1), (-1, -1, 1), (-1, 1, 1), (-1, 1, -1))
  region right on Cube = polygon((1, -1, -1), (1, 1, -1), (1, 1, 1), (1, -1, 1))
  region front on Cube = polygon((-1, -1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1))
  region back on Cube = polygon((-1, 1, -1), (-1, 1, 1), (1, 1, 1), (1, 1, -1))
  
  behaviour Left on Cube = eps(2). omega(bond, right). Loose
  behaviour Right on Cube = eps(1). (omega(bond, left). Loose + eps(1/2). nil)
  behaviour Loose on Cube = nil
  behaviour Fuse on Cube = eps(3). rho({<bond, left + right>}). Loose
  
  process weak =
    w1 : Cube mass 1 [Left]
    <bond, w1.right * w2.left>
    w2 : Cube mass 1 at translate (2, 0, 0) [Right]
  process strong =
    s1 : Cube mass 1 at translate (0, 10, 0) [Fuse]
    <bond, s1.right * s2.left>
    s2 : Cube mass 2 at translate (2, 10, 0) [Fuse]
  
  check born : always bonds(bond) = 2 => same(w1, w2) and same(s1, s2) // expect: holds
  check reacts : eventually not bound(s1, s2) // expect: holds
  check by_three : eventually not bound(s1, s2) within 3 // expect: holds
  check no_soon : always bound(s1, s2) within 2 // expect: holds
  check loosens : possibly behaviour(w1) = Loose // expect: holds
  check must : eventually behaviour(w1) = Loose // expect: violated
  check delay : always bound(w1, w2) within 1 // expect: holds
  check waits : possibly not offers(w1, bond) // expect: holds
  check rest : always energy = 0 // expect: holds
  $ for m in figure7 dimers pocket closed_ring docking recursive; do
  >   scc translate ../../specs/models/$m.sc --to original -o $m.osc
  >   scc compare ../../specs/models/$m.sc $m.osc --modulo strong --states 500 | head -1
  > done
  equivalent modulo strong
  equivalent modulo strong
  equivalent modulo strong
  equivalent modulo strong
  equivalent modulo strong
  equivalent modulo strong

Signs of sets, and what is told at its place:

  $ printf 'shape B = box(2, 2, 2)\nprocess p = B mass 1 [<a, top ∪ left ∖ interior(top)>. nil]\n' > b.osc
  $ scc fmt b.osc
  shape B = box(2, 2, 2)
  process p = B mass 1 [<a, top + left - interior(top)>. nil]
  $ scc translate b.osc
  shape B = box(2, 2, 2)
  process p = B mass 1 [<a, {left, [e, f], [f, g], [g, h]}>. nil]
  $ printf 'process p = box(2, 2, 2) mass 1 [<a, top ∪>. nil]\n' > c.osc
  $ scc check c.osc
  c.osc:1:43: error[SC0110]: `>` does not fit here: expected a number on the right of this operator
     |
   1 | process p = box(2, 2, 2) mass 1 [<a, top ∪>. nil]
     |                                           ^
  [3]
  $ printf 'shape B = box(2, 2, 2)\nprocess p = B mass 1 [<a, tip>. nil]\n' > b.osc
  $ scc check b.osc
  b.osc:2:27: error[SC0203]: `B` has no feature `tip`
     |
   2 | process p = B mass 1 [<a, tip>. nil]
     |                           ^^^
  note: its faces are bottom, top, left, right, front, back; its vertices a, b, c, d, e, f, g, h
    hint: did you mean `top`?
  [3]
  $ printf 'process p = box(2, 2, 2) mass 1 [<a, {AG}>. nil]\n' > ag.sc
  $ scc translate ag.sc --to original
  ag.sc:1:39: error[SC0360]: `AG` cannot be the name of a region: it is an operator there
     |
   1 | process p = box(2, 2, 2) mass 1 [<a, {AG}>. nil]
     |                                       ^^
  [3]
