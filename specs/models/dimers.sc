// n dimers at rest, each free to fall apart at any split instant, or never. The
// states are the 2^n sets of dimers that are left: a model to scale up, by
// -D n=12.
model dimers

param n = 3

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Left  on Cube = omega(bond, {right}). nil
behaviour Right on Cube = omega(bond, {left}). nil

for i in 1..n {
  process d[i] = p[i] : Cube mass 1 at translate (0, 4*i, 0) [Left] <bond, {p[i].right, q[i].left}>
                 q[i] : Cube mass 1 at translate (2, 4*i, 0) [Right]
}

check all_fall : possibly bonds(bond) = 0                         // expect: holds
check none     : eventually bonds(bond) < n                       // expect: violated
check pieces   : always processes + bonds(bond) = 2*n             // expect: holds
check at_rest  : always energy = 0                                // expect: holds
