// Pegs fall into holes. The i-th is open after i counts: those that are in time stay, the others bounce off and are gone.
// The block is of the library, the peg of a mesh with rounded decimals that a module of this model snaps (parts/peg.sc), and
// `scc check specs/models/pegs.sc -D peg.patience=1/2` lets all of them fit.
model pegs

import <solids> (Chamfered)
import "parts/peg.sc"

param n = 4
let height = 5/2   // how far they fall

for i in 1..n {
  let along = (3*i, 0, 0)
  fixed block[i] = Chamfered(2, 1/4) at translate along [peg.Hole(top)]
  process p[i] = peg.Peg mass i velocity (0, 0, -1) at translate (along + (0, 0, 2 + height)) [peg.Waiting[i]]
}

check fits   : forall i in 1..n if i*peg.patience < height: eventually bound(p[i], block[i]) within height + 1/1000  // expect: holds
check stays  : forall i in 1..n: AG (bound(p[i], block[i]) => AG speed2(p[i]) = 0)                            // expect: holds
check leaves : forall i in 1..n if i*peg.patience > height: AG not bound(p[i], block[i])                      // expect: holds
check told   : forall i in 1..n if i*peg.patience > height: eventually event hit(p[i], block[i])              // expect: holds
check open   : forall i in 1..n if i*peg.patience > height: AF (offers(p[i], ~peg) and vz(p[i]) = 1)           // expect: holds
check counts : A[ behaviour(p[1]) = peg.Waiting[1] U behaviour(p[1]) = peg.Waiting[0] ]                       // expect: holds
check hole   : AG (offers(block[1], peg) or bound(p[1], block[1]))                                            // expect: holds
check all    : eventually forall i in 1..n: bound(p[i], block[i])                                             // expect: violated
