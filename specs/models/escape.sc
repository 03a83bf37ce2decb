// Two particles of a gas in a chamber, with periods that do not fit together, and a third one that has escaped from it
// and flies off for ever: no state ever comes back, and exploring has no end. What never happens is proved by an
// invariant: a set of states, given by inequalities, that no run leaves.
//
//   scc check specs/models/escape.sc
//   scc check specs/models/escape.sc --invariant -
model escape

param x in [-8, -7]

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed west = Cube at translate (-10,0,0)
fixed east = Cube at translate (0,0,0)
process p = Cube mass 1 velocity (2/3,0,0) at translate (x,0,0) [nil]
process n = Cube mass 1 velocity (-1,0,0) at translate (-3,0,0) [nil]
process q = Cube mass 1 velocity (1,0,0) at translate (5,0,0) [nil]

check apart  : always not touching(p, q) and not touching(n, q)  // expect: holds
check inside : always x(n) <= -2                                 // expect: holds
check order  : always x(p) + 2 <= x(n)                           // expect: holds
check slow   : always x(q) <= 20                                 // expect: violated
