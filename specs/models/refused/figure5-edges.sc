// Figure 5 glued along the edges that the paper names as a wrong choice (its e0
// and e1). With the offsets along the x axis they are 1/2 apart: they do not touch.
// refused: SC0401
model figure5_edges

shape Cube {
  vertices v0 (1,-1,1)   v1 (1,-1,-1)   v2 (1,1,-1)   v3 (1,1,1)
           v4 (-1,1,1)   v5 (-1,1,-1)   v6 (-1,-1,-1) v7 (-1,-1,1)
  faces    f0 [v0,v1,v2,v3]  f1 [v4,v5,v6,v7]  f2 [v3,v2,v5,v4]
           f3 [v1,v0,v7,v6]  f4 [v0,v3,v4,v7]  f5 [v2,v1,v6,v5]
}
shape Plank = Cube scaled (2, 1/2, 1)

compound S0 {
  part s0 : Cube  mass 3 velocity (2,1,1) at translate (-1,0,0)
  part s1 : Plank mass 3 velocity (2,1,1) at translate (2,0,0)
  glue s0.[v0,v1] ~ s1.[v6,v7]
}

process S = S0 [nil]
