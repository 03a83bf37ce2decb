// Two dimers born bound. For two time units nothing can happen; then the
// first dimer may release its bond (some time, perhaps never); the second must
// react as soon as its delay is over.
model dimer

timestep 1/4
split_step 1/2

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Left   on Cube = eps(2). omega(bond, {right}). Loose
behaviour Right  on Cube = eps(1). (omega(bond, {left}). Loose + eps(1/2). nil)
behaviour Loose  on Cube = nil
behaviour Fuse   on Cube = eps(3). rho({<bond, {left, right}>}). Loose

process weak   = w1 : Cube mass 1 [Left] <bond, {w1.right, w2.left}>
                 w2 : Cube mass 1 at translate (2,0,0) [Right]
process strong = s1 : Cube mass 1 at translate (0,10,0) [Fuse] <bond, {s1.right, s2.left}>
                 s2 : Cube mass 2 at translate (2,10,0) [Fuse]

check born     : always (bonds(bond) = 2 => same(w1, w2) and same(s1, s2))   // expect: holds
check reacts   : eventually not bound(s1, s2)                                // expect: holds
check by_three : eventually not bound(s1, s2) within 3                       // expect: holds
check no_soon  : always bound(s1, s2) within 2                               // expect: holds
check loosens  : possibly behaviour(w1) = Loose                              // expect: holds
check must     : eventually behaviour(w1) = Loose                            // expect: violated
check delay    : always bound(w1, w2) within 1                               // expect: holds
check waits    : possibly not offers(w1, bond)                               // expect: holds
check rest     : always energy = 0                                           // expect: holds
