// Where Confluence fails with steps of single processes (reading I-31): two
// bounces share no process, but what they leave is in contact. A guide takes
// from q what is sideways of its velocity, whenever it is asked. If p hits q
// first, q slides along r, collides with nobody and is asked at once; then s
// hits r, and r hits q, which has been asked at this instant and goes off. If
// s hits r first, q is asked when r has hit it, and goes straight on.
model early
timestep 1 local

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 velocity (0,1,0)  at translate (-1,-2,0) [nil]
process q = Cube mass 1 at translate (-1,0,0) [nil]
process r = Cube mass 1 at translate (1,0,0)  [nil]
process s = Cube mass 1 velocity (-1,0,0) at translate (3,0,0) [nil]

motion q = (0, vy, vz)

check goes_off : possibly y(q) = 1 and x(q) = -2          // expect: holds
check straight : possibly y(q) = 1 and x(q) = -1          // expect: holds
