// Lots are drawn in an order of places (rule Lot), and nothing that is asked depends on it (law Impartiality): two dimers far
// from each other, of which the first lets go by one of two ways, at random, and a free end of the other one chooses. All lots
// of an instant are drawn before anything is chosen, so that who chooses knows the outcome, wherever it stands (try -D far=-10).
// What goes at one instant goes at once: nobody sees which of the two dimers was first. But a formula within another one
// tells a state in which one lot has been drawn and the other one has not: with far=-10 there is no such state.
model lots

param far = 10
split_step 1

import <solids>

behaviour Either on solids.Cube(1) = omega(a, {right}) chance 1/2 . Red + omega(a, {right}) chance 1/2 . Blue
behaviour Red    on solids.Cube(1) = nil
behaviour Blue   on solids.Cube(1) = nil
behaviour Surely on solids.Cube(1) = omega(b, {right}) chance 1/2 . nil
behaviour Free   on solids.Cube(1) = omega(b, {left}) . Low + omega(b, {left}) . High
behaviour Low    on solids.Cube(1) = nil
behaviour High   on solids.Cube(1) = nil

process p = solids.Cube(1) mass 1 at translate (0, 0, 0) [Either]
process q = solids.Cube(1) mass 1 at translate (1, 0, 0) [omega(a, {left}) . nil]
process u = solids.Cube(1) mass 1 at translate (far, 0, 0) [Surely]
process v = solids.Cube(1) mass 1 at translate (far + 1, 0, 0) [Free]
bond <a, {p.right, q.left}>
bond <b, {u.right, v.left}>

check matches : Pmax = ? [ eventually behaviour(p) = Red and behaviour(v) = Low or behaviour(p) = Blue and behaviour(v) = High ]  // expect: greatest 1
check at_once : Pmax = ? [ eventually behaviour(p) = Red and bound(u, v) within 1 ]                                               // expect: greatest 1/4
check half    : EF (bound(p, q) and P >= 1 [ eventually behaviour(p) = Red within 0 ] and P > 0 [ eventually not bound(u, v) within 0 ] and P < 1 [ eventually not bound(u, v) within 0 ])  // expect: holds
