// An octahedron flies towards a cube of its own mass, and nobody knows on which line: y and z may be anything in
// [-3, 3]. Face to face with the cube is its tip, which stops it; near the borders of the face it is one of its own
// faces, or edges, that meet an edge of the cube, and throw it aside.
//
//   scc check specs/models/meeting.sc --where
//   scc check specs/models/meeting.sc --draw meeting.svg
model meeting

param y in [-3, 3]
param z in [-3, 3]

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
shape Octahedron {
  vertices e (1,0,0)  w (-1,0,0)  n (0,1,0)  s (0,-1,0)  u (0,0,1)  d (0,0,-1)
  faces    enu [e,n,u]  wun [w,u,n]  wsu [w,s,u]  esu [e,u,s]
           edn [e,d,n]  wnd [w,n,d]  wds [w,d,s]  eds [e,s,d]
}

process p = Octahedron mass 1 velocity (1,0,0) at translate (0, y, z) [nil]
process q = Cube mass 1 at translate (8, 0, 0) [nil]

// |y| < 2, |z| < 2 and |y| + |z| < 3: 14 of 36
check meets : possibly vx(q) > 0        // expect: violated
// The tip meets the face, also on its border: |y| <= 1 and |z| <= 1: 4 of 36
check stops : possibly speed2(p) = 0    // expect: violated
// Above the face, or on its upper edge beside it
check up    : possibly vz(p) > 0        // expect: violated
check calm  : always speed2(p) <= 1     // expect: holds
