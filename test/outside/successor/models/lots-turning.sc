// Bodies that turn and fall apart by lot; a ring of which bonds go one by one.
timestep 1
split_step 1/3
resolution 1/1024
bonds cyclic
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour Lets on Cube = omega(a, {left, right, top, bottom}) chance 1/2. Lets
process p = Cube mass 1 velocity (0, 0, 0) spin (0, 1/2, 0) at translate (0, 0, 0) [Lets]
process q = Cube mass 1 velocity (0, 0, -1) spin (0, 1/2, 0) at translate (2, 0, 0) [Lets]
process r = Cube mass 1 velocity (1, 0, -1) spin (0, 1/2, 0) at translate (2, 0, 2) [omega(a, {left, bottom}). Lets]
process s = Cube mass 1 velocity (1, 0, 0) spin (0, 1/2, 0) at translate (0, 0, 2) [Lets]
bond <a, {p.right, q.left}>
bond <a, {q.top, r.bottom}>
bond <a, {r.left, s.right}>
bond <a, {s.bottom, p.top}>
