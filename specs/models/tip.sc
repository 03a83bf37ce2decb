// A cube turns on a tip below the middle of its face. To first order nothing approaches, and yet the two would
// interpenetrate at once: the calculus has no answer, and the model is given up there (rule Persistent). The state is
// a dead end (rule DeadEnd): the run that comes to it ends, and verdicts are about what was left.
model tip

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
shape Spike {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)  tip (0,0,3)
  faces    bottom [a,d,c,b]  front [a,b,tip]  right [b,c,tip]  back [c,d,tip]  left [d,a,tip]
}

fixed   spike = Spike at translate (0, 0, -4)
process p     = Cube mass 1 spin (1, 0, 0) [nil]

check any_next   : AX false                                       // expect: holds
check some_next  : EX true                                        // expect: violated
check goes_on    : AG EX true                                     // expect: violated
check what_was   : AG wx(p) = 1                                   // expect: holds
check to_come    : AF z(p) > 0                                    // expect: violated
check never      : possibly z(p) > 0                              // expect: violated
check stays      : EG z(p) = 0                                    // expect: holds
check until_now  : A[ z(p) = 0 U z(p) = 0 ]                       // expect: holds
check until_then : E[ z(p) = 0 U z(p) > 0 ]                       // expect: violated
check in_time    : EF[0, 1] z(p) > 0                              // expect: violated
check at_time    : EF[1, 1] true                                  // expect: violated
check after_time : AG[1, 2] false                                 // expect: holds
