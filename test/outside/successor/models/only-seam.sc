// A cube comes with an edge to a face that is open without its border, and likewise to the seam of two halves of one:
// the first binds, the second bounces, since the edges at the seam are not listed (I-34, Cutting).
model only_seam

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
shape Half = Cube scaled (1, 1/2, 1)
compound Two {
  part u : Half mass 1/2 at translate (0, -1/2, 0)
  part v : Half mass 1/2 at translate (0, 1/2, 0)
  glue u.back ~ v.front
}
behaviour Comes on Cube = <~a, {left, right, front, back}>. nil

process whole = Cube mass 1 [<a, {only right}>. nil]
process halves = Two at translate (0, 0, 20) [<a, {only u.right, only v.right}>. nil]
process first  = Cube mass 1 velocity (-1, 0, 0) at translate (5, 1/5, 0) * rotate quaternion (1, 0, 0, 3) [Comes]
process second = Cube mass 1 velocity (-1, 0, 0) at translate (5, 1/5, 20) * rotate quaternion (1, 0, 0, 3) [Comes]
