// Lots that surely go: two bonds of one process that share no leaf, with pushes, and one of another process, all at once.
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process k = Cube mass 1 at translate (0,40,0) [omega(b, {right}) push(1) chance 1. nil]
process l = Cube mass 2 at translate (2,40,0) [omega(b, {left}). nil]
process m = Cube mass 1 at translate (4,40,0) [omega(b, {right}) push(1/2). nil]
process n = Cube mass 1 at translate (6,40,0) [omega(b, {left}) push(2) chance 1. nil]
bond <b, {k.right, l.left}>
bond <d, {l.right, m.left}>
bond <b, {m.right, n.left}>

process p = Cube mass 1 at translate (-20,0,0) [omega(a, {right}) chance 1. nil]
process q = Cube mass 1 at translate (-18,0,0) [omega(a, {left}). nil]
bond <a, {p.right, q.left}>
