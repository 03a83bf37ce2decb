// Lots that go, in several processes at once, some of whose free ends choose; and a row of which one bond after the other goes,
// as its middle offers again what it has offered.
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour One   on Cube = eps(1/2). nil
behaviour Two   on Cube = nil
behaviour Three on Cube = nil
behaviour Again on Cube = omega(c, {left, right}) chance 1. Again

process p = Cube mass 1 at translate (0,0,0) [omega(a, {right}) chance 1. nil]
process q = Cube mass 1 at translate (2,0,0) [omega(a, {left}). One + omega(a, {left, top}). One + omega(a, {left}). Two]
process u = Cube mass 1 at translate (-20,5,0) [omega(a, {left}) push(1). One + omega(a, {left}). One + omega(a, {left}). Three]
process v = Cube mass 1 at translate (-22,5,0) [omega(a, {right}) chance 1. nil]
process w = Cube mass 1 at translate (0,20,0) [omega(a, {right}) chance 1/2. nil]
process x = Cube mass 1 at translate (2,20,0) [omega(a, {left}). One + omega(a, {left}). Two]
bond <a, {p.right, q.left}>
bond <a, {v.right, u.left}>
bond <a, {w.right, x.left}>

process r = Cube mass 1 at translate (0,60,0) [omega(c, {right}). nil]
process s = Cube mass 1 at translate (2,60,0) [Again]
process t = Cube mass 1 at translate (4,60,0) [omega(c, {left}). One + omega(c, {left}). Two]
bond <c, {r.right, s.left}>
bond <c, {s.right, t.left}>
