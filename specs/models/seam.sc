// A floor of two flush tiles, of which only the left one has the channel, and
// three cubes that would bind to it. One lands across the seam; one lands with
// an edge exactly on the seam, on its way to the right, away from the left
// tile; one lands on the right tile alone. A collision binds wherever the two
// processes touch, also in an edge of a part that nothing approaches (reading
// I-12): so the first two bind, and the third bounces.
model seam

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

behaviour Hold    on Floor = <a, {left.top}>. Hold
behaviour Sticky  on Cube  = <~a, {bottom}>. nil

fixed   floor  = Floor [Hold]
process across = Cube mass 1 velocity (0,-1,0) at translate (0,3,-6)  [Sticky]   // lands on x in [-1,1]
process edge   = Cube mass 1 velocity (1,-1,0) at translate (-1,3,0)  [Sticky]   // lands on x in [0,2]
process beside = Cube mass 1 velocity (0,-1,0) at translate (5,3,6)   [Sticky]   // lands on x in [4,6]

check across : eventually bound(floor, across)                        // expect: holds
check seam   : eventually bound(floor, edge) and x(edge) = 1          // expect: holds
check first  : always (vx(edge) = 1 or bound(floor, edge))             // expect: holds
check beside : eventually event bounce(beside)                        // expect: holds
check alone  : always not bound(floor, beside)                        // expect: holds
