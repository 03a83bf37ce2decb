// The window of window.sc, whatever the instant at which p and q come apart, which is any real one. The two verdicts
// are proofs: no grid is too coarse for them.
model moment

split_step any

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour One     on Cube = omega(hold, {right}). eps(1). <above, {top}>. nil
behaviour Other   on Cube = omega(hold, {left}). eps(2). <below, {bottom}>. nil
behaviour Falling on Cube = <~above, {bottom}>. nil
behaviour Rising  on Cube = <~below, {top}>. nil

process pair = p : Cube mass 1 at translate (-1,0,0) [One]
               <hold, {p.right, q.left}>
               q : Cube mass 1 at translate (1,0,0) [Other]
process x = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,-1) at translate (-1,0,15/4) [Falling]
process y = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,1)  at translate (1,0,-5)    [Rising]

// They part after 5/4, and no later than 3/2
check alone : possibly (bound(q, y) and not bound(p, x) and time >= 7/2) within 4  // expect: holds
check both  : possibly (bound(q, y) and bound(p, x)) within 4                      // expect: holds
// p is ready by then, if q is
check never : always not (bound(p, x) and not bound(q, y) and time > 7/2) within 4   // expect: holds
check parts : eventually not bound(p, q)                                           // expect: violated
check late  : always (event weak(hold) => AG not bound(p, q))                      // expect: holds
