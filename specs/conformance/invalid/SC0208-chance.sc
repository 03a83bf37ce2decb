// chances that are no probabilities, and a rate that is too great for its split step
param less = -1
split_step 2
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process p = Cube mass 1 [omega(dock, {right}) chance 3/2. nil + omega(dock, {right}) chance (1/2 - 1). nil]
process r = Cube mass 1 at translate (9,0,0) [omega(dock, {left}) chance less. nil + omega(dock, {left}) rate less. nil]
process s = Cube mass 1 at translate (12,0,0) [omega(dock, {left}) rate 501. nil + omega(dock, {left}) rate 500. nil]
process q = Cube mass 1 at translate (2,0,0) [omega(dock, {left}). nil]
bond <dock, {p.right, q.left}>
