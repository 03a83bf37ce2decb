// parameters with ranges where values must be known, and a product of two
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
param x in [0, 6]
param y in (1, 2)
process p = Cube mass x at translate (x*y, 0, 0) [nil]
process q = Cube mass 1 velocity (y, 0, 0) at translate (x, 20, 2*y) [eps(x/y). nil]
