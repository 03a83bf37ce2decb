// two cubes that open two faces each, for two kinds of bonds, bind on the edge that the faces share (a warning)
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process p = Cube mass 1 velocity (1,1,0) at translate (-4,-4,0) [<dock, {right}>. nil + <port, {back}>. nil]
process q = Cube mass 1 [<~dock, {left}>. nil + <~port, {front}>. nil]
check bound : eventually bound(p, q)
