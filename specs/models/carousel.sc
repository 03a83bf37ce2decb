// Two equal balls go round a square of walls, opposite to each other: a quarter of the round each time they
// bounce, both at once. After half a round they have changed places. Who is where does not matter to what is
// asked, so that the two are told apart by their places alone (rule Symmetry): 9 states, and 17 with
// `--no-reduce symmetry`.
model carousel

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed west  = Cube scaled (1,5,1) at translate (-7,0,0)
fixed east  = Cube scaled (1,5,1) at translate (7,0,0)
fixed south = Cube scaled (5,1,1) at translate (0,-7,0)
fixed north = Cube scaled (5,1,1) at translate (0,7,0)

process ball[1] = Cube mass 1 velocity (1,-1,0) at translate (-1,-4,0) [nil]
process ball[2] = Cube mass 1 velocity (-1,1,0) at translate (1,4,0) [nil]

check calm     : always energy = 2                                                      // expect: holds
check opposite : always x(ball[1]) + x(ball[2]) = 0 and y(ball[1]) + y(ball[2]) = 0     // expect: holds
check apart    : always not exists b in ball: exists c in ball: touching(b, c)          // expect: holds
check visits   : possibly (exists b in ball: x(b) = 5) and exists b in ball: x(b) = -5  // expect: holds
