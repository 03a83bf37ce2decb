model hole

// Four bars about a hole of 2 by 2.
compound Frame {
  part below : box(1, 6, 2) mass 1 at translate (0, 0, -2)
  part above : box(1, 6, 2) mass 1 at translate (0, 0, 2)
  part front : box(1, 2, 2) mass 1 at translate (0, -2, 0)
  part back  : box(1, 2, 2) mass 1 at translate (0, 2, 0)
  glue below.top ~ front.bottom
  glue below.top ~ back.bottom
  glue above.bottom ~ front.top
}

// The same as one solid that is cut.
compound Plate = decompose {
  vertices
    a (-1/2,-3,-3)  b (-1/2,3,-3)  c (-1/2,3,3)  d (-1/2,-3,3)
    e (1/2,-3,-3)   f (1/2,3,-3)   g (1/2,3,3)   h (1/2,-3,3)
    i (-1/2,-1,-1)  j (-1/2,1,-1)  k (-1/2,1,1)  l (-1/2,-1,1)
    m (1/2,-1,-1)   n (1/2,1,-1)   o (1/2,1,1)   p (1/2,-1,1)
  faces
    left1 [a,i,j,b]  left2 [b,j,k,c]  left3 [c,k,l,d]  left4 [d,l,i,a]
    right1 [e,f,n,m]  right2 [f,g,o,n]  right3 [g,h,p,o]  right4 [h,e,m,p]
    bottom [a,b,f,e]  back [b,c,g,f]  top [c,d,h,g]  front [d,a,e,h]
    floor [i,m,n,j]  inner1 [j,n,o,k]  ceiling [k,o,p,l]  inner2 [l,p,m,i]
} mass 1

fixed frame = Frame
fixed plate = Plate at translate (0, 20, 0)

process small = box(1, 1, 1) mass 1 velocity (1, 0, 0) at translate (-4, 0, 0) [nil]
process large = box(1, 3, 1) mass 1 velocity (1, 0, 0) at translate (-4, 20, 0) [nil]

check through : eventually x(small) > 2
check back    : eventually event bounce(large, plate) within 4
check never   : always x(large) < 0
