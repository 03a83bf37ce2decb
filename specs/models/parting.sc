// An enzyme throws its product out, and holds on to an inhibitor that may leave at any whole time,
// or never. The product is faster than all that is left behind may ever be: how far it has come is not told apart, beyond
// the distance that a check asks about, and so all of it is explored.

model parting

split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Enzyme    = rho({<site, {right}>}). Clear
behaviour Clear     = omega(stop, {left}). nil
behaviour Product   = rho({<site, {left}>}) push(2). nil
behaviour Inhibitor = omega(stop, {right}). nil

process enzyme = i : Cube mass 1 at translate (-2, 0, 0) [Inhibitor] <stop, {i.right, e.left}>
                 e : Cube mass 1 [Enzyme] <site, {e.right, p.left}>
                 p : Cube mass 1 at translate (2, 0, 0) [Product]

check thrown  : eventually vx(p) - vx(e) = 3                    // expect: holds
check leaves  : AG EF not bound(i, e)                           // expect: holds
check for_now : eventually not bound(i, e)                      // expect: violated
check far     : AG (distance2(e, p) > 100 => not touching(e, p)) // expect: holds
check farther : eventually distance2(e, p) > 100                // expect: holds
