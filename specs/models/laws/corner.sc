// Where the law Reversal fails: a collision in which two directions count, those of both slopes of a roof. A wedge comes
// down from the left and meets the ridge; another one comes back on the way that it leaves by. It does not go on by the
// way that the first one came.
model corner

shape Roof {
  vertices a (-8,-4,-4)  b (8,-4,-4)  c (8,4,-4)  d (-8,4,-4)  e (0,-4,0)  f (0,4,0)
  faces    bottom [a,d,c,b]  front [a,b,e]  back [c,d,f]  right [b,c,f,e]  left [d,a,e,f]
}
shape Wedge {
  vertices a (0,-1,0)  b (0,1,0)  c (-1,-1,8)  d (1,-1,8)  e (1,1,8)  f (-1,1,8)
  faces    top [c,d,e,f]  front [a,d,c]  back [b,f,e]  right [a,b,e,d]  left [a,c,f,b]
}

fixed   roof  = Roof
fixed   again = Roof at translate (0,100,0)
process forth = Wedge mass 1 velocity (2,0,-2)       at translate (-2,0,2)          [nil]
process back  = Wedge mass 1 velocity (2/5,0,-14/5)  at translate (-2/5,100,14/5)   [nil]

check leaves  : eventually vx(forth) = -2/5 and vz(forth) = 14/5   // expect: holds
check returns : eventually vx(back) = -2 and vz(back) = 2          // expect: violated
