// A reversible enzyme, in a membrane, and an inhibitor.
//
// Above the membrane a molecule goes up and down between the enzyme and a lid. It binds as a substrate, by
// `s`. From then on it may be released as it was, and after two more units of time, if it is still there, it
// reacts and is released as a product. The product binds too, by `p`, and becomes the substrate in the same
// way. Below the membrane the inhibitor does the same between the enzyme and a floor, but never reacts: it
// stays as long as it likes, and while it does the site is taken.
//
// What is released is at rest, and touches the enzyme still. The law of motion takes it away.
model enzyme

timestep 1
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}

behaviour Free      on Cube = <~s, {top}>. WithS + <~p, {top}>. WithP + <~i, {bottom}>. WithI
behaviour WithS     on Cube = omega(s, {top}). Free + rho({<s, {top}>}). Free
behaviour WithP     on Cube = omega(p, {top}). Free + rho({<p, {top}>}). Free
behaviour WithI     on Cube = omega(i, {bottom}). Free

behaviour Substrate on Cube = <s, {bottom}>. BoundS
behaviour BoundS    on Cube = omega(s, {bottom}). Substrate + eps(2). rho({<s, {bottom}>}). Product
behaviour Product   on Cube = <p, {bottom}>. BoundP
behaviour BoundP    on Cube = omega(p, {bottom}). Product + eps(2). rho({<p, {bottom}>}). Substrate

behaviour Inhibitor on Cube = <i, {top}>. Inhibits
behaviour Inhibits  on Cube = omega(i, {top}). Inhibitor

fixed   enzyme    = Cube [Free]
fixed   lid       = Cube at translate (0,5,0)
fixed   floor     = Cube at translate (0,-6,0)
process molecule  = Cube mass 1 velocity (0,-1,0) at translate (0,3,0) [Substrate]
process inhibitor = Cube mass 1 velocity (0,1,0) at translate (0,-4,0) [Inhibitor]

motion molecule  = (0, if vy = 0 then 1 else vy, 0)
motion inhibitor = (0, if vy = 0 then -1 else vy, 0)

let free = behaviour(enzyme) = Free
let product = behaviour(molecule) = Product

check answered    : event bind(s) leads_to event split(s) within 2       // expect: holds
check recovers    : AG EF free                                           // expect: holds
check surely_free : AG AF free                                           // expect: violated
check turns_over  : AG EF event strong                                   // expect: holds
check back        : AG (product => EF behaviour(molecule) = Substrate)   // expect: holds
check one_site    : always bonds() <= 1                                  // expect: holds
check no_short    : not E[ not event bind(s) U event strong(s) ]         // expect: holds
check not_at_once : AG (event bind(s) => not EF[0, 1] event strong(s))   // expect: holds
check on_time     : AG (event bind(s) => EF[2, 2] event strong(s))       // expect: holds
check blocked     : EF EG bound(enzyme, inhibitor)                       // expect: holds
check then_away   : AG (event strong => AX not event bind(s, molecule))  // expect: holds
