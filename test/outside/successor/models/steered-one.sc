// As steered-both, but no law moves the second body: the whole still goes on in the step that has just begun (I-31).
timestep 1 local
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour K on Cube = <a,{right}>.omega(a,{right}).nil
behaviour L on Cube = <~a,{left}>.omega(a,{left}).nil
process p = Cube mass 1 [K]
process q = Cube mass 1 at translate (2,0,0) [L]
process r = Cube mass 1 velocity (-1,0,0) at translate (5,0,0) [<~a,{left}>.nil]
motion p = (vx + 1, vy, vz)
motion q = inertial
