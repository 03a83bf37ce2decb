// A fixed slab, two cubes of one family, and a small one on top of one of them. Faces, an edge and corners are open.
model scene

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed   floor = Cube scaled (4,3,1/2) at translate (0,0,-3/2)
process p[1] = Cube mass 1 velocity (1,0,0) at translate (-2,0,0) [<a, {right}>. nil]
process p[2] = Cube mass 1 velocity (0,0,0) at translate (1,1/2,0) [<~a, {left, top}>. nil]
process key  = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,0) at translate (-2,0,3/2) [<b, {[b,f], e, g}>. nil]
