// bonds that may be released at any time, where states are listed one by one
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
split_step any
behaviour K on Cube = <a, {left, right}>. omega(a, {left, right}). nil
behaviour L on Cube = <~a, {left, right}>. omega(a, {left, right}). nil
process p = Cube mass 1 velocity (1,0,0) [K]
process q = Cube mass 1 at translate (7,0,0) [L]
