// Four cubes close to a ring, as in ring.sc, and here the ring has four bonds: with `bonds cyclic` two bodies of one process
// that touch with open channels bind as well (rule Close, reading I-37). The last bond closes at the instant of the third.
// After a time of 2 all four corners react at once, and the ring falls apart.
model closed_ring
bonds cyclic

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour SW on Cube = <row, {only right}>. <col, {only top}>. eps(2). rho({<row, {only right}>, <col, {only top}>}). nil
behaviour SE on Cube = <~row, {only left}>. <col, {only top}>. eps(2). rho({<row, {only left}>, <col, {only top}>}). nil
behaviour NW on Cube = <row, {only right}>. <~col, {only bottom}>. eps(2). rho({<row, {only right}>, <col, {only bottom}>}). nil
behaviour NE on Cube = <~row, {only left}>. <~col, {only bottom}>. eps(2). rho({<row, {only left}>, <col, {only bottom}>}). nil

process sw = Cube mass 1 velocity (1,0,1)   at translate (-3, 0, -4) [SW]
process se = Cube mass 1 velocity (-1,0,1)  at translate (3, 0, -4) [SE]
process nw = Cube mass 1 velocity (1,0,-1)  at translate (-3, 0, 4) [NW]
process ne = Cube mass 1 velocity (-1,0,-1) at translate (3, 0, 4) [NE]

let closed = bound(sw, se) and bound(se, ne) and bound(ne, nw) and bound(nw, sw)

check closes  : AF[3,3] closed                                  // expect: holds
check four    : always bonds() <= 4                             // expect: holds
check at_once : AG (size(sw) = 4 => AF[0,0] closed)             // expect: holds
check stays   : AG (closed => AF[0,2] bonds() = 0)                // expect: holds
check opens   : AG (event strong() => size(sw) = 1 and size(se) = 1 and size(nw) = 1 and size(ne) = 1)  // expect: holds
check at_rest : AG (closed => energy = 0)                       // expect: holds
check tree    : always bonds() <= 3                             // expect: violated
