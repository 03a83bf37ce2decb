// Of three bonds in a row the first and the last react, each by itself: they do not hang together (I-7).
model two_reactions

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 at translate (0,0,0) [rho({<a, {right}>}). nil]
process q = Cube mass 1 at translate (2,0,0) [rho({<a, {left}>}). nil]
process r = Cube mass 1 at translate (4,0,0) [rho({<c, {right}>}). nil]
process s = Cube mass 1 at translate (6,0,0) [rho({<c, {left}>}). nil]
bond <a, {p.right, q.left}>
bond <b, {q.right, r.left}>
bond <c, {r.right, s.left}>
check all : always time >= 0
