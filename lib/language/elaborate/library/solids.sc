// Solids with named faces. Their frames have the origin at the centroid, where nothing else is said, and edges along the
// axes: `left` and `right` look along x, `front` and `back` along y, `bottom` and `top` along z. See specs/language.md.

// A cube of edge a.
shape Cube(a) = box(a, a, a)

// A plank, brick or tile: a box of these edges.
shape Plank(a, b, c) = box(a, b, c)

// A cube of edge a whose twelve edges are cut off at 45 degrees, c from each corner: its six faces have no edge or corner
// in common, so that a channel on one of them opens nothing of another. The cuts have the names of the two faces between
// which they are, and the eight triangles those of three.
shape Chamfered(a, c) {
  vertices l1 (-r, -s, -s)  l2 (-r, s, -s)  l3 (-r, s, s)   l4 (-r, -s, s)
           r1 (r, -s, -s)   r2 (r, s, -s)   r3 (r, s, s)    r4 (r, -s, s)
           f1 (-s, -r, -s)  f2 (s, -r, -s)  f3 (s, -r, s)   f4 (-s, -r, s)
           k1 (-s, r, -s)   k2 (s, r, -s)   k3 (s, r, s)    k4 (-s, r, s)
           b1 (-s, -s, -r)  b2 (s, -s, -r)  b3 (s, s, -r)   b4 (-s, s, -r)
           t1 (-s, -s, r)   t2 (s, -s, r)   t3 (s, s, r)    t4 (-s, s, r)
  faces    bottom [b1, b4, b3, b2]  top [t1, t2, t3, t4]  left [l1, l4, l3, l2]
           right [r1, r2, r3, r4]  front [f1, f2, f3, f4]  back [k1, k4, k3, k2]
           bottom_left [b1, l1, l2, b4]  bottom_right [b2, b3, r2, r1]  bottom_front [b1, b2, f2, f1]
           bottom_back [b4, k1, k2, b3]  top_left [t1, t4, l3, l4]  top_right [t2, r4, r3, t3]
           top_front [t1, f4, f3, t2]  top_back [t4, t3, k3, k4]  left_front [l1, f1, f4, l4]
           left_back [l2, l3, k4, k1]  right_front [r1, r4, f3, f2]  right_back [r2, k2, k3, r3]
           bottom_left_front [b1, f1, l1]  bottom_right_front [b2, r1, f2]
           bottom_left_back [b4, l2, k1]  bottom_right_back [b3, k2, r2]  top_left_front [t1, l4, f4]
           top_right_front [t2, f3, r4]  top_left_back [t4, k4, l3]  top_right_back [t3, r3, k3]
}
  where r = a/2,
        s = a/2 - c

// Half of a box of these edges, cut from the right edge of its bottom to the left edge of its top; `slope` is the cut.
shape Wedge(a, b, c) {
  vertices a1 (-a/3, -b/2, -c/3)  b1 (2*a/3, -b/2, -c/3)  c1 (2*a/3, b/2, -c/3)  d1 (-a/3, b/2, -c/3)
           e1 (-a/3, -b/2, 2*c/3)  h1 (-a/3, b/2, 2*c/3)
  faces    bottom [a1, d1, c1, b1]  left [a1, e1, h1, d1]  slope [b1, c1, h1, e1]
           front [a1, b1, e1]  back [d1, h1, c1]
}

// The Platonic solids beside the cube, about the origin. The tetrahedron's corners are four of those of a cube of edge a,
// and each face has the name of the corner that is not of it.
shape Tetrahedron(a) {
  vertices v1 (-r, -r, -r)  v2 (r, r, -r)  v3 (r, -r, r)  v4 (-r, r, r)
  faces    f1 [v2, v4, v3]  f2 [v1, v3, v4]  f3 [v1, v4, v2]  f4 [v1, v2, v3]
}
  where r = a/2

// Corners at distance r from the origin, on the axes; faces by the octants that they look to.
shape Octahedron(r) {
  vertices left_v (-r, 0, 0)  right_v (r, 0, 0)  front_v (0, -r, 0)  back_v (0, r, 0)
           bottom_v (0, 0, -r)  top_v (0, 0, r)
  faces    top_right_back [top_v, right_v, back_v]  top_left_back [top_v, back_v, left_v]
           top_left_front [top_v, left_v, front_v]  top_right_front [top_v, front_v, right_v]
           bottom_right_back [bottom_v, back_v, right_v]  bottom_left_back [bottom_v, left_v, back_v]
           bottom_left_front [bottom_v, front_v, left_v]  bottom_right_front [bottom_v, right_v, front_v]
}

// The golden ratio is irrational: this dodecahedron and this icosahedron are regular to the sixth decimal, and exactly as
// symmetric as a pyritohedron. Their faces are f1, f2, … as those of any hull.
shape Dodecahedron(r) = hull {
  v1 (-r, -r, -r)  v2 (-r, -r, r)  v3 (-r, r, -r)  v4 (-r, r, r)
  v5 (r, -r, -r)  v6 (r, -r, r)  v7 (r, r, -r)  v8 (r, r, r)
  v9 (0, -p, -q)  v10 (0, -p, q)  v11 (0, p, -q)  v12 (0, p, q)
  v13 (-q, 0, -p)  v14 (q, 0, -p)  v15 (-q, 0, p)  v16 (q, 0, p)
  v17 (-p, -q, 0)  v18 (-p, q, 0)  v19 (p, -q, 0)  v20 (p, q, 0)
}
  where h = 610/987,
        p = r*(1 + h),
        q = r*(1 - h*h)

shape Icosahedron(r) = hull {
  v1 (0, -r, -p)  v2 (0, -r, p)  v3 (0, r, -p)  v4 (0, r, p)
  v5 (-p, 0, -r)  v6 (p, 0, -r)  v7 (-p, 0, r)  v8 (p, 0, r)
  v9 (-r, -p, 0)  v10 (-r, p, 0)  v11 (r, -p, 0)  v12 (r, p, 0)
}
  where p = r*987/610

// A room: a box of walls, open to nothing, whose inside has these edges and whose walls are w thick. It is made to be
// `fixed`; each wall has the face names of a box, so that its inner faces are `floor.top`, `ceiling.bottom`, `west.right`,
// `east.left`, `south.back` and `north.front`.
compound Room(a, b, c, w) {
  part floor   : box(a + 2*w, b + 2*w, w) mass 1 at translate (0, 0, -d.z)
  part ceiling : box(a + 2*w, b + 2*w, w) mass 1 at translate (0, 0, d.z)
  part west    : box(w, b + 2*w, c) mass 1 at translate (-d.x, 0, 0)
  part east    : box(w, b + 2*w, c) mass 1 at translate (d.x, 0, 0)
  part south   : box(a, w, c) mass 1 at translate (0, -d.y, 0)
  part north   : box(a, w, c) mass 1 at translate (0, d.y, 0)
  glue floor.top ~ west.bottom
  glue floor.top ~ east.bottom
  glue floor.top ~ south.bottom
  glue floor.top ~ north.bottom
  glue west.top ~ ceiling.bottom
}
  where d = (a + w, b + w, c + w)/2
