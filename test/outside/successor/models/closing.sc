// Rings that close and open (I-37): by faces and by an edge, two at once, with the clock of a weak split, and of reactions that
// take all bonds of a ring or one of them, with pushes that a ring takes up.
model closing
bonds cyclic
split_step 1/2

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
behaviour Hook on Cube = <a, {top, right}>. Held
behaviour Held on Cube = omega(a, {top}) push(2). eps(1/2). Hook + <a, {top, right}>. nil
behaviour Eye on Cube  = <~a, {bottom, left}>. (omega(a, {bottom}). Eye + rho({<a, {bottom}>, <link, {right}>}) push(1). nil)
behaviour Turn on Cube = rho({<link, {left}>}) push(1/3). nil + eps(1). rho({<link, {bottom}>}). nil
behaviour Foot on Cube = rho({<link, {right}>}). nil + eps(1). rho({<link, {top}>}) push(1). Eye

process p = Cube mass 1 velocity (1, 0, 0) at translate (0, 0, 0) [Hook]
process q = Cube mass 2 velocity (1, 0, 0) at translate (2, 0, 0) [eps(1). Foot]
process r = Cube mass 1 velocity (1, 0, 0) at translate (2, 0, 2) [eps(1/2). Turn + Eye]
process s = Cube mass 3 velocity (1, 0, 0) at translate (0, 0, 2) [Eye]
process t = Cube mass 1 velocity (-1, 0, 0) at translate (6, 0, 1) [<~a, {left}>. nil]
bond <link, {p.right, q.left}>
bond <link, {q.top, r.bottom}>
bond <link, {r.left, s.right}>
