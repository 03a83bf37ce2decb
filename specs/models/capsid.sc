// Eight cubes come together to one: in twos along x, in fours along y, all along z. Each binds with the three faces
// that it turns to the middle, and with them `only`, without their edges and corners (reading I-34): else two that
// touch along an edge, across the middle, would bind there as well, and each way to do so would be another capsid.
model capsid

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Inner = <face, {only right, only back, only top}>. Inner + <~face, {only right, only back, only top}>. Inner

// below, each a quarter turn about z after the one before
process s = Cube mass 1 velocity (1, 1, 1) at translate (-2, -3, -4) [Inner]
process t = Cube mass 1 velocity (-1, 1, 1) at translate (2, -3, -4) * rotate quaternion (1, 0, 0, 1) [Inner]
process u = Cube mass 1 velocity (-1, -1, 1) at translate (2, 3, -4) * rotate quaternion (0, 0, 0, 1) [Inner]
process v = Cube mass 1 velocity (1, -1, 1) at translate (-2, 3, -4) * rotate quaternion (1, 0, 0, -1) [Inner]

// above, those below turned over
process w = Cube mass 1 velocity (1, -1, -1) at translate (-2, 3, 4) * rotate quaternion (0, 1, 0, 0) [Inner]
process x = Cube mass 1 velocity (1, 1, -1) at translate (-2, -3, 4) * rotate quaternion (0, 1, 1, 0) [Inner]
process y = Cube mass 1 velocity (-1, 1, -1) at translate (2, -3, 4) * rotate quaternion (0, 0, 1, 0) [Inner]
process z = Cube mass 1 velocity (-1, -1, -1) at translate (2, 3, 4) * rotate quaternion (0, 1, -1, 0) [Inner]

check assembles : eventually size(s) = 8                              // expect: holds
check in_time   : eventually size(s) = 8 within 3                     // expect: holds
check stays     : AG (size(s) = 8 => AG size(s) = 8)                  // expect: holds
check tree      : always bonds(face) <= 7                             // expect: holds
check across    : always not bound(s, u) and not bound(s, z)          // expect: holds
check pairs     : possibly size(s) = 2 and size(u) = 2 within 1       // expect: holds
check early     : possibly size(s) = 8 within 2                       // expect: violated
