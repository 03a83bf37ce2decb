// Laws are asked when the lots of an instant are drawn: by pieces, of which one leaves a fixed body. Velocities are rounded.
timestep 1/2
split_step 1/2
round velocity 1/4
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour Lets on Cube = omega(a, {left, right}) push(1/3) chance 1/2. Lets
fixed wall = Cube at translate (0, 0, 0) [omega(a, {right}). nil]
process p = Cube mass 1 at translate (2, 0, 0) [Lets]
process q = Cube mass 2 at translate (4, 0, 0) [eps(1/2). omega(a, {left}). nil]
process r = Cube mass 1 velocity (0, 2, 0) at translate (12, 0, 0) [Lets]
process s = Cube mass 2 velocity (0, 2, 0) at translate (14, 0, 0) [Lets + omega(a, {left}). nil]
bond <a, {wall.right, p.left}>
bond <a, {p.right, q.left}>
bond <a, {r.right, s.left}>
motion (vx + dt + 1/3, vy - dt/3, vz)
motion r = choose { (vx, vy, 1) weight 2, (vx, vy, -1) }
