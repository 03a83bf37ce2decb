// Kicks of the orientation: about one axis, by two turns in a step, and about two axes; and one law without a spin.
dynamics constant_spin
timestep 1/2
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process p = Cube mass 1 [nil]
process q = Cube mass 2 spin (0, 1/3, 0) at translate (9, 0, 0) [nil]
process r = Cube mass 2 spin (0, 1/3, 0) at translate (18, 0, 0) [nil]
motion p = diffuse(0, turning = (12/17, 0, 0))
motion q = diffuse((1/8, 0, 0), (0, 0, wy), turning = (1/9, 0, 1/50))
motion r = choose { (0, 0, 0) weight 2, (0, 1/9, 0) spin (1/5, 0, 0) }
