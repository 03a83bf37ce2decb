// A binding chain: the first cube runs into the second, they bind, the pair
// runs into the third, and so on until all n cubes are one process.
model chain

param n = 4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Free on Cube = <link, {right}>. Head + <~link, {left}>. Tail
behaviour Head on Cube = <~link, {left}>. nil
behaviour Tail on Cube = <link, {right}>. nil

process c[1] = Cube mass 1 velocity (1,0,0) at translate (3,0,0) [Free]
for i in 2..n { process c[i] = Cube mass 1 at translate (3*i,0,0) [Free] }

check whole    : eventually size(c[1]) = n            // expect: holds
check bonded   : eventually bonds(link) = n - 1       // expect: holds
check slows    : eventually vx(c[n]) = 1/n            // expect: holds
check momentum : always momentum.x = 1                // expect: holds
check heat     : always energy <= 1/2                 // expect: holds
check free     : always processes >= 2                // expect: violated
