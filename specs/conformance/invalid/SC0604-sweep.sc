// a sweep over constants of diffusion for which kicks of several lengths are chosen (a warning)
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
timestep 1 steady
param d = 1/6
process p = Cube mass 1 [nil]
fixed w = Cube absorb at translate (3,0,0)
motion p = diffuse(d)
check near : P = ? [ eventually gone(p) within 1 ]
