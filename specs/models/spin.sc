// The cube of the example below Definition 4.4, < W0, m = 3, v = (2,1,1), omega, s0, T > with T the translation by
// (2,3,1), but with an angular velocity omega other than zero: it turns as it moves. A wall is where a corner reaches
// and a face does not, so that the cube would pass it by, did it not turn.
model omega_of_definition_4_4

timestep 1/4
dynamics constant_spin

shape Cube {
  vertices v0 (-1,-1,-1)  v1 (1,-1,-1)  v2 (1,1,-1)  v3 (-1,1,-1)
           v4 (-1,-1,1)   v5 (1,-1,1)   v6 (1,1,1)   v7 (-1,1,1)
  faces    f0 [v0,v3,v2,v1]  f1 [v4,v5,v6,v7]  f2 [v0,v4,v7,v3]
           f3 [v1,v2,v6,v5]  f4 [v0,v1,v5,v4]  f5 [v3,v7,v6,v2]
}

process s0 = Cube mass 3 velocity (2,1,1) spin (1/2,-1/2,1) at translate (2,3,1) [nil]
fixed ledge = Cube scaled (1,1/2,1/2) at translate (6,5/2,3)

check moves : always (vx(s0) = 2 and vy(s0) = 1 and vz(s0) = 1 => x(s0) - 2*y(s0) = -4 and y(s0) - z(s0) = 2) // expect: holds
check meets : eventually event bounce(s0, ledge) within 2    // expect: holds
check energy: always energy = 21/2                           // expect: holds
