// Figure 7 with the plank of Figure 5 exactly where section 4.2 puts it, on
// the x axis. The line from e1 to e2 then falls 1/2 over 4: no rotation with
// rational entries turns a face of a cube along it (the length of (8,-1) is
// the square root of 65). Definition 4.4 allows any affine T2, so the face f4
// is brought there by a shear. Again exactly two bindings.
model figure7_offset

shape Cube {
  vertices v0 (1,-1,1)   v1 (1,-1,-1)   v2 (1,1,-1)   v3 (1,1,1)
           v4 (-1,1,1)   v5 (-1,1,-1)   v6 (-1,-1,-1) v7 (-1,-1,1)
  faces    f0 [v0,v1,v2,v3]  f1 [v4,v5,v6,v7]  f2 [v3,v2,v5,v4]
           f3 [v1,v0,v7,v6]  f4 [v0,v3,v4,v7]  f5 [v2,v1,v6,v5]
}

compound S0 {
  part s0 : Cube mass 3 at translate (-1,0,0)
  part s1 : Cube mass 3 at translate (2,0,0) * scale (2,1/2,1)
  glue s0.f0 ~ s1.f1
}

behaviour Open0 on S0   = <a, {s0.f2, s1.f2}>. nil
behaviour Open1 on Cube = <~a, {f3}>. nil

process P0 = S0 velocity (0,0,0) [Open0]
process s2 = Cube mass 3 velocity (0,-1,0)
             at translate (2, 23/4, 0) * matrix ((3,0,0,0), (-3/8,3,0,0), (0,0,3,0), (0,0,0,1)) [Open1]

check binds : eventually bonds(a) = 1                  // expect: holds
check when  : possibly time = 2 and bonds(a) = 1       // expect: holds
check early : possibly bonds(a) = 1 and y(s2) > 15/4   // expect: violated
