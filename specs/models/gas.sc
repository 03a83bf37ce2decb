// A gas of n*n*n cubes: -D n=10 makes a thousand. The velocities differ from
// cube to cube, in no symmetric way, so that collisions come one at a time.
model gas

param n = 2

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

for i in 1..n, j in 1..n, k in 1..n {
  process g[i,j,k] = Cube mass 1
    velocity ((2*j*k - 3*i*i) / (8*n), (3*i*k - 2*j*j) / (8*n), (5*i*j - 4*k*k) / (8*n))
    at translate (4*i, 4*j, 4*k) [nil]
}

check energy : always energy >= 0 within 4                                  // expect: holds
check drift  : always momentum.x = -n*n*n*(n+1)/16 within 4                 // expect: holds
