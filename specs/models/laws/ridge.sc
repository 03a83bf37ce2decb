// Where the law Cutting fails: a seam that contains an edge. Two wedges fall alike on two roofs alike, one of which
// is cut in two through its ridge. The wedge that meets the whole is thrown straight back, by the directions of both
// slopes. On the other roof it goes into the right half alone, since it moves to the right: only the direction of that
// half counts.
model ridge

shape Roof {
  vertices a (-8,-4,-4)  b (8,-4,-4)  c (8,4,-4)  d (-8,4,-4)  e (0,-4,0)  f (0,4,0)
  faces    bottom [a,d,c,b]  front [a,b,e]  back [c,d,f]  right [b,c,f,e]  left [d,a,e,f]
}
shape Wedge {
  vertices a (0,-1,0)  b (0,1,0)  c (-1,-1,8)  d (1,-1,8)  e (1,1,8)  f (-1,1,8)
  faces    top [c,d,e,f]  front [a,d,c]  back [b,f,e]  right [a,b,e,d]  left [a,c,f,b]
}
shape RightHalf {
  vertices o (0,-4,-4)  b (8,-4,-4)  c (8,4,-4)  p (0,4,-4)  e (0,-4,0)  f (0,4,0)
  faces    bottom [o,p,c,b]  seam [o,e,f,p]  front [o,b,e]  back [c,p,f]  right [b,c,f,e]
}
shape LeftHalf {
  vertices a (-8,-4,-4)  o (0,-4,-4)  p (0,4,-4)  d (-8,4,-4)  e (0,-4,0)  f (0,4,0)
  faces    bottom [a,d,p,o]  seam [p,f,e,o]  front [a,o,e]  back [p,d,f]  left [d,a,e,f]
}
compound Halves {
  part left  : LeftHalf mass 1
  part right : RightHalf mass 1
  glue left.seam ~ right.seam
}

fixed   whole = Roof
fixed   cut   = Halves at translate (0,100,0)
process one   = Wedge mass 1 velocity (1,0,-5) at translate (-1,0,5)   [nil]
process other = Wedge mass 1 velocity (1,0,-5) at translate (-1,100,5) [nil]

check back  : eventually vx(one) = -1 and vz(one) = 5                     // expect: holds
check alike : always (time > 1 => vx(one) = vx(other))                    // expect: violated
check away  : eventually vx(other) = 23/5 and vz(other) = 11/5            // expect: holds
