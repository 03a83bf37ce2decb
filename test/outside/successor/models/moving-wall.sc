// Blocked: two balls hit a walker at once, which moves on. Each bounces by itself, by the velocity that it has relative to
// the walker.
model moving_wall

timestep 1 steady
blocked stop
collisions together

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process ball = Cube mass 1 velocity (5, 0, 0) at translate (0, 0, 0) [nil]
process other = Cube mass 1 velocity (0, -4, 0) at translate (11/2, 4, 0) [nil]
process walker = Cube mass 1 at translate (4, 0, 0) [nil]
motion walker = choose { (1, 0, 0), (0, 1, 0) }
