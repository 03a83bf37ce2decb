// Two bodies between walls: one long round of states, of more levels than transitions are taken within one instant.
model boxes

param a = 1409
param b = 1423

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   bottom [a,b,f,e]  top  [d,h,g,c]
}

fixed   left    = Cube scaled (1,100,100) at translate (-2,0,0)
fixed   right1  = Cube scaled (1,10,10) at translate (a + 2,0,0)
fixed   right2  = Cube scaled (1,10,10) at translate (b + 2,0,50)
process one     = Cube mass 1 velocity (1,0,0) at translate (0,0,0) [nil]
process two     = Cube mass 1 velocity (1,0,0) at translate (0,0,50) [nil]

check beside : possibly x(one) = x(two) and vx(one) = 1 and vx(two) = -1 and x(one) > 90
check inside : always x(one) <= a
