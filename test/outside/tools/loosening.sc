// Lots and free splits beside each other, so that probabilities have two ends. A middle one lets go of its left neighbour
// by chance, or of its right one as it likes; what it does afterwards depends on which. A pair is there beside them, and
// both of its ends draw.
model loosening

split_step 1/2

import <solids>

behaviour End    on solids.Cube(1) = omega(l, {right}) . nil + omega(r, {left}) . nil
behaviour Middle on solids.Cube(1) = omega(l, {left}) chance 1/3 . Slow + omega(r, {right}) . Fast
behaviour Slow   on solids.Cube(1) = omega(r, {right}) chance 1/5 . nil
behaviour Fast   on solids.Cube(1) = omega(l, {left}) chance 3/4 . nil
behaviour One    on solids.Cube(1) = omega(pair, {right}) chance 1/2 . nil
behaviour Other  on solids.Cube(1) = omega(pair, {left}) chance 1/4 . nil

process u = solids.Cube(1) mass 1 [End]
process v = solids.Cube(1) mass 1 at translate (1, 0, 0) [Middle]
process w = solids.Cube(1) mass 1 at translate (2, 0, 0) [End]
bond <l, {u.right, v.left}>
bond <r, {v.right, w.left}>

process p = solids.Cube(1) mass 1 at translate (0, 10, 0) [One]
process q = solids.Cube(1) mass 1 at translate (1, 10, 0) [Other]
bond <pair, {p.right, q.left}>

check apart      : P = ? [ eventually not bound(u, v) and not bound(v, w) within 2 ]
check left       : P = ? [ eventually not bound(u, v) within 1 ]
check right      : P = ? [ eventually not bound(v, w) ]
check left_first : P = ? [ bound(v, w) U not bound(u, v) ]
check pair       : P = ? [ eventually not bound(p, q) within 1 ]
check pair_first : P = ? [ bound(u, v) U not bound(p, q) ]
check long       : E = ? [ time U not bound(u, v) and not bound(v, w) ]
check sure       : P >= 1 [ eventually not bound(p, q) ]
check at_most    : P <= 1/2 [ eventually not bound(u, v) within 1/2 ]
check ever       : AF not bound(p, q)
