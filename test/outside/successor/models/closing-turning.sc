// A ring that turns: it closes in the middle of a turn, which goes on, and loses a bond with a push that it takes up (I-37).
model closing_turning
dynamics free_body
bonds cyclic
split_step 1/4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
behaviour Hook on Cube = eps(1/8). <a, {top}>. omega(a, {top}) push(2). Hook
behaviour Eye on Cube  = <~a, {bottom}>. omega(a, {bottom}). Eye

process ring =
    p : Cube mass 1 spin (0, 1/2, 0) velocity (1/2, 0, 1/2) at translate (0, 0, 0) [Hook]
  <link, {p.right, q.left}> q : Cube mass 1 spin (0, 1/2, 0) velocity (1/2, 0, -1/2) at translate (2, 0, 0) [nil]
  <link, {q.top, r.bottom}> r : Cube mass 1 spin (0, 1/2, 0) velocity (3/2, 0, -1/2) at translate (2, 0, 2) [nil]
  <link, {r.left, s.right}> s : Cube mass 1 spin (0, 1/2, 0) velocity (3/2, 0, 1/2) at translate (0, 0, 2) [Eye]
