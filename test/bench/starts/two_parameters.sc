model ligand
timestep 1 steady
param x in [-3, 3]
param z in [0, 3]
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
behaviour Site on Cube = <site, {top}>. nil
behaviour Ligand on Cube = <~site, {bottom}>. nil
fixed membrane = Cube scaled (30, 2, 1) at translate (0, 0, -5)
fixed receptor = Cube scaled (1, 1, 1/4) at translate (0, 0, -15/4) [Site]
process ligand = Cube mass 1 at translate (x, 0, z) [Ligand]
motion ligand = choose { (1,0,0) weight 1, (-1,0,0) weight 1, (0,0,1) weight 1, (0,0,-1) weight 1 }
check binds : P = ? [ eventually bound(ligand, receptor) within 20 ]
