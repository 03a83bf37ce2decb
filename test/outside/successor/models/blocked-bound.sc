// Blocked: a walker runs into a wall and, at the same instant, into what it fits: the bond comes first. Another walker
// stops at a wall, and so does the one that follows it. Two that meet edge to edge stop, though neither runs into the
// other at rest.
model blocked_bound

timestep 1
blocked stop

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed wall = Cube at translate (2, 0, 0) [nil]
process walker = Cube mass 1 at translate (0, 0, 0) [<dock, {back}>. nil]
process pocket = Cube mass 2 at translate (0, 2, 0) [<~dock, {front}>. nil]
process first = Cube mass 1 at translate (0, -2, 10) [nil]
process second = Cube mass 1 at translate (-2, -2, 10) [nil]
fixed corner = Cube at translate (2, -2, 10) [nil]
process below = Cube mass 1 at translate (20, 0, 0) [nil]
process above = Cube mass 1 at translate (22, 2, 0) [nil]

motion walker = choose { (1, 1, 0), (1, 0, 0) }
motion first = choose { (1, 0, 0), (0, 1, 0) }
motion second = choose { (1, 0, 0) }
motion below = choose { (1, 0, 0) }
motion above = choose { (0, -1, 0) }
