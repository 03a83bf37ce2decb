// A cube rests on a tip below the middle of its face, and is pushed below its centre: it moves off, and its face turns
// down on the tip. To first order nothing approaches there, and time cannot pass: the run ends in a dead end (rule
// DeadEnd), and is told and explained up to it. Two bodies far away have nothing to do with it.
model topple
dynamics constant_spin

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
process p     = Cube mass 1 [nil]
process push  = Cube mass 1 velocity (1, 0, 0) at translate (-4, 0, -1) [nil]
process far   = Cube mass 1 velocity (1, 0, 0) at translate (-4, 0, 40) [nil]
process away  = Cube mass 1 at translate (-3/2, 0, 40) [nil]

check pushed : possibly vx(p) > 0                                 // expect: holds
check falls  : AF z(p) < 0                                        // expect: violated
check stands : EG z(p) = 0                                        // expect: holds
check parts  : EF x(away) > 1                                     // expect: violated
