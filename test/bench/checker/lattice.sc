// lattice-n: n identical dimers at rest, far apart, each free to fall apart at any
// split instant, or never. All of it has 2^n states; what the property says of one
// dimer is decided by the 2 of that dimer.
model lattice

param n = 3
timestep 1
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Left  on Cube = omega(link, {right}). nil
behaviour Right on Cube = omega(link, {left}). nil

for i in 1..n {
  process d[i] = p[i] : Cube mass 1 at translate (0, 100*i, 0) [Left] <link, {p[i].right, q[i].left}>
                 q[i] : Cube mass 1 at translate (2, 100*i, 0) [Right]
}

check near : always bound(p[1], q[1]) or distance2(p[1], q[1]) = 4       // expect: holds
