// Figure 7: a compound S0 (cube s0 and plank s1, as in Figure 5) with a
// channel on the faces s0.f2 and s1.f3 meets a rotated cube s2 with the
// co-channel on its face f4. The plane of f4 rests on two edges at once,
// e1 = s0.[v2,v3] and e2 = s1.[v2,v3], and on nothing else, so there are
// exactly two bindings, <a,{s0.e1, s2.f4}> and <a,{s1.e2, s2.f4}>.
//
// Two liberties, since the paper prints no numbers here. The plank is 2/5
// lower than the cube, so that the line from e1 to e2 falls 9/10 over 4 and
// f4 can lie on it by a rotation with rational entries: cosine 40/41, sine
// -9/41. And the cube s2 has sides of 6: e1 and e2 are 41/10 apart, more
// than the sides of 2 of the paper's cube can span.
model figure7

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
shape Big {                            // f4 looks down
  vertices v0 (3,-3,3)   v1 (3,-3,-3)   v2 (3,3,-3)   v3 (3,3,3)
           v4 (-3,3,3)   v5 (-3,3,-3)   v6 (-3,-3,-3) v7 (-3,-3,3)
  faces    f0 [v0,v1,v2,v3]  f1 [v4,v5,v6,v7]  f2 [v3,v2,v5,v4]
           f4 [v1,v0,v7,v6]  f3 [v0,v3,v4,v7]  f5 [v2,v1,v6,v5]
}

compound S0 {
  part s0 : Cube  mass 3 at translate (-1,0,0)
  part s1 : Plank mass 3 at translate (2,-2/5,0)
  glue s0.f0 ~ s1.f1
}

behaviour Open0 on S0  = <a, {s0.f2, s1.f3}>. B0
behaviour B0    on S0  = nil
behaviour Open1 on Big = <~a, {f4}>. B1
behaviour B1    on Big = nil

process P0 = S0 velocity (0,0,0) [Open0]
process s2 = Big mass 3 velocity (0,-1,0)
             at translate (109/41, 4491/820, 0) * rotate quaternion (9,0,0,-1) [Open1]

check binds    : eventually bonds(a) = 1                                  // expect: holds
check one_only : always bonds(a) <= 1                                     // expect: holds
check both     : always (behaviour(P0) = B0 => behaviour(s2) = B1)        // expect: holds
check moves    : possibly vy(s2) = -1/3 and vy(P0) = -1/3                 // expect: holds
check when     : possibly time = 2 and bonds(a) = 1                       // expect: holds
check not_yet  : always (bonds(a) = 0 => y(s2) >= 2851/820)               // expect: holds
check momentum : always momentum.y = -3                                   // expect: holds
