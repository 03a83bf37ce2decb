// A chain whose bonds are let go by lot: both ends with several ways, bonds that share a leaf, a free end with two ways, equal summands,
// a summand that is left for the next bond, and one that is not. An event
// between two split instants changes nothing.
split_step 1/2
timestep 1
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour Stays on Cube = omega(a, {left, right}) chance 1/2. Stays + omega(a, {right}) chance 1/3. nil
  + omega(a, {right}) chance 1/3. nil + omega(b, {left, right}) chance 0. nil
behaviour Goes on Cube = omega(a, {left, right}) push(1) chance 3/4. Again
behaviour Again on Cube = omega(a, {left, right}) chance 1/4. nil
behaviour Free on Cube = omega(a, {left, right}). Goes + omega(a, {left, right}) push(1/2). nil + omega(b, {right}). nil
process z = Cube mass 1 at translate (0, 0, 0) [Free]
process c = Cube mass 1 at translate (2, 0, 0) [Stays]
process q = Cube mass 2 at translate (4, 0, 0) [Goes]
process m = Cube mass 1 at translate (6, 0, 0) [Free]
process a = Cube mass 1 at translate (8, 0, 0) [Again]
process k = Cube mass 1 velocity (-1, 0, 0) at translate (-12, 0, 0) [omega(a, {left, right}) chance 1/2. nil + omega(b, {left}) rate 2. nil]
process e = Cube mass 1 velocity (-1, 0, 0) at translate (-14, 0, 0) [omega(b, {right}) rate 1/3. nil]
process u = Cube mass 1 at translate (0, 20, 0) [eps(1/3). nil]
bond <a, {z.right, c.left}>
bond <a, {c.right, q.left}>
bond <a, {q.right, m.left}>
bond <a, {m.right, a.left}>
bond <b, {e.right, k.left}>
