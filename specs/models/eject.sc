// An enzyme holds what it binds for a while and throws it off: a strong split with a push (reading I-36). The impulse of 2
// gives a cube of mass 1 the velocity 2; the enzyme is fixed, and takes nothing. The cube comes back from the wall, is bound
// again, and so on: five states in all, and nothing has to be steered.
model eject

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Enzyme  = <~site, {right}>. eps(1). rho({<site, {right}>}). Enzyme
behaviour Free    = <site, {left}>. eps(1). rho({<site, {left}>}) push(2). Free

fixed   enzyme = Cube at translate (0, 0, 0) [Enzyme]
process ligand = Cube mass 1 velocity (-1, 0, 0) at translate (4, 0, 0) [Free]
fixed   wall   = Cube at translate (8, 0, 0)

check again   : AG AF event bind(site)                                         // expect: holds
check thrown  : AG (event strong(site) => vx(ligand) = 2)                      // expect: holds
check slow    : always speed2(ligand) <= 1                                     // expect: violated
