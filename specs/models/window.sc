// A window in time that a grid of split instants may miss. p and q are bound,
// and may come apart at any time: here at the multiples of `split_step` only
// (reading I-9). Afterwards p needs 1 until it can catch x, which arrives at
// 9/4, and q needs 2 until it can catch y, which arrives at 7/2. So q catches
// y without p having caught x iff they part later than 5/4 and no later than
// 3/2: at none of 0, 1, 2, ..., but at 3/2 if `split_step` is 1/4. That is
// why the verdict says at which split step it holds.
//
//   scc check specs/models/window.sc -D grid=1/4
model window

param grid = 1
split_step grid

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour One     on Cube = omega(hold, {right}). eps(1). <above, {top}>. nil
behaviour Other   on Cube = omega(hold, {left}). eps(2). <below, {bottom}>. nil
behaviour Falling on Cube = <~above, {bottom}>. nil
behaviour Rising  on Cube = <~below, {top}>. nil

process pair = p : Cube mass 1 at translate (-1,0,0) [One]
               <hold, {p.right, q.left}>
               q : Cube mass 1 at translate (1,0,0) [Other]
process x = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,-1) at translate (-1,0,15/4) [Falling]
process y = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,1)  at translate (1,0,-5)    [Rising]

check both : always (bound(q, y) => bound(p, x)) within 4  // expect: holds
check some : possibly bound(q, y) within 4                 // expect: holds
