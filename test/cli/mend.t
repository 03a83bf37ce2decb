Meshes of other programs are mended on request, and what was done is told. A cube of triangles with corners of their own,
one of them turned over:

  $ python3 > soup.obj << 'END'
  > corners = {0: "0 0 0", 1: "1 0 0", 2: "1 1 0", 3: "0 1 0", 4: "0 0 1", 5: "1 0 1", 6: "1 1 1", 7: "0 1 1.004"}
  > faces = [(0, 3, 2), (0, 2, 1), (4, 5, 6), (4, 6, 7), (0, 1, 5), (5, 0, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6),
  >          (3, 0, 4), (7, 3, 4)]
  > for f in faces:
  >     for c in f:
  >         print("v", corners[c])
  > for i in range(len(faces)):
  >     print("f", 3 * i + 1, 3 * i + 2, 3 * i + 3)
  > END
  $ scc shape soup.obj | sed -n '2p;5,6p'
  vertices: 36, edges: 36, faces: 12
  convex closed polyhedron: no
    error[SC0304]: vertices v0 and v3 have the same position
  $ scc shape --grid 1/100 --weld --orient --merge soup.obj -o cube.stl | head -8
  on the grid: 4 vertices moved, v11 the farthest, by 0.004
  welded: 36 vertices became 8
  oriented: 1 face turned over: f5
  merged: 12 faces became 6
  soup.obj
  vertices: 8, edges: 12, faces: 6
  names of faces: f0, f2, f4, f6, f8, f10
  names of vertices: v0, v1, v2, v5, v6, v7, v8, v11

A cube whose faces are there twice, and one whose faces are there from both sides:

  $ python3 > twice.off << 'END'
  > corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
  > faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
  > print("OFF", 8, 12, 0)
  > for c in corners: print(*c)
  > for f in faces + faces: print(4, *f)
  > END
  $ scc shape twice.off | grep mend
  to mend it: scc shape --weld
  $ scc shape --weld twice.off | head -3
  welded: 8 vertices became 8; 6 faces that were there twice went
  twice.off
  vertices: 8, edges: 12, faces: 6
  $ awk 'NR > 15 { print $1, $5, $4, $3, $2; next } { print }' twice.off > sides.off
  $ scc shape sides.off | grep mend
  to mend it: scc shape --weld
  $ scc shape --weld sides.off | head -3
  welded: 8 vertices became 8; 6 faces that were there twice went
  sides.off
  vertices: 8, edges: 12, faces: 6

A model mends a mesh by the same words, in the order in which the options work:

  $ cat > mended.sc << 'END'
  > shape Cube = mesh "soup.obj" grid 1/100 weld orient merge
  > compound Drawn = decompose "soup.obj" grid 1/100 weld orient merge mass 1
  > process p = Cube mass 1 [nil]
  > END
  $ scc check mended.sc 2> /dev/null | head -1
  semantics 3
  $ scc fmt mended.sc | head -2
  shape Cube = mesh "soup.obj" grid 1/100 weld orient merge
  compound Drawn = decompose "soup.obj" grid 1/100 weld orient merge mass 1
  $ scc translate --to xml mended.sc | grep '<mesh' | head -1
      <mesh file="soup.obj" grid="1/100" weld="true" orient="true" merge="true"/>
  $ sed 's/weld orient/orient weld/' mended.sc > order.sc; scc check order.sc 2>&1 | head -1
  order.sc:1:48: error[SC0110]: `weld` does not fit here: expected `merge`, `snap` and a distance, `union`, `scaled`, an attribute, or the next declaration
  $ sed 's/ merge//' mended.sc > merge.sc; scc check merge.sc 2>&1 | grep -E 'error|hint' | head -2
  merge.sc:1:19: error[SC0308]: faces f0 and f1 are coplanar neighbours
    hint: write `merge` after the file: neighbours in one plane become one face

  $ head -7 cube.stl
  solid scc
    facet normal 0 0 -1
      outer loop
        vertex 0 0 0
        vertex 0 1 0
        vertex 1 1 0
      endloop
  $ scc shape cube.stl | sed -n '2p;5p'
  vertices: 8, edges: 12, faces: 6
  convex closed polyhedron: yes
  $ scc shape --merge cube.stl -o cube.ply > /dev/null && cat cube.ply
  ply
  format ascii 1.0
  element vertex 8
  property double x
  property double y
  property double z
  element face 6
  property list uint uint vertex_indices
  end_header
  0 0 0
  0 1 0
  1 1 0
  1 0 0
  0 0 1
  1 0 1
  1 1 1
  0 1 1
  4 0 1 2 3
  4 4 5 6 7
  4 0 3 5 4
  4 3 2 6 5
  4 2 1 7 6
  4 1 0 4 7
  $ scc shape cube.ply | sed -n '2p;5p'
  vertices: 8, edges: 12, faces: 6
  convex closed polyhedron: yes

What is no template because it is not convex, but bounds a solid, is written all the same. So corners and directions
of faces are mended once and for all; in STL, faces are cut into triangles.

  $ awk 'NR > 2 && NR < 15 { p[NR - 3] = $0 }
  >      NR > 14 { f = "f"; for (i = 2; i <= NF; i++) { print "v " p[$i]; f = f " " ++n }; print f }' ell.off > ell.obj
  $ scc shape ell.obj -o refused.obj | sed -n 2p; ls refused.obj
  vertices: 36, edges: 36, faces: 8
  ls: cannot access 'refused.obj': No such file or directory
  [2]
  $ for f in obj stl sc; do scc shape --weld ell.obj -o out.$f > report; echo "$?: $(tail -n 1 report)"; done
  out.obj: not a convex polyhedron, but a solid: scc decompose takes it, and in a model decompose "out.obj"
  3: for convex parts of it: scc decompose; for its hull: scc shape --hull
  out.stl: not a convex polyhedron, but a solid: scc decompose takes it, and in a model decompose "out.stl"
  3: for convex parts of it: scc decompose; for its hull: scc shape --hull
  out.sc: not a convex polyhedron, but a solid: a compound, which is cut where it is used
  3: for convex parts of it: scc decompose; for its hull: scc shape --hull
  $ scc decompose out.obj | head -n 2; scc decompose out.stl | head -n 2; grep -c facet out.stl; head -n 3 out.sc
  out.obj: 8 plane faces, 1 reflex edge, volume 6
  2 convex parts, 1 joint
  out.stl: 8 plane faces, 1 reflex edge, volume 6
  2 convex parts, 1 joint
  40
  compound Out = decompose {
    vertices
      v0 (0, 0, 0)
  $ echo 'compound C = decompose "out.stl" mass 1 process p = C [nil] check still : always x(p) = 5/6' > model.sc
  $ scc check model.sc --time 1 2>&1 | grep still
  still: holds (exhaustive)

Rounded, it may be one no more: here a face is not flat then.

  $ awk 'NR > 2 && NR < 15 { $0 = $1 "/3 " $2 "/7 " 21 * $3 + 7 * $1 + 3 * $2 "/21" } { print }' ell.off > slant.off
  $ scc shape slant.off -o slant.ply | sed -n 2p; scc shape slant.off -o slant.ply --round | sed -n 2p
  slant.ply: error[SC0103]: the coordinates of v1 are no decimals, and files of this format have no fractions
    hint: with --round they are rounded to 64-bit numbers; .off and .obj keep fractions
  vertices: 12, edges: 18, faces: 8
  slant.ply: rounded: coordinates changed: 24, by at most 1.49e-16; faces may not be quite flat
  slant.ply: not a convex polyhedron, and rounded no solid that can be cut
  vertices: 12, edges: 18, faces: 8

A surface of one side (a strip of Möbius) has no outside.

  $ cat > strip.off << 'END'
  > OFF
  > 5 5 0
  > 0 0 0
  > 1 0 0
  > 0 1 0
  > 0 0 1
  > 1 1 1
  > 3 0 1 2
  > 3 1 2 3
  > 3 2 3 4
  > 3 3 4 0
  > 3 4 0 1
  > END
  $ scc shape --orient strip.off
  error[SC0303]: the faces cannot be oriented: the surface has only one side: going around it, face f3 comes out turned over
  [3]

A solid inside out is turned over as a whole. What is within another solid is a hollow of it, and its faces look inward.

  $ cat > inward.off << 'END'
  > OFF
  > 4 4 0
  > 0 0 0
  > 1 0 0
  > 0 1 0
  > 0 0 1
  > 3 0 1 2
  > 3 0 3 1
  > 3 0 2 3
  > 3 1 3 2
  > END
  $ scc shape --orient inward.off | head -3
  oriented: 4 faces turned over: f0, f1, f2, f3
  inward.off
  vertices: 4, edges: 6, faces: 4
  $ scc shape --orient hollow.off | head -1
  oriented: no face had to be turned over; within other pieces, and so hollows: the pieces of f4
  $ sed 's/^\(3 [4567]\) \([4567]\) \([4567]\)$/\1 \3 \2/' hollow.off > outward.off && scc decompose outward.off
  error[SC0375]: `f4` and the faces around it are within the solid, but turned outward: those of a hollow look into it
    hint: to mend it, add --orient
  [3]
  $ scc decompose --orient outward.off | head -2
  oriented: 4 faces turned over: f4, f5, f6, f7; within other pieces, and so hollows: the pieces of f4
  outward.off: 8 plane faces, 6 reflex edges, volume 485149/3
  $ scc decompose hollow.off | head -1
  hollow.off: 8 plane faces, 6 reflex edges, volume 485149/3

Where faces cross each other, nobody knows what is within what.

  $ sed 's/^0 0 1$/0 0 -99/' outward.off > through.off && scc shape --orient through.off | head -1
  oriented: 4 faces turned over: f4, f5, f6, f7

What has no decimals goes into formats with fractions, or is rounded.

  $ sed 's/1 0 0/1\/3 0 0/' inward.off > third.off
  $ scc shape --orient third.off -o third.ply > /dev/null
  third.ply: error[SC0103]: the coordinates of v1 are no decimals, and files of this format have no fractions
    hint: with --round they are rounded to 64-bit numbers; .off and .obj keep fractions
  [74]
  $ ls third.ply
  ls: cannot access 'third.ply': No such file or directory
  [2]
  $ scc shape --orient third.off -o third.obj > /dev/null && sed -n 2p third.obj
  v 1/3 0 0
  $ scc shape --orient third.off -o third.ply --round > /dev/null && sed -n 11p third.ply
  third.ply: rounded: coordinates changed: 1, by at most 1.86e-17; faces may not be quite flat
  0.333333333333333314829616256247390992939472198486328125 0 0
  $ scc shape third.off --round
  scc: --round tells how -o writes
  [64]
  $ scc shape third.off --grid 0
  scc: the distance of --grid is to be greater than 0
  Usage: scc shape [OPTION]… FILE
  Try 'scc shape --help' or 'scc --help' for more information.
  [64]

3MF files hold objects in a ZIP file: a cube of 10 by 20 by 30, twice, the second one beside the first.

  $ cat > pack.py << 'END'
  > import sys, zipfile
  > corners = [(x, y, z) for x in (0, 10) for y in (0, 20) for z in (0, 30)]
  > faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
  > triangles = [t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]
  > mesh = "<vertices>%s</vertices><triangles>%s</triangles>" % (
  >     "".join('<vertex x="%d" y="%d" z="%d"/>' % c for c in corners),
  >     "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in triangles))
  > model = """<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
  > <object id="1"><mesh>%s</mesh></object></resources><build><item objectid="1"/>%s</build></model>"""
  > rels = """<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r"
  > Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" Target="/3D/3dmodel.model"/></Relationships>"""
  > with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as file:
  >     file.writestr("_rels/.rels", rels)
  >     file.writestr("3D/3dmodel.model", model % (mesh, sys.argv[2]))
  > END
  $ python3 pack.py brick.3mf ''
  $ scc shape brick.3mf | sed -n '2p;5p;/^volume/p'
  vertices: 8, edges: 12, faces: 6
  convex closed polyhedron: yes
  volume: 6000
  $ python3 pack.py two.3mf '<item objectid="1" transform="1 0 0 0 1 0 0 0 1 10.5 0 0"/>'
  $ scc shape --hull two.3mf | grep volume
  volume: 12300
  $ python3 pack.py none.3mf '<item objectid="2"/>'
  $ scc shape none.3mf 2>&1 | head -1
  none.3mf:1:1: error[SC0320]: `3D/3dmodel.model`, line 2: there is no object `2` before this

Points that differ in their last digits: a grid is named on which each edge is in two faces.

  $ cat > near.off <<E
  > OFF
  > 5 4 0
  > 0 0 0
  > 1 0 0
  > 0 1 0
  > 0 0 1
  > 1.0000000001 0 0
  > 3 0 2 1
  > 3 0 1 3
  > 3 0 3 2
  > 3 4 2 3
  > E
  $ scc shape near.off | grep mend
  to mend it: scc shape --grid 1e-9 --weld
  $ scc decompose near.off
  error[SC0302]: the solid is not closed: edge [v2,v1] belongs to one face only, f0
  error[SC0302]: the solid is not closed: edge [v1,v3] belongs to one face only, f1
  error[SC0302]: the solid is not closed: edge [v4,v2] belongs to one face only, f3
  error[SC0302]: the solid is not closed: edge [v3,v4] belongs to one face only, f3
    hint: to mend it, add --grid 1e-9 --weld
  [3]
  $ scc shape --grid 1e-9 --weld near.off | head -4
  on the grid: 1 vertex moved, v4 the farthest, by 1e-10
  welded: 5 vertices became 4
  near.off
  vertices: 4, edges: 6, faces: 4

A face that is nearly along an axis, and not quite flat, is cut as it is seen along its normal.

  $ cat > bent.off <<E
  > OFF
  > 8 6 0
  > 1 1 -1
  > 1 -1 -1
  > -1 -1 -1
  > -1 1 -1
  > 1 0.999 1
  > -1 1 1
  > -1 -1 1
  > 0.999 -1.001 1
  > 4 0 1 2 3
  > 4 4 5 6 7
  > 4 0 4 7 1
  > 4 1 7 6 2
  > 4 2 6 5 3
  > 4 4 0 3 5
  > E
  $ scc decompose bent.off
  triangles: 3 faces were not planar, with corners up to 0.0005 off the plane
  bent.off: 9 plane faces, 0 reflex edges, volume 24000001/3000000
  1 convex part, 0 joints
    p1: 8 corners, 9 faces, volume 24000001/3000000

A corner of one face within an edge of another one: the edges beside it are in one face each, until faces of one plane
are merged.

  $ cat > notched.off <<'E'
  > OFF
  > 13 21 0
  > 0 0 0
  > 4 0 0
  > 4 1 0
  > 1 1 0
  > 1 4 0
  > 0 4 0
  > 0 0 2
  > 4 0 2
  > 4 1 2
  > 1 1 2
  > 1 4 2
  > 0 4 2
  > 2 0 0
  > 3 1 12 2
  > 3 3 2 0
  > 3 3 0 5
  > 3 5 4 3
  > 3 6 7 8
  > 3 6 8 9
  > 3 11 6 9
  > 3 9 10 11
  > 3 0 1 7
  > 3 0 7 6
  > 3 1 2 8
  > 3 1 8 7
  > 3 2 3 9
  > 3 2 9 8
  > 3 3 4 10
  > 3 3 10 9
  > 3 4 5 11
  > 3 4 11 10
  > 3 5 0 6
  > 3 5 6 11
  > 3 12 0 2
  > E
  $ scc shape notched.off | grep mend
  to mend it: scc shape --merge
  $ scc decompose notched.off 2>&1 | grep mend
    hint: to mend it, add --merge
  $ scc decompose --merge notched.off
  merged: 21 faces became 8; 1 face took in corners of others
  notched.off: 8 plane faces, 1 reflex edge, volume 14
  2 convex parts, 1 joint
    p1: 8 corners, 6 faces, volume 7
    p2: 8 corners, 6 faces, volume 7

With corners of its own at each face, points have to become one vertex first.

  $ awk 'NR <= 2 { next } NF == 3 { at[n++] = $0 } NF == 4 { for (i = 2; i <= 4; i++) points[m++] = at[$i] }
  >   END { print "OFF"; print m, m / 3, 0; for (i = 0; i < m; i++) print points[i]
  >         for (i = 0; i < m; i += 3) print 3, i, i + 1, i + 2 }' notched.off > apart.off
  $ scc shape apart.off | grep mend
  to mend it: scc shape --weld --merge
  $ scc decompose apart.off 2>&1 | grep mend
    hint: to mend it, add --weld
  $ scc decompose apart.off --weld 2>&1 | grep mend
    hint: to mend it, add --merge
