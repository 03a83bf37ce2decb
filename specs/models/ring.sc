// Four cubes close to a ring: two by two along x, and then all along z. Bonds of a process form a tree, so that the ring has
// three bonds, and its last contact is one that only touches: `touching` tells whether it is closed. With `bonds cyclic`
// it has four: closed_ring.sc.
model ring

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour SW on Cube = <row, {only right}>. <col, {only top}>. nil
behaviour SE on Cube = <~row, {only left}>. <col, {only top}>. nil
behaviour NW on Cube = <row, {only right}>. <~col, {only bottom}>. nil
behaviour NE on Cube = <~row, {only left}>. <~col, {only bottom}>. nil

process sw = Cube mass 1 velocity (1,0,1)   at translate (-3, 0, -4) [SW]
process se = Cube mass 1 velocity (-1,0,1)  at translate (3, 0, -4) [SE]
process nw = Cube mass 1 velocity (1,0,-1)  at translate (-3, 0, 4) [NW]
process ne = Cube mass 1 velocity (-1,0,-1) at translate (3, 0, 4) [NE]

let closed = touching(sw, se) and touching(se, ne) and touching(ne, nw) and touching(nw, sw)

check closes  : eventually closed and size(sw) = 4              // expect: holds
check stays   : AG (closed => AG closed)                        // expect: holds
check tree    : always bonds() <= 3                             // expect: holds
check four    : possibly bonds() = 4                            // expect: violated
check at_rest : AG (size(sw) = 4 => energy = 0)                 // expect: holds
check last    : always not bound(sw, nw) or not bound(se, ne)   // expect: holds
check west    : possibly bound(sw, nw)                          // expect: holds
check surely  : eventually bound(sw, nw)                        // expect: violated
