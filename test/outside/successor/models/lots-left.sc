// Both bonds of the one in the middle are to be released, which lets go of one of them and then no more. Whose chance is 0 keeps its bond.
timestep 1
split_step 1/2
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour Once on Cube = omega(a, {left, right}) chance 1. nil
process p = Cube mass 1 at translate (0, 0, 0) [Once]
process q = Cube mass 1 at translate (2, 0, 0) [Once]
process r = Cube mass 1 at translate (4, 0, 0) [omega(a, {left}). nil]
process s = Cube mass 1 at translate (6, 0, 0) [omega(b, {left}) chance 0. nil + omega(a, {right}) rate 0. nil]
process t = Cube mass 1 at translate (8, 0, 0) [omega(a, {left}). nil + omega(a, {left}) chance 1/2. nil]
bond <a, {p.right, q.left}>
bond <a, {q.right, r.left}>
bond <a, {s.right, t.left}>
