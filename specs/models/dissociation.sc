// Bonds that break by chance (rule Lot). A dimer lets go with probability 1/4 at each split instant, so that it lives for n
// steps with probability (3/4)^n, and for 4 steps of 1/2 on the average. A trimer holds on at both sides of its middle,
// which lets go of one neighbour only: with 1/2 of the left one, with 1/3 of the right one; where both would go, each is the
// first with 1/2. So of the first step the left one leaves with probability 1/2 * 2/3 + 1/2 * 1/3 * 1/2 = 5/12. A complex
// breaks at the rate 2, or reacts at the rate 1: so it reacts with probability 1/3, exactly, and is there at time 1 with probability
// exp(-3), up to the error of rates. The free one of its two ends does what the other one has drawn.
model dissociation

split_step 1/2

import <solids>

behaviour Left   on solids.Cube(1) = omega(bond, {right}) chance 1/4 . nil
behaviour Right  on solids.Cube(1) = omega(bond, {left}) . nil
behaviour Middle on solids.Cube(1) = omega(l, {left}) chance 1/2 . Lost + omega(r, {right}) chance 1/3 . Kept
behaviour Lost   on solids.Cube(1) = nil
behaviour Kept   on solids.Cube(1) = nil
behaviour End    on solids.Cube(1) = omega(l, {right}) . nil + omega(r, {left}) . nil
behaviour Enzyme on solids.Cube(1) = omega(site, {right}) rate 2 . Free + omega(site, {right}) rate 1 . Product
behaviour Free   on solids.Cube(1) = nil
behaviour Product on solids.Cube(1) = nil
behaviour Ligand on solids.Cube(1) = omega(site, {left}) . nil

process a = solids.Cube(1) mass 1 [Left]
process b = solids.Cube(1) mass 1 at translate (1, 0, 0) [Right]
bond <bond, {a.right, b.left}>

process u = solids.Cube(1) mass 1 at translate (0, 10, 0) [End]
process v = solids.Cube(1) mass 1 at translate (1, 10, 0) [Middle]
process w = solids.Cube(1) mass 1 at translate (2, 10, 0) [End]
bond <l, {u.right, v.left}>
bond <r, {v.right, w.left}>

process e = solids.Cube(1) mass 1 at translate (0, 20, 0) [Enzyme]
process s = solids.Cube(1) mass 1 at translate (1, 20, 0) [Ligand]
bond <site, {e.right, s.left}>

check dimer_breaks : P >= 1 [ eventually not bound(a, b) ]                // expect: holds
check dimer_lasts  : eventually not bound(a, b)                           // expect: violated
check dimer_by_two : P = ? [ eventually not bound(a, b) within 2 ]        // expect: 175/256
check dimer_life   : E = ? [ time U not bound(a, b) ]                     // expect: 2
check not_sooner   : always bound(a, b) within 1/4                        // expect: holds
check left_first   : P = ? [ eventually behaviour(v) = Lost within 1/2 ]  // expect: 5/12
check right_first  : P = ? [ eventually behaviour(v) = Kept within 1/2 ]  // expect: 1/4
check one_only     : AG (bound(u, v) or bound(v, w))                      // expect: holds
check left_at_all  : P = ? [ eventually behaviour(v) = Lost ]             // expect: 5/8
check reacts       : P = ? [ eventually behaviour(e) = Product ]          // expect: 1/3
check is_left      : P >= 49787068367e-12 [ always bound(e, s) within 1 ]    // expect: holds
check is_left_most : P <= 49787068369e-12 [ always bound(e, s) within 1 ]    // expect: holds
