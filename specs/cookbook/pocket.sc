model pocket

compound Clamp = decompose {
  vertices a (0,0,0)  b (6,0,0)  c (6,1,0)  d (1,1,0)  e (1,6,0)  f (0,6,0)
           a' (0,0,2) b' (6,0,2) c' (6,1,2) d' (1,1,2) e' (1,6,2) f' (0,6,2)
  faces    bottom [a,f,e,d,c,b]  top [a',b',c',d',e',f']  front [a,b,b',a']  tip [b,c,c',b']
           inner [c,d,d',c']  wall [d,e,e',d']  end [e,f,f',e']  left [f,a,a',f']
} mass 3

behaviour Pocket = <~dock, {inner}>. nil
behaviour Ligand = <dock, {front}>. nil

fixed   clamp  = Clamp [Pocket]
process ligand = box(2, 2, 2) mass 1 velocity (0, -1, 0) at translate (3, 8, 1) [Ligand]

check docks  : eventually bound(clamp, ligand)
check inside : possibly x(ligand) < 6 and y(ligand) <= 2
