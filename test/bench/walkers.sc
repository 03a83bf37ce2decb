// n cubes, each between two walls of its own, that draw at each step whether to walk to the left or to the right; and n
// more beside them at rest. The states are those of the walkers, each between 1 and 5, while the velocities are drawn.
model walkers

param n = 4
timestep 1 steady
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

for i in 1..n {
  process w[i] = Cube mass 1 at translate (2, 4*i, 0) [nil]
  process r[i] = Cube mass 1 at translate (100, 4*i, 0) [nil]
  motion w[i] = choose { (if x = 1 then 1 else -1, 0, 0), (if x = 5 then -1 else 1, 0, 0) }
}
