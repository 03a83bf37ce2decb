// A weak split may be put off for ever. Two cubes run into each other, bind, and may come apart at any whole
// time from then on; what is released stays where it is, and does not bind again. Without fairness nothing
// makes them part: the run in which they never do is a run.
model latch

split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Open on Cube = <dock, {right}>. Held
behaviour Shut on Cube = <~dock, {left}>. Held
behaviour Held on Cube = omega(dock, {left, right}). nil

process p = Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [Open]
process q = Cube mass 1 velocity (-1,0,0) at translate (3,0,0) [Shut]

let apart = not bound(p, q)

check docks    : AF event bind(dock, p, q)                     // expect: holds
check may_part : AG EF (apart and AG apart)                    // expect: holds
check parts    : event bind(dock) leads_to event weak(dock)    // expect: violated
check for_ever : EF EG not apart                               // expect: holds
check settles  : AF (AG apart or AG not apart)                 // expect: violated
check late     : EF[12, 13] event weak(dock)                   // expect: holds
check on_grid  : AG (event weak(dock) => EG apart)             // expect: holds
check next     : AG (event bind(dock) => EX event weak(dock))  // expect: holds
check choice   : AG (event bind(dock) => AX event weak(dock))  // expect: holds
