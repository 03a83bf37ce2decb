// Plates in a slot that each fills exactly: all states are of one instant, and cycles lead through all of them.
model slots

param n = 4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   bottom [a,b,f,e]  top  [d,h,g,c]
}

fixed   floor   = Cube scaled (100,1,10) at translate (0,-2,0)
fixed   ceiling = Cube scaled (100,1,10) at translate (0,2,0)
for i in 1..n { process plate[i] = Cube mass 1 velocity (0,if i = 1 then -1 else 1,0) at translate (4 * i - 10, 0, 0) [nil] }

check flat    : always y(plate[1]) = 0
