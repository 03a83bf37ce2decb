// Figure 4(b) and the tuple of section 4.1: a cube of side two about the
// origin of body space, instanced as
//   <W0, m = 3, v = (2,1,1), omega = (0,0,0), s0, T>
// where T is the translation by (2,3,1). The names of vertices and faces fit
// every tuple that the paper prints for this cube and for the parallelepiped
// of Figure 5: f0 = [v0,v1,v2,v3], f1 = [v4,v5,v6,v7], f2 = [v3,v2,v5,v4].
model figure4

shape Cube {
  vertices v0 (1,-1,1)   v1 (1,-1,-1)   v2 (1,1,-1)   v3 (1,1,1)
           v4 (-1,1,1)   v5 (-1,1,-1)   v6 (-1,-1,-1) v7 (-1,-1,1)
  faces    f0 [v0,v1,v2,v3]   // +x
           f1 [v4,v5,v6,v7]   // -x
           f2 [v3,v2,v5,v4]   // +y
           f3 [v1,v0,v7,v6]   // -y
           f4 [v0,v3,v4,v7]   // +z
           f5 [v2,v1,v6,v5]   // -z
}

process s0 = Cube mass 3 velocity (2,1,1) spin (0,0,0) at translate (2,3,1) [nil]

check straight  : always x(s0) - 2 = 2*(y(s0) - 3) and y(s0) - 3 = z(s0) - 1  // expect: holds
check steady    : always vx(s0) = 2 and vy(s0) = 1 and vz(s0) = 1             // expect: holds
check passes    : possibly x(s0) = 12 and y(s0) = 8 and z(s0) = 6             // expect: holds
check in_time   : possibly (time = 5 and x(s0) = 12) within 6                 // expect: holds
check leaves    : eventually x(s0) > 1000                                     // expect: holds
check energetic : always energy = 9                                           // expect: holds
check stays     : always x(s0) <= 12                                          // expect: violated
