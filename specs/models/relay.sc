// A relay: the first cube runs into the second, they bind, and the pair runs on into the next, until all are
// one. Each meets its own fate at its own time; `forall` and `exists` over the cubes stand outside of
// operators (each has a run of its own) or inside (at one instant).
model relay

param n = 4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Free on Cube = <link, {right}>. Head + <~link, {left}>. Tail
behaviour Head on Cube = <~link, {left}>. nil
behaviour Tail on Cube = <link, {right}>. nil

process c[1] = Cube mass 1 velocity (1,0,0) at translate (3,0,0) [Free]
for i in 2..n { process c[i] = Cube mass 1 at translate (3*i,0,0) [Free] }

check joined   : forall c in Cube: eventually event bind(link, c)                               // expect: holds
check stays    : forall c in Cube: AG (size(c) > 1 => AG size(c) > 1)                           // expect: holds
check nobody   : always not exists c in Cube: event bounce(c)                                   // expect: holds
check all_move : AF AG forall c in Cube: vx(c) = 1/n                                            // expect: holds
check who_next : AG (size(c[1]) < n => AX exists c in Cube: event bind(link, c))                // expect: holds
check in_order : A[ not bound(c[2], c[3]) U event bind(link, c[1], c[2]) ]                      // expect: holds
check in_time  : event bind(link, c[1], c[2]) leads_to event bind(link, c[n-1], c[n]) within 5  // expect: holds
check too_soon : event bind(link, c[1], c[2]) leads_to event bind(link, c[n-1], c[n]) within 4  // expect: violated
