// Two ions in fields: the force on the first is as great as its distance from the middle, in x and in y, so that it goes round
// and comes back after six steps; the second is driven to and fro by a field that turns its sign at the middle, and hits a wall. Steps keep
// their beat, so that all of it comes back, however long they fly.
model field

timestep 1 steady

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process ion  = Cube mass 1 velocity (0, 2, 0) at translate (8, 0, 0) [nil]
process slow = Cube mass 2 at translate (0, 3, 40) [nil]
fixed   wall = Cube at translate (0, -5/2, 40)

motion ion  = (vx - x*dt, vy - y*dt, 0)
motion slow = (0, if y > 0 then vy - dt else vy + dt, 0)

check returns : AG AF[<= 6] (x(ion) = 8 and y(ion) = 0)          // expect: holds
check near    : always x(ion) <= 8 and x(ion) >= -8              // expect: holds
check swings  : AG EF y(slow) > 2 and AG EF y(slow) < 0          // expect: holds
check bounded : always y(slow) <= 3                              // expect: holds
check hits    : AG AF event bounce(slow, wall)                   // expect: holds
check constant : always speed2(ion) <= 64                        // expect: violated
