// A crowd of a hundred cubes in a row. The first comes and pushes the second, that one the third, and so on: what it had goes
// down the row, and is with the last one in the end. Each check of one body leaves out those that come too late (rule Slice).
model cradle

param n = 100

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process c[1] = Cube mass 1 velocity (1,0,0) [nil]
for i in 2..n { process c[i] = Cube mass 1 at translate (3*i - 2, 0, 0) [nil] }

check last     : eventually vx(c[n]) = 1                                    // expect: holds
check when     : possibly event bounce(c[n-1], c[n]) within n - 2           // expect: violated
check in_time  : possibly event bounce(c[n-1], c[n]) within n + 1           // expect: holds
check momentum : always momentum.x = 1 and energy = 1/2                     // expect: holds
check once     : AG (event bounce(c[1]) => AG not (vx(c[1]) > 0))           // expect: holds
check middle   : always vx(c[n/2]) = 0                                      // expect: violated
