// A key flies along its axis into a lock, and both spin about it, against each other. Face comes to face and they bind; they
// spin on together, by conservation of angular momentum, and what differs of their spins is lost as energy. A second key
// comes with its side, and is thrown back.
model lock

dynamics free_body
timestep 1/2

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Lock on Cube = <fit, {only left}>. nil
behaviour Key  on Cube = <~fit, {only right}>. nil

process key  = Cube mass 1 velocity (1,0,0) spin (1/4,0,0) at translate (-4,0,0) [Key]
process lock = Cube mass 3 spin (-1/8,0,0) at translate (0,0,0) [Lock]

check fits     : eventually bound(key, lock) within 3                   // expect: holds
check angular  : always angular.x = -1/12 and angular.y = 0             // expect: holds
check together : AG (bound(key, lock) => wx(key) = wx(lock))            // expect: holds
check slower   : AG (bound(key, lock) => vx(key) = 1/4)                 // expect: holds
check energy   : AG (bound(key, lock) => energy < 1/2)                  // expect: holds
check turns    : possibly bound(key, lock) and wx(key) > 0              // expect: violated
