// A cube slides along another: when an open face comes to touch the other's, after 3, time stops there, and they bind (I-33).
model into_place

binding contact

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

process p = Cube mass 1 [<dock, {right}>. nil]
process q = Cube mass 1 velocity (0,-1,0) at translate (2,5,0) [<~dock, {left}>. nil]
check all : always time >= 0
