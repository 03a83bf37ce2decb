// A whole of two that turns: one law gives a spin, the other one draws among motions with a spin and without (I-24).
dynamics free_body
timestep 1/2
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process p = Cube mass 1 spin (0, 0, 1/4) velocity (0, -3/8, 0) [nil]
process q = Cube mass 3 spin (0, 0, 1/4) velocity (0, 1/8, 0) at translate (2, 0, 0) [nil]
process r = Cube mass 1 at translate (0, 9, 0) [nil]
bond <a, {p.right, q.left}>
motion p = (vx, vy, vz) spin (wx, wy + dt, 1/3)
motion q = choose { (vx, vy, vz), (vx, vy, vz) spin (0, wz, 0) weight 2, (0, 0, 1) spin (x/9, 0, -1) }
motion r = (0, 0, 0)
