// Octahedra that fly about in a room, and hit each other by edges, corners and faces askew to the axes.
model crystals

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
shape Stone {
  vertices e (1,0,0)  w (-1,0,0)  n (0,1,0)  s (0,-1,0)  u (0,0,1)  d (0,0,-1)
  faces    enu [e,n,u]  end [e,d,n]  esu [e,u,s]  esd [e,s,d]
           wnu [w,u,n]  wnd [w,n,d]  wsu [w,s,u]  wsd [w,d,s]
}

fixed wall[1] = Cube scaled (1,4,4) at translate (-5,0,0)
fixed wall[2] = Cube scaled (1,4,4) at translate (5,0,0)
fixed wall[3] = Cube scaled (4,1,4) at translate (0,-5,0)
fixed wall[4] = Cube scaled (4,1,4) at translate (0,5,0)
fixed wall[5] = Cube scaled (4,4,1) at translate (0,0,-5)
fixed wall[6] = Cube scaled (4,4,1) at translate (0,0,5)

process a = Stone mass 1 velocity (1,0,0)         at translate (-2,3/8,0)    [nil]
process b = Stone mass 2 velocity (-1,1/4,1/8)    at translate (2,0,0)         [nil]
process c = Stone mass 3 velocity (1/4,-3/4,1/2)  at translate (1/8,2,-3/2)    [nil]

check solid : always distance2(a, b) > 0
