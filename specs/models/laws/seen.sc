// Where laws of motion break symmetries: what a law sees, the motion depends on. Each pair of bodies moves alike until
// the first update; the second of each pair is the first one elsewhere, turned by a quarter about the z axis, faster by
// (1,0,0), of twice the mass, or with times and velocities in other units.
model seen

timestep 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

process here   = Cube mass 1 at translate (1,0,0)   [nil]
process there  = Cube mass 1 at translate (2,10,0)  [nil]
process along  = Cube mass 1 velocity (1,0,0) at translate (0,20,0) [nil]
process across = Cube mass 1 velocity (0,1,0) at translate (0,30,0) [nil]
process slow   = Cube mass 1 velocity (0,0,1) at translate (0,40,0) [nil]
process fast   = Cube mass 1 velocity (1,0,1) at translate (0,50,0) [nil]
process light  = Cube mass 1 at translate (0,60,0) [nil]
process heavy  = Cube mass 2 at translate (0,70,0) [nil]

motion here   = (vx, vy, vz + x)
motion there  = (vx, vy, vz + x)
motion along  = (vx, vy, vz + vx)
motion across = (vx, vy, vz + vx)
motion slow   = (9/10 * vx, vy, vz)
motion fast   = (9/10 * vx, vy, vz)
motion light  = (vx, vy, vz + mass)
motion heavy  = (vx, vy, vz + mass)

check displaced : always vz(here) = vz(there) within 2        // expect: violated
check rotated   : always vz(along) = vz(across) within 2      // expect: violated
check boosted   : always vx(fast) - vx(slow) = 1 within 2     // expect: violated
check heavier   : always vz(light) = vz(heavy) within 2       // expect: violated
