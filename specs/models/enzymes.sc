// Two enzymes and one substrate that goes to and fro between them: what the first makes of it the second turns back. Each
// holds it for a while. What is let go by a `fixed` body is at rest; a law drives it off, with steps that keep their beat.
model enzymes

timestep 1 steady

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Kinase      on Cube = <k, {only right}>. KinaseHolds
behaviour KinaseHolds on Cube = eps(2). rho({<k, {only right}>}). Kinase
behaviour Phosphatase on Cube = <f, {only left}>. PhosphataseHolds
behaviour PhosphataseHolds on Cube = eps(3). rho({<f, {only left}>}). Phosphatase

behaviour Plain      on Cube = <~k, {only left}>. AtKinase
behaviour AtKinase   on Cube = rho({<k, {only left}>}). Charged
behaviour Charged    on Cube = <~f, {only right}>. AtPhosphatase
behaviour AtPhosphatase on Cube = rho({<f, {only right}>}). Plain

fixed kinase      = Cube at translate (-6, 0, 0) [Kinase]
fixed phosphatase = Cube at translate (6, 0, 0) [Phosphatase]
process s = Cube mass 1 velocity (-1, 0, 0) [Plain]

motion s = (if vx != 0 then vx else if x < 0 then 1 else -1, 0, 0)

let charged = behaviour(s) = Charged

check charges  : eventually charged                                     // expect: holds
check cycle    : AG AF charged and AG AF not charged                    // expect: holds
check period   : AG (event bind(k) => AF[1, 23] event bind(k))          // expect: holds
check faster   : AG (event bind(k) => AF[1, 22] event bind(k))          // expect: violated
check one      : always bonds() <= 1                                    // expect: holds
check in_turn  : AG (event strong(k) => A[ not event bind(k) U event bind(f) ])  // expect: holds
check never_stops : EF AG bound(s, kinase)                              // expect: violated
