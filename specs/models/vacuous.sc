// A deliberately vacuous model: every check holds, and says next to nothing. The ball would bind at the bottom and
// be shed again at the top, but it flies over the plate and meets neither it nor anything else. `scc check
// specs/models/vacuous.sc --coverage` lists what never happens; the warnings come without it.
model vacuous

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}

behaviour Free  on Cube = <stick, {bottom}>. Stuck
behaviour Stuck on Cube = omega(stick, {bottom}). Free + rho({<stick, {bottom}>}). Spent
behaviour Spent on Cube = nil
behaviour Bare  on Cube = <~stick, {top}>. Taken
behaviour Taken on Cube = omega(stick, {top}). Bare + rho({<stick, {top}>}). Bare

fixed   plate = Cube [Bare]
process ball  = Cube mass 1 velocity (1,0,0) at translate (-5,3,0) [Free]

check no_loss  : always (bound(ball, plate) => vx(ball) = 0)                            // expect: holds
check released : behaviour(ball) = Stuck leads_to behaviour(ball) = Spent within 5      // expect: holds
check at_most  : always bonds(stick) <= 1                                                // expect: holds
