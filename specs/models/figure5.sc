// Figure 5: the concave compound S0, a cube of side two and a parallelepiped
// of sides 4, 1 and 2, moved along the x axis until their faces f0 and f1
// touch at the origin. The paper prints velocities for the two parts that
// differ in z, against its own footnote 7 (refused/figure5-misprint.sc); both
// are (2,1,1) here, as in the tuple of section 4.1.
model figure5

shape Cube {
  vertices v0 (1,-1,1)   v1 (1,-1,-1)   v2 (1,1,-1)   v3 (1,1,1)
           v4 (-1,1,1)   v5 (-1,1,-1)   v6 (-1,-1,-1) v7 (-1,-1,1)
  faces    f0 [v0,v1,v2,v3]  f1 [v4,v5,v6,v7]  f2 [v3,v2,v5,v4]
           f3 [v1,v0,v7,v6]  f4 [v0,v3,v4,v7]  f5 [v2,v1,v6,v5]
}
shape Plank {
  vertices v0 (2,-1/2,1)   v1 (2,-1/2,-1)   v2 (2,1/2,-1)   v3 (2,1/2,1)
           v4 (-2,1/2,1)   v5 (-2,1/2,-1)   v6 (-2,-1/2,-1) v7 (-2,-1/2,1)
  faces    f0 [v0,v1,v2,v3]  f1 [v4,v5,v6,v7]  f3 [v3,v2,v5,v4]
           f2 [v1,v0,v7,v6]  f4 [v0,v3,v4,v7]  f5 [v2,v1,v6,v5]
}

compound S0 {
  part s0 : Cube  mass 3 velocity (2,1,1) at translate (-1,0,0)
  part s1 : Plank mass 3 velocity (2,1,1) at translate (2,0,0)
  glue s0.f0 ~ s1.f1
}

process S = S0 velocity (2,1,1) [nil]

check one_body : always size(S) = 2 and processes = 1           // expect: holds
check drifts   : possibly x(S) = 41/2                           // expect: holds
check together : always vx(S) = 2 and vy(S) = 1 and vz(S) = 1   // expect: holds
check momentum : always momentum.x = 12 and momentum.z = 6      // expect: holds
