// A ratchet: a body that drifts to the right, though its kicks are fair. It walks on a track with teeth, at random along x or up and
// down, over the teeth or in the gaps between them, which are as wide as two of it. With its right face it binds to the tooth that it runs
// into, and lets go by chance; its left face binds to nothing, so that a tooth there throws it back. So it is in the right
// half of a gap for longer, and leaves the gap from there more often. What drives it are the bonds: that of a body at rest has no kicks.
// The mute one on a track of its own, which never binds, goes nowhere on the average, by symmetry.
model ratchet

timestep 1 steady

import <solids>

param steps = 4

behaviour Walker = <foot, {right}> . omega(foot, {right}) chance 1/4 . Walker
behaviour Tooth  = <~foot, {left}> . omega(foot, {left}) . Tooth

// Gaps are the places 1 and 2 modulo 3. Both start over a tooth, in the middle.
process walker = solids.Cube(1) mass 1 at translate (0, 1, 0) [Walker]
process mute   = solids.Cube(1) mass 1 at translate (0, 1, 20) [nil]
for k in -2..2 {
  fixed tooth[k] = solids.Cube(1) at translate (3*k, 0, 0) [Tooth]
  fixed stump[k] = solids.Cube(1) at translate (3*k, 0, 20)
}
for t in 0..1 {
  fixed floor[t] = solids.Cube(1) scaled (41, 1, 1) at translate (0, -1, 20*t)
  fixed ceiling[t] = solids.Cube(1) scaled (41, 1, 1) at translate (0, 3, 20*t)
}

motion walker = choose { (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0) }
motion mute   = choose { (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0) }

check drift   : E = ? [ x(walker) at steps ]                         // expect: 27/1024
check drifts  : E >= 1/40 [ x(walker) at steps ]                     // expect: holds
check mute_at : E = ? [ x(mute) at steps ]                           // expect: 0
