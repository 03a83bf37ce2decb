// A filament grows from a seed that holds everything still: monomers arrive one by one and bind to its tip, each with the
// one face that fits and with the face `only`, so that nobody binds at a side.
model filament

param n = 4

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Tip  on Cube = <grow, {only right}>. nil
behaviour Free on Cube = <~grow, {only left}>. Tip

fixed seed = Cube [Tip]
for i in 1..n { process m[i] = Cube mass 1 velocity (-1,0,0) at translate (4*i, 0, 0) [Free] }

check grows    : eventually size(seed) = n + 1                                  // expect: holds
check in_time  : eventually size(seed) = n + 1 within 2*n                       // expect: holds
check too_soon : possibly size(seed) = n + 1 within 2*n - 1                     // expect: violated
check in_order : A[ not bound(m[2], m[3]) U bound(seed, m[1]) ]                 // expect: holds
check straight : AG (size(seed) = n + 1 => x(m[n]) = 2*n and y(m[n]) = 0)       // expect: holds
check one_tip  : AG (size(seed) = n + 1 => count(c in m: offers(c, grow)) = 1)  // expect: holds
check momentum : always momentum.x = -n                                         // expect: violated
