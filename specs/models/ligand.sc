// A ligand in a box of six walls, and a receptor at one of them. The ligand goes from wall to wall until it comes to the
// receptor with its left face, and binds there.
model ligand

param start = 0      // how high the ligand starts

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
shape Receptor = Cube scaled (1/2, 1, 1)

behaviour Site   on Receptor = <site, {only right}>. nil
behaviour Ligand on Cube = <~site, {only left}>. nil

fixed west  = Cube scaled (1, 10, 10) at translate (-9, 0, 0)
fixed east  = Cube scaled (1, 10, 10) at translate (9, 0, 0)
fixed south = Cube scaled (8, 1, 10) at translate (0, -9, 0)
fixed north = Cube scaled (8, 1, 10) at translate (0, 9, 0)
fixed floor = Cube scaled (8, 8, 1) at translate (0, 0, -9)
fixed roof  = Cube scaled (8, 8, 1) at translate (0, 0, 9)
fixed receptor = Receptor at translate (-15/2, 5, 4) [Site]

process ligand = Cube mass 1 velocity (2, 1, 1) at translate (0, 0, start) [Ligand]

check inside : always x(ligand) >= -7 and x(ligand) <= 7 and y(ligand) <= 7 and z(ligand) <= 7  // expect: holds
check binds  : eventually bound(ligand, receptor)                           // expect: holds
check soon   : eventually bound(ligand, receptor) within 9                  // expect: violated
check stays  : AG (bound(ligand, receptor) => AG bound(ligand, receptor))   // expect: holds
check energy : A[ energy = 3 U bound(ligand, receptor) ]                    // expect: holds
check roof   : eventually event bounce(ligand, roof)                        // expect: holds
check walls  : possibly event bounce(ligand, floor)                         // expect: violated
