// Planks that tumble in a box. Numbers would grow with every bounce and every step: orientations, velocities and
// spins are rounded, at the start of each turn, and the report of a run says what that adds up to:
//
//     scc trace specs/models/tumble.sc --states ends --steps 10000
model tumble

timestep 1/4
dynamics constant_spin
round orientation 2^-30
round velocity 2^-30

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
shape Plank = Cube scaled (1, 1/2, 1/4)

for i in 1..2, j in 1..2 {
  process p[i,j] = Plank mass (i + j) velocity (i - j, 1, i) spin (1/2, j - i, 1/3) at translate (4*i - 6, 4*j - 6, 0) [nil]
}
fixed wall_a = Cube scaled (1,6,6) at translate (-6,0,0)
fixed wall_b = Cube scaled (1,6,6) at translate (6,0,0)
fixed wall_c = Cube scaled (5,1,6) at translate (0,-6,0)
fixed wall_d = Cube scaled (5,1,6) at translate (0,6,0)
fixed wall_e = Cube scaled (5,5,1) at translate (0,0,-6)
fixed wall_f = Cube scaled (5,5,1) at translate (0,0,6)

check inside : always x(p[1,1]) < 5 and x(p[1,1]) > -5 within 4   // expect: holds
check spread : always distance2(p[1,1], p[2,2]) < 300 within 4       // expect: holds
