// A motor walks on a track of four sites. It binds to the site that it stands on, and lets go at some step or other; then its
// law lifts it up, forward and down onto the next one. That it may stay for ever at each of them is why it need not arrive.
model motor

timestep 1 steady
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Site on Cube = <foot, {only top}>. Taken
behaviour Taken on Cube = omega(foot, {only top}). nil
behaviour Foot on Cube = <~foot, {only bottom}>. Bound
behaviour Bound on Cube = omega(foot, {only bottom}). Foot
behaviour End  on Cube = <foot, {only top}>. nil

param n = 3
for i in 1..n { fixed site[i] = Cube at translate (4*i, 0, 0) [Site] }
fixed goal = Cube at translate (4*n + 4, 0, 0) [End]
process motor = Cube mass 1 velocity (1, 0, -1) at translate (2, 0, 4) [Foot]

// at rest: off; above: down again
motion motor = (if vx = 0 then 1 else vx, 0, if vx = 0 then 1 else if z >= 4 then -1 else vz)

check arrives  : possibly bound(motor, goal)                         // expect: holds
check may_rest : eventually bound(motor, goal)                       // expect: violated
check can      : AG EF bound(motor, goal)                            // expect: holds
check soonest  : possibly bound(motor, goal) within 5*n + 1          // expect: violated
check at_best  : possibly bound(motor, goal) within 5*n + 2          // expect: holds
check steps    : always not bound(motor, site[3]) or x(motor) = 12   // expect: holds
check forward  : always vx(motor) >= 0 and z(motor) >= 2             // expect: holds
check one_foot : always bonds(foot) <= 1                             // expect: holds
