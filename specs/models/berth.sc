// Binding without a collision (reading I-33). A boat slides along a quay, and
// is held as soon as its side comes to touch the place that is open, an edge at
// first; it collides with nothing. A lid rests on a box and sticks to it when
// the glue has set.
model berth
binding contact

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Berth on Cube = <a, {right}>. nil
behaviour Boat  on Cube = <~a, {left}>. nil
behaviour Box   on Cube = <b, {top}>. nil
behaviour Lid   on Cube = eps(2). <~b, {bottom}>. nil

fixed   quay = Cube [Berth]
process boat = Cube mass 1 velocity (0,-1,0) at translate (2,5,0) [Boat]
process box  = Cube mass 1 at translate (40,0,0) [Box]
process lid  = Cube mass 1 at translate (40,0,2) [Lid]

check held   : eventually bound(quay, boat)                      // expect: holds
check there  : always (bound(quay, boat) => y(boat) = 2)         // expect: holds
check stuck  : eventually[2, 2] bound(box, lid)                  // expect: holds
check quiet  : always not event bounce                           // expect: holds
