// Six pairs of cubes collide, all at one instant and far from each other, while a ball falls to the ground at
// another place. What is asked is about the ball or one of the pairs, up to the time 10. Whatever the others
// do, they cannot come near enough by then to influence it, and are left out, check by check (rule Slice).
// With `--no-reduce slice` they are there, and collide in one order instead of all (rule Order). With
// `--no-reduce slice,order` each of the 2^6 sets of pairs that may have collided already is a state.
model crowd

param n = 6

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

for i in 1..n {
  process p[i] = Cube mass 1 velocity (1,0,0) at translate (0,100*i,0) [nil]
  process q[i] = Cube mass 1 velocity (-1,0,0) at translate (8,100*i,0) [nil]
}
fixed   ground = Cube scaled (10,10,1) at translate (200,0,-2)
process ball   = Cube mass 2 velocity (0,0,-1) at translate (200,0,6) [nil]

check lands : possibly event bounce(ball, ground) within 10         // expect: holds
check first : always not (vz(ball) > 0 and vx(p[1]) > 0) within 10  // expect: holds
check back  : possibly vx(p[1]) < 0 and vx(q[1]) > 0 within 10      // expect: holds
check above : always z(ball) >= 0 within 10                         // expect: holds
