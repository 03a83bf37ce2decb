A solid like the letter L (ell.off), in two parts, as many as it needs:

  $ scc decompose ell.off -o ell.sc --mass 12
  ell.off: 8 plane faces, 1 reflex edge, volume 6
  2 convex parts, 1 joint
    p1: 8 corners, 6 faces, volume 3
    p2: 8 corners, 6 faces, volume 3

What is written is a compound, whose parts share the mass by their volumes:

  $ cat ell.sc
  shape Ell_p1 {
    vertices
      v0 (0, 0, 0)
      v5 (0, 0, 2)
      v6 (0, 2, 0)
      v11 (0, 2, 2)
      v3 (1, 0, 1)
      v4 (1, 0, 2)
      v9 (1, 2, 1)
      v10 (1, 2, 2)
    faces
      f7 [v0, v5, v11, v6]
      cut1 [v0, v6, v9, v3]
      f0 [v0, v3, v4, v5]
      f6 [v5, v4, v10, v11]
      f1 [v6, v11, v10, v9]
      f5 [v3, v9, v10, v4]
  }
  
  shape Ell_p2 {
    vertices
      v0 (0, 0, 0)
      v6 (0, 2, 0)
      v3 (1, 0, 1)
      v9 (1, 2, 1)
      v1 (2, 0, 0)
      v2 (2, 0, 1)
      v7 (2, 2, 0)
      v8 (2, 2, 1)
    faces
      f2 [v0, v6, v7, v1]
      cut2 [v0, v3, v9, v6]
      f0 [v0, v1, v2, v3]
      f1 [v6, v9, v8, v7]
      f4 [v3, v2, v8, v9]
      f3 [v1, v7, v8, v2]
  }
  
  compound Ell {
    part p1 : Ell_p1 mass 6
    part p2 : Ell_p2 mass 6
    glue p1.cut1 ~ p2.cut2
  }
  $ cat > model.sc <<'END'
  > import "ell.sc"
  > process p = ell.Ell velocity (1, 0, 0) [nil]
  > check whole : always x(p) = 5/6 + time
  > END
  $ scc check model.sc --time 1 2> /dev/null | grep -v '^$'
  semantics 3
  whole: holds (exhaustive)
    always x(p) = 5/6 + time
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  1 property: 1 holds

The same in one word; mass, centre and all that follows from them are equal:

  $ cat > word.sc <<'END'
  > compound Ell = decompose "ell.off" mass 12
  > process p = Ell velocity (1, 0, 0) [nil]
  > check whole : always x(p) = 5/6 + time
  > END
  $ scc check word.sc --time 1 2> /dev/null | grep -v '^$'
  semantics 3
  whole: holds (exhaustive)
    always x(p) = 5/6 + time
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  1 property: 1 holds

As OBJ, each part an object:

  $ scc decompose ell.off -o ell.obj > /dev/null && grep -c '^v ' ell.obj && grep '^o' ell.obj
  16
  o p1
  o p2

A convex one stays whole. The names of faces are those of the file.

  $ scc decompose ../../specs/models/parts/clamp.obj | head -n 2
  ../../specs/models/parts/clamp.obj: 10 plane faces, 2 reflex edges, volume 32
  3 convex parts, 2 joints
  $ scc shape --hull ell.off -o hull.off > /dev/null && scc decompose hull.off
  hull.off: 7 plane faces, 0 reflex edges, volume 7
  1 convex part, 0 joints
    p1: 10 corners, 7 faces, volume 7
  $ scc decompose ell.off --json | grep -c '"format": "scc-decomposition"'
  1

What is refused, and why:

  $ grep -v '^4 5 11 6 0' ell.off | sed 's/^12 8 0/12 7 0/' > open.off && scc decompose open.off
  error[SC0302]: the solid is not closed: edge [v5,v0] belongs to one face only, f0
  error[SC0302]: the solid is not closed: edge [v6,v11] belongs to one face only, f1
  error[SC0302]: the solid is not closed: edge [v0,v6] belongs to one face only, f2
  error[SC0302]: the solid is not closed: edge [v11,v5] belongs to one face only, f6
  [3]
  $ sed 's/^1 0 2$/1 0 -1/' ell.off > bent.off && scc decompose bent.off 2>&1 | head -n 3
  error[SC0306]: face f0 is not a simple polygon: it crosses itself or winds more than once
  error[SC0306]: face f5 is not a simple polygon: it crosses itself or winds more than once
  $ scc decompose crossing.off
  error[SC0337]: the faces `f0` and `f5` have the point (2, 1, 0) in common, which is at no edge or corner of both
    hint: if solids overlap there, add --union
  [3]
  $ sed 's/^1 1 1$/11 1 1/; s/^5 1 1/15 1 1/; s/^1 5 1/11 5 1/; s/^1 1 -5/11 1 -5/' crossing.off > two.off
  $ scc decompose two.off
  error[SC0310]: these are several solids: `f0` is a face of one, and `f4` of another one beside it
    hint: each of several solids needs a file of its own, or add --union for all of them
  [3]
  $ sed 's/^1 0 0$/8 0 0/; s/^0 1 0$/0 8 0/; s/^0 0 1$/0 0 8/; s/^8 8 0$/12 12 0/; s/^3 0 2 1$/1 1 1\n2 1 1\n1 2 1\n1 1 2\n&/' hollow.off > island.off
  $ printf '3 8 10 9\n3 8 9 11\n3 8 11 10\n3 9 10 11\n' >> island.off && scc decompose island.off
  error[SC0310]: these are several solids: `f8` is a face of one that is in a hollow of another one, with the face `f0`
    hint: each of several solids needs a file of its own, or add --union for all of them
  [3]
  $ scc decompose island.off --orient 2>&1 | tail -n 2
  error[SC0310]: these are several solids: `f8` is a face of one that is in a hollow of another one, with the face `f0`
    hint: each of several solids needs a file of its own, or add --union for all of them
  $ scc decompose ell.off -o ell.stp
  scc: `ell.stp' does not tell a format that parts are written in, by its ending: .sc, .obj
  [64]
  $ scc decompose nothing.off
  nothing.off: error[SC0101]: cannot read: No such file or directory
  [3]

Meshes of other programs are mended first, on request, and what was done is told. Here every face has corners of its
own, and one is turned over:

  $ python3 > soup.obj <<'END'
  > lines = open("ell.off").read().split("\n")
  > points = lines[2:14]
  > faces = [[int(i) for i in line.split()[1:]] for line in lines[14:22]]
  > faces[4].reverse()
  > for face in faces:
  >     print("".join(f"v {points[i]}\n" for i in face) + "f", " ".join(str(i - len(face)) for i in range(len(face))))
  > END
  $ scc decompose soup.obj 2>&1 | sed -n '1,2p;$p'
  error[SC0304]: vertices v0 and v12 have the same position
  error[SC0304]: vertices v6 and v13 have the same position
    hint: to mend it, add --weld
  $ scc decompose soup.obj --weld
  error[SC0303]: face f4 is turned over: it runs the other way round than its neighbours
    hint: to mend it, add --orient
  [3]
  $ scc decompose soup.obj --weld --orient
  welded: 36 vertices became 12
  oriented: 1 face turned over: f4
  soup.obj: 8 plane faces, 1 reflex edge, volume 6
  2 convex parts, 1 joint
    p1: 8 corners, 6 faces, volume 3
    p2: 8 corners, 6 faces, volume 3
  $ scc decompose soup.obj --weld --orient --json | sed -n '/mended/,/]/p'
    "mended": [
      {"by": "weld", "told": "welded: 36 vertices became 12"},
      {"by": "orient", "told": "oriented: 1 face turned over: f4"}
    ],
  $ scc shape soup.obj --weld --orient --json | sed -n '/mended/,/]/p'
    "mended": [
      {"by": "weld", "told": "welded: 36 vertices became 12"},
      {"by": "orient", "told": "oriented: 1 face turned over: f4"}
    ],
  $ scc decompose ell.off --grid 0
  scc: the distance of --grid is to be greater than 0
  Usage: scc decompose [OPTION]… MESH
  Try 'scc decompose --help' or 'scc --help' for more information.
  [64]

One that takes too long, of 7200 triangles; there is nothing then.

  $ python3 -B terrain.py 60 > terrain.off
  $ scc decompose terrain.off --seconds 0.2 -o terrain.obj
  scc: the limit of 0.2 seconds has passed: nothing was written
  [4]
  $ ls terrain.obj
  ls: cannot access 'terrain.obj': No such file or directory
  [2]
  $ scc decompose terrain.off --memory 1 -o terrain.obj
  scc: the limit of memory was met: nothing was written
  [4]
  $ ls terrain.obj
  ls: cannot access 'terrain.obj': No such file or directory
  [2]
  $ scc decompose terrain.off --seconds 0
  scc: option '--seconds': `0' is no positive number of seconds
  Usage: scc decompose [OPTION]… MESH
  Try 'scc decompose --help' or 'scc --help' for more information.
  [64]
  $ python3 -B terrain.py 4 > small.off && scc decompose small.off --seconds 100 | head -n 1
  small.off: 37 plane faces, 25 reflex edges, volume 46229/2

A prism with a zigzag on top needs no more parts than cuts between its corners. A cut along a slanted face goes on into
the cap; with `--names` each part shows one face of the solid on each side.

  $ python3 -B zigzag.py > zigzag.off
  $ scc decompose zigzag.off | sed -n 2p
  6 convex parts, 5 joints
  $ scc decompose zigzag.off --names | sed -n 2p
  7 convex parts, 6 joints

Faces that are not flat become triangles, which is told; the volume is that of the triangles.

  $ printf 'OFF\n8 6 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 3\n0 2 2\n4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n' > bent_lid.off
  $ scc decompose bent_lid.off
  triangles: 1 face was not planar, with corners up to 0.471 off the plane
  bent_lid.off: 7 plane faces, 1 reflex edge, volume 26/3
  2 convex parts, 1 joint
    p1: 6 corners, 5 faces, volume 4
    p2: 6 corners, 5 faces, volume 14/3
  $ scc decompose bent_lid.off --json | sed -n '/mended/,/]/p'
    "mended": [
      {
        "by": "triangles",
        "told": "triangles: 1 face was not planar, with corners up to 0.471 off the plane"
      }
    ],

Solids of one file that overlap, touch or are apart are cut by `--union`: here two cubes with an edge in common, of which
each needs a compound of its own.

  $ printf 'OFF\n16 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n1 1 0\n2 1 0\n2 2 0\n1 2 0\n1 1 1\n2 1 1\n2 2 1\n1 2 1\n' > edge.off
  $ printf '4 0 3 2 1\n4 4 5 6 7\n4 0 4 7 3\n4 1 2 6 5\n4 0 1 5 4\n4 3 7 6 2\n4 8 11 10 9\n4 12 13 14 15\n4 8 12 15 11\n4 9 10 14 13\n4 8 9 13 12\n4 11 15 14 10\n' >> edge.off
  $ scc decompose edge.off --weld
  error[SC0303]: faces f3 and f8 both run from v2 to v6
  error[SC0303]: faces f5 and f10 both run from v6 to v2
    hint: solids have an edge in common, from v2 to v6; for all of them: scc decompose --union
  [3]
  $ scc decompose edge.off --union -o edge.sc && grep -A 2 compound edge.sc
  edge.off: 12 plane faces, 1 reflex edge, volume 2
  2 convex parts, 0 joints, in 2 pieces
    p1: 8 corners, 6 faces, volume 1
    p2: 8 corners, 6 faces, volume 1
  compound Edge_1 {
    part p1 : Edge_p1 mass 1
  }
  --
  compound Edge_2 {
    part p2 : Edge_p2 mass 1
  }
  $ scc decompose crossing.off --union | head -n 2
  crossing.off: 8 plane faces, 5 reflex edges, volume 51/2
  3 convex parts, 2 joints, in 1 piece

What is inside of another solid counts for nothing, whatever its form. So the union of a cube and an L in it is a convex
solid:

  $ { printf 'OFF\n20 14 0\n'; sed -n 3,14p ell.off; for z in -1 8; do printf "%s $z\n" '-1 -1' '8 -1' '8 8' '-1 8'; done; sed 1,14d ell.off; } > inside.off
  $ printf '4 12 15 14 13\n4 16 17 18 19\n4 12 16 19 15\n4 13 14 18 17\n4 12 13 17 16\n4 15 19 18 14\n' >> inside.off
  $ scc decompose inside.off --union
  inside.off: 6 plane faces, 0 reflex edges, volume 729
  1 convex part, 0 joints, in 1 piece
    p1: 8 corners, 6 faces, volume 729

Of four cubes in each other, of which the second and the fourth are hollows, two solids are made, each with its hollow:

  $ cat > nested.awk <<'EOF'
  > BEGIN {
  >   print "OFF\n32 24 0"
  >   for (k = 4; k; k--)
  >     for (i = 0; i < 8; i++) print (i % 2 ? k : -k), (int(i / 2) % 2 ? k : -k), (i > 3 ? k : -k)
  >   n = split("0 2 3 1,4 5 7 6,0 1 5 4,2 6 7 3,0 4 6 2,1 3 7 5", faces, ",")
  >   for (k = 0; k < 32; k += 8)
  >     for (j = 1; j <= n; j++) {
  >       split(faces[j], c, " ")
  >       print 4, c[1] + k, c[k % 16 ? 4 : 2] + k, c[3] + k, c[k % 16 ? 2 : 4] + k
  >     }
  > }
  > EOF
  $ awk -f nested.awk > nested.off; scc decompose --union nested.off | head -n 2
  nested.off: 24 plane faces, 24 reflex edges, volume 352
  12 convex parts, 10 joints, in 2 pieces

A pyramid stands on its tip, in the middle of a triangle of a slab:

  $ printf 'OFF\n12 11 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n0 0 1\n3 0 1\n3 3 1\n0 3 1\n2 1 1\n1 0 2\n3 0 2\n2 3 2\n' > tip.off
  $ printf '4 0 3 2 1\n3 4 5 6\n3 4 6 7\n4 0 4 7 3\n4 1 2 6 5\n4 0 1 5 4\n4 3 7 6 2\n3 9 10 11\n3 8 10 9\n3 8 11 10\n3 8 9 11\n' >> tip.off
  $ scc decompose --union tip.off
  tip.off: 10 plane faces, 0 reflex edges, volume 10
  2 convex parts, 0 joints, in 2 pieces
    p1: 8 corners, 6 faces, volume 9
    p2: 4 corners, 4 faces, volume 1

Solids in one piece are cut as without the option:

  $ scc decompose ell.off --union | head -n 2
  ell.off: 8 plane faces, 1 reflex edge, volume 6
  2 convex parts, 1 joint, in 1 piece
  $ scc decompose open.off --union | head -n 1
  error[SC0302]: the solid is not closed: edge [v5,v0] belongs to one face only, f0
  error[SC0302]: the solid is not closed: edge [v6,v11] belongs to one face only, f1
  error[SC0302]: the solid is not closed: edge [v0,v6] belongs to one face only, f2
  error[SC0302]: the solid is not closed: edge [v11,v5] belongs to one face only, f6

The number of parts has a bound, which an option sets:

  $ scc decompose ell.off --parts 1
  error[SC0111]: the solid takes more than 1 convex part, or more than 20 cells on the way to them
    hint: --parts sets how many there may be
  [3]
  $ scc decompose crossing.off --union --parts 2
  error[SC0111]: the solid takes more than 2 convex parts, or more than 40 cells on the way to them
    hint: --parts sets how many there may be
  [3]
  $ scc decompose ell.off --parts 2 | head -n 2
  ell.off: 8 plane faces, 1 reflex edge, volume 6
  2 convex parts, 1 joint
  $ scc decompose ell.off --parts 0 2>&1 | head -n 1
  scc: option '--parts': `0' is no number of parts

In a model the word `union` does what the option does. Faces keep their names:

  $ cat > union.sc << 'END'
  > compound C = decompose "crossing.off" union mass 1
  > process p = C [<a, {f0, only f1, [v0, v1]}>. nil]
  > END
  $ scc check union.sc | tail -n 1
  no properties to check
  $ sed 's/ union//' union.sc > crossing.sc; scc check crossing.sc
  crossing.sc:1:24: error[SC0337]: the faces `f0` and `f5` have the point (2, 1, 0) in common, which is at no edge or corner of both
     |
   1 | compound C = decompose "crossing.off" mass 1
     |                        ^^^^^^^^^^^^^^
    hint: write `union` after the file: solids that overlap, share faces or touch become one
  [3]
  $ sed 's/f0,/other,/' union.sc > other.sc; scc check other.sc
  other.sc:2:21: error[SC0203]: `C` has no feature `other`
     |
   2 | process p = C [<a, {other, only f1, [v0, v1]}>. nil]
     |                     ^^^^^
  note: its faces are f0, f0_2, f1, f2, f3, f3_2, f3_3, f4, f5, f5_2, f6, f6_2, f7; its vertices w1, v2, w2, w3, v0, w4, v1, w5, v3, w6, w7, w8, v5, v6, w9, v7, w10
  [3]
  $ scc fmt union.sc | head -n 1
  compound C = decompose "crossing.off" union mass 1
  $ scc translate --to xml union.sc | grep '<mesh'
      <mesh file="crossing.off" union="true"/>

Two cubes that share a face are one box. Cubes with an edge in common are not connected:

  $ sed '11,18{s/ 1 / 0 /;t;s/ 2 / 1 /}' edge.off > face.off
  $ echo 'shape Box = mesh "face.off" union' > box.sc; scc shape box.sc:Box | head -n 3
  box.sc:Box
  vertices: 8, edges: 12, faces: 6
  names of faces: f2, f0, f4, f1, f5, f9
  $ echo 'shape Box = mesh "edge.off" union' > box.sc; scc check box.sc
  box.sc:1:18: error[SC0307]: the union of what is in the mesh `edge.off` is not convex
     |
   1 | shape Box = mesh "edge.off" union
     |                  ^^^^^^^^^^
    hint: a compound = decompose "file" union cuts it into convex parts
  [3]
  $ echo 'compound C = decompose "edge.off" union mass 1' > edge.sc; scc check edge.sc
  edge.sc:1:24: error[SC0310]: the union of the solids is in 2 pieces that are not connected by areas
     |
   1 | compound C = decompose "edge.off" union mass 1
     |                        ^^^^^^^^^^
    hint: each needs a compound of its own: `scc decompose --union` with -o writes them
  [3]

So do triangles of faces that are not flat, with a warning:

  $ echo 'compound C = decompose "bent_lid.off" mass 1' > lid.sc; scc check lid.sc 2>&1 | grep SC0323
  lid.sc:1:24: warning[SC0323]: triangles: 1 face was not planar, with corners up to 0.471 off the plane

Faces that surround nothing, and no faces:

  $ printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n' > flat.off; scc decompose --union flat.off
  error[SC0301]: the faces surround nothing: each is there from both sides
    hint: a sheet bounds no solid: give it a thickness in the program that made it
  [3]
  $ printf 'OFF\n0 0 0\n' > empty.off; scc decompose --union empty.off
  empty.off:1:1: error[SC0320]: the file has no faces and no points
     |
   1 | OFF
     | ^
  [3]

A model says the same of a mesh, in its own words:

  $ printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' > sheet.off
  $ told() {
  >   printf '%s\nprocess p = B %s velocity (1, 0, 0) [nil]\n' "$1" "$2" > told.sc
  >   scc check told.sc 2>&1 | grep hint
  > }
  $ for mesh in edge sheet; do
  >   told "shape B = mesh \"$mesh.off\" weld" 'mass 1'; told "compound B = decompose \"$mesh.off\" weld mass 1"
  > done
    hint: solids have an edge in common, from v2 to v6; for all of them: a compound = decompose "file" union
    hint: solids have an edge in common, from v2 to v6; for all of them: write `union` after the file
    hint: all corners are in one plane; a sheet bounds no solid: give it a thickness in the program that made it
    hint: all corners are in one plane; a sheet bounds no solid: give it a thickness in the program that made it

A solid that is inside out, and is no hollow, is refused; `--orient` turns it over. Here the second of two boxes that
overlap:

  $ boxes() { python3 - "$@" <<'END'
  > import sys
  > places, faces = [], []
  > for text in sys.argv[1:]:
  >     low, high = [list(map(int, word)) for word in text.lstrip("-").split(":")]
  >     first = len(places)
  >     places += [[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
  >     for face in [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]:
  >         faces.append([first + k for k in (face[::-1] if text[0] == "-" else face)])
  > print("OFF", len(places), len(faces), 0)
  > for row in places + [[len(face), *face] for face in faces]:
  >     print(*row)
  > END
  > }
  $ boxes 000:222 -100:422 > half.off; scc decompose --union half.off
  error[SC0309]: `f6` and the faces around it are turned inward, and are no hollow: no solid is left around them
    hint: to mend it, add --orient
  [3]
  $ scc decompose --union --orient half.off | head -n 2
  oriented: 6 faces turned over: f6, f7, f8, f9, f10, f11
  half.off: 6 plane faces, 0 reflex edges, volume 16
  $ echo 'compound C = decompose "half.off" union mass 1' > half.sc; scc check half.sc 2>&1 | grep -v '|'
  half.sc:1:24: error[SC0309]: `f6` and the faces around it are turned inward, and are no hollow: no solid is left around them
    hint: write `orient` after the file: faces are turned over so that all look out of the solid
  $ echo 'shape C = mesh "half.off" union' > half.sc; scc check half.sc 2>&1 | grep -v '|'
  half.sc:1:16: error[SC0309]: `f6` and the faces around it are turned inward, and are no hollow: no solid is left around them
    hint: write `orient` after the file: faces are turned over so that all look out of the solid
  $ boxes -000:111 500:611 > lone.off; scc decompose --union lone.off 2>&1 | head -n 1
  error[SC0309]: `f0` and the faces around it are turned inward, and are no hollow: no solid is left around them

Two hollows may overlap. One within a solid stays one, also where both touch:

  $ boxes 000:444 -111:332 -112:333 -122:233 > hollows.off; scc decompose --union hollows.off | head -n 1
  hollows.off: 12 plane faces, 12 reflex edges, volume 56
  $ boxes 000:444 -111:334 > open.off; scc decompose --union open.off | head -n 1
  open.off: 11 plane faces, 8 reflex edges, volume 52
  $ for more in '' --weld; do scc decompose --union --orient $more open.off | grep -e oriented -e volume | head -n 2; done
  oriented: no face had to be turned over; within other pieces, and so hollows: the pieces of f6
  open.off: 11 plane faces, 8 reflex edges, volume 52
  oriented: no face had to be turned over; within other pieces, and so hollows: the pieces of f6
  open.off: 11 plane faces, 8 reflex edges, volume 52

Faces are there from both sides; `--weld` takes one of both:

  $ boxes 000:111 -000:111 > sides.off; scc decompose --union sides.off 2>&1 | tail -n 1
    hint: to mend it, add --weld: each face is there from both sides
  $ scc decompose --union --weld sides.off | sed -n 2p
  sides.off: 6 plane faces, 0 reflex edges, volume 1

Two boxes that share a face, one of them inside out, need no welding, and stay two boxes with it:

  $ boxes 000:111 -100:211 > shared.off; scc decompose shared.off 2>&1 | tail -n 1
    hint: each of several pieces is closed; for all of them: scc decompose --union --orient
  $ scc shape shared.off | tail -n 1
  each of several pieces is closed; for all of them: scc decompose --union --orient
  $ for more in '' --weld; do scc decompose --union --orient $more shared.off | grep 'edges, volume'; done
  shared.off: 6 plane faces, 0 reflex edges, volume 2
  shared.off: 6 plane faces, 0 reflex edges, volume 2
  $ scc decompose --weld shared.off 2>&1 | tail -n 1
    hint: as they are in the file, each of several pieces is closed; for all of them: scc decompose --union --orient

A solid of two heights: corners of one face are within edges of another one, and stay corners. `--merge` puts them
there, and `--orient` comes after that:

  $ sed 's/  /\n/g' > step.off <<'END'
  > OFF  14 10 0
  > 0 0 0  1 0 0  2 0 0  2 1 0  1 1 0  0 1 0  1 0 1  2 0 1  2 1 1  1 1 1  0 0 2  1 0 2  1 1 2  0 1 2
  > 6 5 4 3 2 1 0  4 0 1 11 10  4 1 2 7 6  4 2 3 8 7  4 7 8 9 6  4 6 9 12 11  4 10 11 12 13  4 5 13 12 4
  > 4 4 9 8 3  4 0 10 13 5
  > END
  $ scc decompose step.off 2>&1 | tail -n 1
    hint: to mend it, add --merge
  $ scc decompose --merge step.off | head -n 2
  merged: 10 faces became 8; 2 faces took in corners of others
  step.off: 8 plane faces, 1 reflex edge, volume 3
  $ sed 's/4 2 3 8 7/4 7 8 3 2/; s/4 0 1 11 10/4 10 11 1 0/' step.off > over.off
  $ scc decompose --merge --orient over.off | head -n 3
  oriented: 2 faces turned over: f1, f3
  merged: 10 faces became 8; 2 faces took in corners of others
  over.off: 8 plane faces, 1 reflex edge, volume 3
  $ echo 'compound C = decompose "over.off" orient merge mass 1  process p = C at translate (0,0,0) [nil]' > step.sc
  $ scc check step.sc | tail -n 1
  no properties to check
