// An enzyme throws off what it has bound, and what it has thrown off leaves through the outlet in the east: a fixed body that
// absorbs what hits it (rule Absorb). The first to be thrown off hits the second on its way in, and sends it away unbound. A
// shuttle goes up and down beside them for ever. Without the outlet both would be farther away each time that it comes back,
// and no state would recur. `nowhere` asks where a body is that is gone: that has no answer.
model outlet

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Enzyme  = <~site, {right}>. eps(1). rho({<site, {right}>}). Enzyme
behaviour Ligand  = <site, {left}>. eps(1). rho({<site, {left}>}) push(2). nil

fixed   enzyme  = Cube at translate (0, 0, 0) [Enzyme]
process first   = Cube mass 1 velocity (-1, 0, 0) at translate (4, 0, 0) [Ligand]
process second  = Cube mass 1 velocity (-1, 0, 0) at translate (9, 0, 0) [Ligand]
fixed   outlet  = Cube scaled (1, 20, 20) absorb at translate (14, 0, 0)

process shuttle = Cube mass 1 velocity (0, 0, 1) at translate (0, 9, 0) [nil]
fixed   roof    = Cube at translate (0, 9, 5)
fixed   ground  = Cube at translate (0, 9, -5)

check all_out  : eventually gone(first) and gone(second)                // expect: holds
check goes_on  : AG EF event bounce(shuttle, roof)                      // expect: holds
check one_only : always not event bind(site, second)                    // expect: holds
check last     : AG (event absorb(first) => gone(second))               // expect: holds
check there    : always gone(first) or x(first) <= 12                   // expect: holds
check nowhere  : AG AF x(first) > 3                                     // expect: undecided
check stay     : always processes >= 6                                  // expect: violated
