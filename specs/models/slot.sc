// A plate that exactly fills a slot and rattles: it bounces off the floor and
// the ceiling again and again while no time passes (Zeno). What holds at all
// of these instants is proved; what is still to come stays undecided, since
// time never goes on.
model slot

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}

fixed   floor   = Cube scaled (10,1,10) at translate (0,-2,0)
fixed   ceiling = Cube scaled (10,1,10) at translate (0,2,0)
process plate   = Cube mass 1 velocity (1,-1,0) [nil]

check rattles : possibly vy(plate) = 1         // expect: holds
check flat    : always y(plate) = 0            // expect: holds
check slides  : possibly x(plate) > 0          // expect: violated
check leaves  : eventually x(plate) > 20       // expect: undecided
