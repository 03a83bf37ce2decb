// Rounded to quarters the velocity of q would take it into p, along whose slanted face it slides away: it waits, and nothing is rounded.
model waits

round velocity 1/4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 at rotate quaternion (2,0,0,1) [eps(1). nil]
process q = Cube mass 1 velocity (1/5,-7/50,0) at translate (6/5,8/5,0) * rotate quaternion (2,0,0,1) [nil]
check all : always time >= 0
