// One cube drifts past x = 0 and on for ever. What is true only between two events, and only on an open interval, tells
// this CTL from that of states alone: laws of CTL that need a next state, or a first instant, fail here (rule CtlLaws).
model between

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 velocity (1,0,0) at translate (-1,0,0) [nil]

// A[f U g] and not (E[not g U (not f and not g)] or EG not g), with f : x <= 0 and g : x > 0, which has no first instant
check until      : A[ x(p) <= 0 U x(p) > 0 ]                                                          // expect: violated
check released   : not (E[ not x(p) > 0 U (not x(p) <= 0 and not x(p) > 0) ] or EG not x(p) > 0)      // expect: holds
check closed     : A[ x(p) < 0 U x(p) >= 0 ]                                                          // expect: holds

// EF f and (f or EX EF f); AG f and (f and AX AG f): nothing is next
check sometime   : EF x(p) = 0                                                                        // expect: holds
check stepwise   : x(p) = 0 or EX EF x(p) = 0                                                         // expect: violated
check always_on  : AG x(p) < 0                                                                        // expect: violated
check by_steps   : x(p) < 0 and AX AG x(p) < 0                                                        // expect: holds
check endless    : EG true                                                                            // expect: holds
check endless_by_steps : true and EX EG true                                                          // expect: violated
