// A plank tumbles through the air and hits a wall with one of its edges.
//
// It turns about its centre of mass as it moves, so that the long side reaches ahead of the centre by more or
// less, and the wall is met by an edge: off the centre, which is why the bounce changes the spin as well as the
// velocity. Contacts are known within a resolution, and nothing ever interpenetrates.
model plank

timestep 1/2
dynamics constant_spin

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
shape Plank = Cube scaled (1/4, 2, 1)

process plank = Plank mass 3 velocity (1,0,0) spin (0,0,1/2) at translate (-5,0,0) [nil]
fixed   wall  = Cube scaled (1,8,8) at translate (1,0,0)

let hit = event bounce(plank, wall)

check hits      : eventually hit within 5                      // expect: holds
check off_centre: always x(plank) <= -1/4                      // expect: holds
check touches   : AG (hit => touching(plank, wall))            // expect: holds
check turns     : AG (hit => wz(plank) != 1/2 and vx(plank) < 1) // expect: holds
check energy    : always energy = 257/128                   // expect: holds
check leaves    : possibly vx(plank) < 0                       // expect: holds
check in_plane  : always vz(plank) = 0 and wx(plank) = 0 and wy(plank) = 0 // expect: holds
