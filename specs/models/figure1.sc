// Figure 1: two processes come near, clash on compatible surfaces, bind, and
// after some time split weakly and move away.
//
// Pieces of a split keep the motion they had (reading I-11), so on their own
// they would stay where they are. Here the laws of motion drive them apart:
// whoever is at rest is pushed, p to the left and q to the right. While they
// are bound the two pushes cancel and the dimer stays.
model figure1

timestep 1
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour OpenX  on Cube = <z, {right}>. BoundX
behaviour BoundX on Cube = omega(z, {right}). Gone
behaviour OpenY  on Cube = <~z, {left}>. BoundY
behaviour BoundY on Cube = omega(z, {left}). Gone
behaviour Gone   on Cube = nil

process p = Cube mass 3 velocity (1,0,0)  at translate (-3,0,0) [OpenX]
process q = Cube mass 3 velocity (-1,0,0) at translate (3,0,0)  [OpenY]

motion p = (if vx = 0 then -1 else vx, vy, vz)
motion q = (if vx = 0 then 1 else vx, vy, vz)

check meet    : eventually bound(p, q) within 5                 // expect: holds
check parts   : possibly (x(p) = -4 and x(q) = 4) within 20     // expect: holds
check apart   : possibly distance2(p, q) >= 100 within 20       // expect: holds
check leaves  : eventually behaviour(p) = Gone within 20        // expect: violated
check stock   : always momentum.x = 0 within 20                 // expect: holds
check stays_z : always (z(p) = 0 and y(p) = 0) within 20        // expect: holds
