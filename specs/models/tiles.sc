// A floor of two flush tiles. A cube that lands across the seam, or with an
// edge exactly on it, must bounce straight up as from one plate: the side
// faces of the tiles that meet at the seam are covered and do not count
// (reading I-13). So both cubes keep their sideways velocity.
model tiles

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
shape Tile = Cube scaled (10, 1, 10)

compound Floor {
  part left  : Tile mass 1 at translate (-10,-1,0)
  part right : Tile mass 1 at translate (10,-1,0)
  glue left.right ~ right.left
}

fixed   floor  = Floor
process across = Cube mass 1 velocity (-1,-1,0) at translate (2,3,-4) [nil]   // lands on x in [-1,1]
process edge   = Cube mass 1 velocity (-1,-1,0) at translate (3,3,4)  [nil]   // lands on x in [0,2]

check lands    : possibly y(across) = 1 and x(across) = 0     // expect: holds
check on_seam  : possibly y(edge) = 1 and x(edge) = 1         // expect: holds
check straight : always vx(across) = -1 and vx(edge) = -1     // expect: holds
check up       : eventually vy(across) = 1 and vy(edge) = 1   // expect: holds
check above    : always y(across) >= 1 and y(edge) >= 1       // expect: holds
