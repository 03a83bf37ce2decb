// A single body drifts. Its run has no event at all, yet it leaves x <= 3 behind
// at time 9: a property is judged at all instants, also at those between events.
model drift

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 velocity (1/3,0,0) [nil]

check near    : always x(p) <= 3             // expect: violated
check near_in : always x(p) <= 3 within 9    // expect: holds
check near_at : always x(p) < 3 within 9     // expect: violated
check passes  : possibly x(p) = 22/7         // expect: holds
check ahead   : always x(p) >= 0             // expect: holds
check back    : possibly x(p) < 0            // expect: violated
check gone    : eventually x(p) > 100        // expect: holds
check quiet   : always quiescent             // expect: holds
