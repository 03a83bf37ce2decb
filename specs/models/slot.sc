// A plate that exactly fills a slot and rattles: it bounces off the floor and
// the ceiling again and again while no time passes (Zeno). That is a run like
// any other (rule Run): what holds in all of its states holds, there is always
// a next event, and what would take time never comes.
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
check leaves  : eventually x(plate) > 20       // expect: violated
check endless : EG true                        // expect: holds
check next    : AG EX true                     // expect: holds
check again   : AG AF event bounce(plate, floor)  // expect: holds
check later   : EF[1, 1] true                  // expect: violated
check stays   : A[ y(plate) = 0 U x(plate) > 0 ]  // expect: violated
