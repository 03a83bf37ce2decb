// chain-n: n+1 unit cubes at rest in a row, held by n bonds, each of which may be
// released at any split instant, or never. Nothing moves and nothing binds again,
// so the states are the 2^n sets of bonds that are left. The split clocks are back
// at 0 at every instant at which anything may happen, so that they tell no two states
// apart; a state has one transition for each bond that is left, and one for time: to
// itself while a bond is left, and n * 2^(n-1) + 2^n - 1 transitions in all.
model bonds

param n = 3
timestep 1
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
shape Unit = Cube scaled (1/2, 1/2, 1/2)

behaviour Link on Unit = omega(link, {left, right}). Link

for i in 0..n { process c[i] = Unit mass 1 at translate (i, 0, 0) [Link] }
for i in 1..n { bond <link, {c[i-1].right, c[i].left}> }

check conserved : always bonds(link) + processes = n + 1      // expect: holds
