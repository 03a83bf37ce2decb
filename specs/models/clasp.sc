// A ring of four with a clasp: one of its four bonds may be released, which leaves the other three and so one process
// (`bonds cyclic`, reading I-37). The clasp closes again 1 later. Nothing moves all the while.
model clasp
bonds cyclic
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}

behaviour Hook on Cube = <clasp, {only top}>. omega(clasp, {only top}). eps(1). Hook
behaviour Eye on Cube  = <~clasp, {only bottom}>. omega(clasp, {only bottom}). eps(1). Eye

process sw = Cube mass 1 at translate (-1, 0, -1) [Hook]
process se = Cube mass 1 at translate (1, 0, -1) [nil]
process ne = Cube mass 1 at translate (1, 0, 1) [nil]
process nw = Cube mass 1 at translate (-1, 0, 1) [Eye]
bond <link, {sw.right, se.left}>
bond <link, {se.top, ne.bottom}>
bond <link, {ne.left, nw.right}>

check one     : always size(sw) = 4                             // expect: holds
check closes  : AG (not bound(sw, nw) => AF[0,1] bound(sw, nw)) // expect: holds
check opens   : AG EF not bound(sw, nw)                         // expect: holds
check may_not : AF event weak(clasp)                            // expect: violated
check still   : always energy = 0 and bonds() >= 3              // expect: holds
check tree    : always bonds() = 3                              // expect: violated
