A template of a model, and a polyhedron file.

  $ scc shape ../../specs/models/hexokinase.sc:Post
  ../../specs/models/hexokinase.sc:Post
  vertices: 8, edges: 12, faces: 6
  names of faces: back, front, left, right, bottom, top
  names of vertices: a, b, c, d, e, f, g, h
  convex closed polyhedron: yes
  Definition 4.3, as printed: all seven conditions hold
    1. holds: at least four vertices and four faces
    2. holds: faces name vertices of the set only
    3. holds: the vertices are not collinear
    4. holds: each face is a convex polygon
    5. holds: no two faces are equal up to rotation
    6. holds: angles between neighbouring faces are less than 180 degrees
    7. holds: V - E + F = 2
    (7 with ordered pairs of vertices for edges: 8 - 24 + 6 = -10)
  volume: 4
  centroid: (0, 0, 0)
  inertia about the centroid, density 1:
    (8/3, 0, 0)
    (0, 5/3, 0)
    (0, 0, 5/3)
  inertia about the centroid, mass 1:
    (2/3, 0, 0)
    (0, 5/12, 0)
    (0, 0, 5/12)
  $ cat > tetrahedron.off <<'END'
  > OFF
  > 4 4 6
  > 0 0 0
  > 0.5 0 0
  > 0 1e-1 0
  > 0 0 1
  > 3 0 2 1
  > 3 0 1 3
  > 3 0 3 2
  > 3 1 2 3
  > END
  $ scc shape tetrahedron.off
  tetrahedron.off
  vertices: 4, edges: 6, faces: 4
  names of faces: f0, f1, f2, f3
  names of vertices: v0, v1, v2, v3
  convex closed polyhedron: yes
    warning[SC0312]: the centroid (1/8, 1/40, 1/4) is not the origin of body space (positions and motion are of the centroid)
  Definition 4.3, as printed: all seven conditions hold
    1. holds: at least four vertices and four faces
    2. holds: faces name vertices of the set only
    3. holds: the vertices are not collinear
    4. holds: each face is a convex polygon
    5. holds: no two faces are equal up to rotation
    6. holds: angles between neighbouring faces are less than 180 degrees
    7. holds: V - E + F = 2
    (7 with ordered pairs of vertices for edges: 4 - 12 + 4 = -4)
  volume: 1/120
  centroid: (1/8, 1/40, 1/4)
  inertia about the centroid, density 1:
    (101/320000, 1/192000, 1/19200)
    (1/192000, 1/2560, 1/96000)
    (1/19200, 1/96000, 13/160000)
  inertia about the centroid, mass 1:
    (303/8000, 1/1600, 1/160)
    (1/1600, 3/64, 1/800)
    (1/160, 1/800, 39/4000)
  $ scc shape tetrahedron.off --json
  {
    "format": "scc-shape",
    "version": 1,
    "exit": 0,
    "name": "tetrahedron.off",
    "accepted": true,
    "faults": [],
    "warnings": [
      {
        "code": "SC0312",
        "message": "the centroid (1/8, 1/40, 1/4) is not the origin of body space (positions and motion are of the centroid)"
      }
    ],
    "definition_4_3": {
      "holds": true,
      "conditions": [
        {
          "number": 1,
          "statement": "at least four vertices and four faces",
          "holds": true,
          "witness": null
        },
        {
          "number": 2,
          "statement": "faces name vertices of the set only",
          "holds": true,
          "witness": null
        },
        {
          "number": 3,
          "statement": "the vertices are not collinear",
          "holds": true,
          "witness": null
        },
        {
          "number": 4,
          "statement": "each face is a convex polygon",
          "holds": true,
          "witness": null
        },
        {
          "number": 5,
          "statement": "no two faces are equal up to rotation",
          "holds": true,
          "witness": null
        },
        {
          "number": 6,
          "statement": "angles between neighbouring faces are less than 180 degrees",
          "holds": true,
          "witness": null
        },
        {"number": 7, "statement": "V - E + F = 2", "holds": true, "witness": null}
      ],
      "euler": 2,
      "euler_ordered": -4
    },
    "mass_properties": {
      "volume": "1/120",
      "centroid": ["1/8", "1/40", "1/4"],
      "inertia": [
        ["101/320000", "1/192000", "1/19200"],
        ["1/192000", "1/2560", "1/96000"],
        ["1/19200", "1/96000", "13/160000"]
      ],
      "inertia_of_unit_mass": [
        ["303/8000", "1/1600", "1/160"],
        ["1/1600", "3/64", "1/800"],
        ["1/160", "1/800", "39/4000"]
      ]
    },
    "vertices": [
      {"name": "v0", "position": ["0/1", "0/1", "0/1"]},
      {"name": "v1", "position": ["1/2", "0/1", "0/1"]},
      {"name": "v2", "position": ["0/1", "1/10", "0/1"]},
      {"name": "v3", "position": ["0/1", "0/1", "1/1"]}
    ],
    "faces": [
      {"name": "f0", "corners": ["v0", "v2", "v1"]},
      {"name": "f1", "corners": ["v0", "v1", "v3"]},
      {"name": "f2", "corners": ["v0", "v3", "v2"]},
      {"name": "f3", "corners": ["v1", "v2", "v3"]}
    ],
    "edges": 6,
    "diagnostics": []
  }

What is not accepted is told in both ways, and the exit code is 3.

  $ sed '$d; s/4 4 6/4 3 6/' tetrahedron.off > open.off
  $ scc shape open.off
  open.off
  vertices: 4, edges: 6, faces: 3
  names of faces: f0, f1, f2
  names of vertices: v0, v1, v2, v3
  convex closed polyhedron: no
    error[SC0302]: the solid is not closed: edge [v2,v1] belongs to one face only, f0
    error[SC0302]: the solid is not closed: edge [v1,v3] belongs to one face only, f1
    error[SC0302]: the solid is not closed: edge [v3,v2] belongs to one face only, f2
  Definition 4.3, as printed: not all conditions hold
    1. fails: at least four vertices and four faces
       there are 4 vertices and 3 faces
    2. holds: faces name vertices of the set only
    3. holds: the vertices are not collinear
    4. holds: each face is a convex polygon
    5. holds: no two faces are equal up to rotation
    6. holds: angles between neighbouring faces are less than 180 degrees
    7. fails: V - E + F = 2
       4 - 6 + 3 = 1
    (7 with ordered pairs of vertices for edges: 4 - 9 + 3 = -2)
  [3]
  $ scc shape open.off --json
  {
    "format": "scc-shape",
    "version": 1,
    "exit": 3,
    "name": "open.off",
    "accepted": false,
    "faults": [
      {
        "kind": "open-edge",
        "code": "SC0302",
        "message": "the solid is not closed: edge [v2,v1] belongs to one face only, f0",
        "hint": null
      },
      {
        "kind": "open-edge",
        "code": "SC0302",
        "message": "the solid is not closed: edge [v1,v3] belongs to one face only, f1",
        "hint": null
      },
      {
        "kind": "open-edge",
        "code": "SC0302",
        "message": "the solid is not closed: edge [v3,v2] belongs to one face only, f2",
        "hint": null
      }
    ],
    "warnings": [],
    "definition_4_3": {
      "holds": false,
      "conditions": [
        {
          "number": 1,
          "statement": "at least four vertices and four faces",
          "holds": false,
          "witness": "there are 4 vertices and 3 faces"
        },
        {
          "number": 2,
          "statement": "faces name vertices of the set only",
          "holds": true,
          "witness": null
        },
        {
          "number": 3,
          "statement": "the vertices are not collinear",
          "holds": true,
          "witness": null
        },
        {
          "number": 4,
          "statement": "each face is a convex polygon",
          "holds": true,
          "witness": null
        },
        {
          "number": 5,
          "statement": "no two faces are equal up to rotation",
          "holds": true,
          "witness": null
        },
        {
          "number": 6,
          "statement": "angles between neighbouring faces are less than 180 degrees",
          "holds": true,
          "witness": null
        },
        {
          "number": 7,
          "statement": "V - E + F = 2",
          "holds": false,
          "witness": "4 - 6 + 3 = 1"
        }
      ],
      "euler": 1,
      "euler_ordered": -2
    },
    "mass_properties": null,
    "vertices": [
      {"name": "v0", "position": ["0/1", "0/1", "0/1"]},
      {"name": "v1", "position": ["1/2", "0/1", "0/1"]},
      {"name": "v2", "position": ["0/1", "1/10", "0/1"]},
      {"name": "v3", "position": ["0/1", "0/1", "1/1"]}
    ],
    "faces": [
      {"name": "f0", "corners": ["v0", "v2", "v1"]},
      {"name": "f1", "corners": ["v0", "v1", "v3"]},
      {"name": "f2", "corners": ["v0", "v3", "v2"]}
    ],
    "edges": 6,
    "diagnostics": []
  }
  [3]
  $ scc shape ../../specs/conformance/invalid/SC0307-dent.sc:S | head -n 20
  ../../specs/conformance/invalid/SC0307-dent.sc:S
  vertices: 9, edges: 16, faces: 9
  names of faces: bottom, left, right, front, back, t1, t2, t3, t4
  names of vertices: a, b, c, d, e, f, g, h, t
  convex closed polyhedron: no
    error[SC0307]: the solid is not convex: vertex g is in front of the plane of face t1
    error[SC0307]: the solid is not convex: vertex h is in front of the plane of face t1
    error[SC0307]: the solid is not convex: vertex h is in front of the plane of face t2
    error[SC0307]: the solid is not convex: vertex e is in front of the plane of face t3
  Definition 4.3, as printed: not all conditions hold
    1. holds: at least four vertices and four faces
    2. holds: faces name vertices of the set only
    3. holds: the vertices are not collinear
    4. holds: each face is a convex polygon
    5. holds: no two faces are equal up to rotation
    6. fails: angles between neighbouring faces are less than 180 degrees
       faces t1 and t4 do not meet at an angle of less than 180 degrees at edge [e,t]
    7. holds: V - E + F = 2
    (7 with ordered pairs of vertices for edges: 9 - 32 + 9 = -14)
  for convex parts of it: scc decompose; for its hull: scc shape --hull

Pictures: of what is accepted, and of what is not, with all that is wrong; the report is told even where they
cannot be written.

  $ scc shape ../../specs/models/hexokinase.sc:Cube --svg cube.svg > /dev/null
  $ grep -o '>A convex.*<' cube.svg
  >A convex closed polyhedron: 8 vertices, 12 edges, 6 faces, volume 8.<
  $ sed -n 's/.*<text x="[0-9.]*" y="[0-9.]*">\(.*\)<.text>/\1/p' cube.svg | sort | xargs
  back bottom front left right top
  $ scc shape ../../specs/models/hexokinase.sc:Cube --svg cube.svg --from 0,0,1 --up=-1,0,0 --width 400 > /dev/null
  $ grep -o 'viewBox="0 0 [0-9]*' cube.svg
  viewBox="0 0 400
  $ sed -n 's/.*<text x="[0-9.]*" y="[0-9.]*">\(.*\)<.text>/\1/p' cube.svg | sort | xargs
  back front
  $ scc shape open.off --svg open.svg > /dev/null
  [3]
  $ sed -n 's/.*<title>\(.*\)<.title>/\1/p' open.svg | sort -u
  f0
  f1
  f2
  open.off
  the solid is not closed: edge [v1,v3] belongs to one face only, f1
  the solid is not closed: edge [v2,v1] belongs to one face only, f0
  the solid is not closed: edge [v3,v2] belongs to one face only, f2
  $ scc shape open.off --svg nowhere/open.svg -o nowhere/open.obj 2> err | head -n 1; cat err
  open.off
  nowhere/open.svg: error[SC0103]: cannot write: No such file or directory
  $ scc shape tetrahedron.off --svg nowhere/t.svg -o nowhere/t.obj 2> err | head -n 1; cat err
  tetrahedron.off
  nowhere/t.svg: error[SC0103]: cannot write: No such file or directory
  nowhere/t.obj: error[SC0103]: cannot write: No such file or directory
  $ cp tetrahedron.off "$(printf 'a&b\001\377.off')"
  $ scc shape "$(printf 'a&b\001\377.off')" --svg name.svg > /dev/null
  $ sed -n 2p name.svg
    <title>a&amp;b&lt;U+0001&gt;&lt;0xFF&gt;.off</title>

What cannot be read.

  $ scc shape nowhere.off
  nowhere.off: error[SC0101]: cannot read: No such file or directory
  [3]
  $ scc shape .
  .: error[SC0101]: cannot read: it is a directory
  [3]
  $ scc shape ../../specs/models/hexokinase.sc
  command line: error[SC0210]: ../../specs/models/hexokinase.sc is a model (its templates: Cube, Floor, Post), and a single shape is needed here
    hint: name one of them: ../../specs/models/hexokinase.sc:Cube
  [64]
  $ scc shape ../../specs/models/hexokinase.sc:Nothing
  command line: error[SC0201]: unknown template `Nothing`
  [64]
  $ scc shape ../../specs/models/hexokinase.sc:Enzyme
  command line: error[SC0210]: `Enzyme` is a compound, and a single shape is needed here
    hint: its parts are the shapes to look at
  [64]
  $ scc shape nowhere.sc:Cube --json
  {
    "format": "scc-diagnostics",
    "version": 1,
    "exit": 3,
    "diagnostics": [
      {
        "code": "SC0101",
        "severity": "error",
        "message": "cannot read: No such file or directory",
        "place": {"file": "nowhere.sc", "start": {"offset": 0}, "end": {"offset": 0}},
        "notes": [],
        "hint": null
      }
    ]
  }
  [3]
  $ head -n 5 tetrahedron.off > short.off
  $ scc shape short.off
  short.off:2:1: error[SC0320]: the header promises 4 vertices, but the file has only 3
     |
   2 | 4 4 6
     | ^
  [3]

Made solids are shapes, whether or not the model uses them:

  $ cat > made.sc <<'EOF'
  > shape Cube = box(1, 1, 1)
  > shape Bar(a) = box(a, 1, 1)
  > process p = Cube mass 1 [nil]
  > process q = Bar(2) mass 1 at translate (5, 0, 0) [nil]
  > EOF
  $ for name in Cube 'Bar(2)' 'box(1, 1, 1)' 'box(2, 1, 1)' 'prism(3, 1, 1)'; do scc shape "made.sc:$name" | sed -n 2p; done
  vertices: 8, edges: 12, faces: 6
  vertices: 8, edges: 12, faces: 6
  vertices: 8, edges: 12, faces: 6
  vertices: 8, edges: 12, faces: 6
  vertices: 6, edges: 9, faces: 5

What is advised works, of every model:

  $ for model in ../../specs/models/*.sc; do
  >   advised=$(scc shape $model 2>&1 | sed -n 's/.*hint: name one of them: //p')
  >   [ -z "$advised" ] || scc shape "$advised" > report 2>&1 || { echo "$advised"; cat report; }
  > done
  $ cat > empty.sc <<'EOF'
  > process p = box(1, 1, 1) mass 1 [nil]
  > EOF
  $ scc shape empty.sc
  command line: error[SC0210]: empty.sc is a model (it has no templates), and a single shape is needed here
  [64]

Two boxes side by side share a face; together they are one solid for
decompose with --union:

  $ cat > two.off <<'EOT'
  > OFF
  > 12 12 0
  > 0 0 0
  > 1 0 0
  > 2 0 0
  > 0 1 0
  > 1 1 0
  > 2 1 0
  > 0 0 1
  > 1 0 1
  > 2 0 1
  > 0 1 1
  > 1 1 1
  > 2 1 1
  > 4 0 3 4 1
  > 4 6 7 10 9
  > 4 0 1 7 6
  > 4 3 9 10 4
  > 4 0 6 9 3
  > 4 1 4 10 7
  > 4 1 4 5 2
  > 4 7 8 11 10
  > 4 1 2 8 7
  > 4 4 10 11 5
  > 4 1 7 10 4
  > 4 2 5 11 8
  > EOT
  $ scc shape two.off | grep 'share a face'
  two solids share a face: f5 and f10 have the same corners, in the two directions; for both together: scc decompose --union
  $ scc shape two.off | grep 'to mend it'
  [1]
  $ scc decompose two.off 2>&1 | grep hint
    hint: two solids share a face: f5 and f10 have the same corners, in the two directions; for both together: scc decompose --union
  $ scc decompose --union two.off
  two.off: 6 plane faces, 0 reflex edges, volume 2
  1 convex part, 0 joints, in 1 piece
    p1: 8 corners, 6 faces, volume 2

A wall between them that is there once has to go; the hint names it, also where it is in two pieces:

  $ sed 's/^12 12 0/12 11 0/; /^4 1 7 10 4/d' two.off > wall.off
  $ sed 's/^12 11 0/12 12 0/; s/^4 1 4 10 7/3 1 4 10\n3 1 10 7/' wall.off > walls.off
  $ for f in wall walls; do scc shape $f.off | tail -n 1; scc decompose --union $f.off 2>&1 | grep hint; done
  f5 is a wall within the solid: without it the other faces are closed
    hint: f5 is a wall within the solid: without it the other faces are closed
  f5 and 1 more face are a wall within the solid: without it the other faces are closed
    hint: f5 and 1 more face are a wall within the solid: without it the other faces are closed
  $ sed 's/^12 11 0/12 10 0/; /^4 1 4 10 7/d' wall.off > none.off; scc decompose none.off | tail -n 1
    p1: 8 corners, 6 faces, volume 2

None is named where the other faces stay open:

  $ sed 's/^12 11 0/12 10 0/; /^4 2 5 11 8/d' wall.off > gap.off; scc decompose gap.off 2>&1 | grep 'a wall'
  [1]

What is there twice in one direction goes by --weld:

  $ (sed 's/^12 12 0/12 13 0/' two.off; echo '4 7 10 4 1') > twice.off; scc shape twice.off | grep 'to mend it'
  to mend it: scc shape --weld

No option makes a solid of a sheet, not even of one with a face that is turned over, and none helps one that is there
from both sides:

  $ sheet() { printf 'OFF\n4 %s 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n' "$1"; shift; printf '3 %s\n' "$@"; }
  $ sheet 2 '0 1 2' '0 3 2' > turned.off; sheet 4 '0 1 2' '0 2 3' '0 2 1' '0 3 2' > sides.off
  $ printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2\n3 0 3 2\n' > bent.off
  $ for f in turned sides bent; do scc shape $f.off | tail -n 1; done
  all corners are in one plane; a sheet bounds no solid: give it a thickness in the program that made it
  all corners are in one plane; a sheet bounds no solid: give it a thickness in the program that made it
  to mend it: scc shape --orient
  $ scc decompose turned.off 2>&1 | grep hint
    hint: all corners are in one plane; a sheet bounds no solid: give it a thickness in the program that made it
  $ scc decompose --union sides.off 2>&1 | grep hint
    hint: a sheet bounds no solid: give it a thickness in the program that made it

Closed faces that are turned inward can be mended:

  $ sed 's/^4 \(.*\) \(.*\) \(.*\) \(.*\)$/4 \4 \3 \2 \1/' two.off > inward.off
  $ scc decompose --union inward.off 2>&1 | grep hint
    hint: to mend it, add --orient

A drawing is no mesh:

  $ echo '<svg xmlns="http://www.w3.org/2000/svg"/>' > x.svg
  $ cp x.svg drawing
  $ printf '\211PNG\r\n' > x.png
  $ for file in x.svg drawing x.png; do scc shape $file; done
  x.svg:1:1: error[SC0321]: this is a drawing, and a mesh is needed here
     |
   1 | <svg xmlns="http://www.w3.org/2000/svg"/>
     | ^
    hint: scc inflate makes a solid of a drawing
  drawing:1:1: error[SC0321]: this is a drawing, and a mesh is needed here
     |
   1 | <svg xmlns="http://www.w3.org/2000/svg"/>
     | ^
    hint: scc inflate makes a solid of a drawing
  x.png:1:1: error[SC0321]: this is a drawing, and a mesh is needed here
     |
   1 | <0x89>PNG
     | ^
    hint: scc inflate makes a solid of a drawing
  [3]

A limit of time ends the work, and there is no report then:

  $ awk 'BEGIN { print "OFF"; print "3000 0 0"; srand(1); for (i = 0; i < 3000; i++) { x = rand() - 0.5;
  >   y = rand() - 0.5; printf "%.4f %.4f %.4f\n", x, y, x * x + y * y } }' > bowl.off
  $ scc shape --hull --faces 20 --seconds 0.05 bowl.off
  scc: the limit of 0.05 seconds has passed: nothing was written
  [4]

So does a limit of memory:

  $ scc shape --hull --faces 20 --memory 1 bowl.off
  scc: the limit of memory was met: nothing was written
  [4]
  $ scc shape --hull --faces 20 --memory 1 --json bowl.off 2> err
  {
    "format": "scc-diagnostics",
    "version": 1,
    "exit": 4,
    "stopped": "the limit of memory was met: nothing was written",
    "diagnostics": []
  }
  [4]

A face of a file whose name is a word of the language gets another one, and what is written can be read:

  $ cat > words.obj <<'EOF'
  > v 0 0 0
  > v 1 0 0
  > v 0 1 0
  > v 0 0 1
  > g process
  > f 1 3 2
  > g vertices
  > f 1 2 4
  > g 3x
  > f 1 4 3
  > g mod
  > f 2 3 4
  > EOF
  $ scc shape words.obj -o words.sc > /dev/null && grep '\[' words.sc
      gprocess [v0, v2, v1]
      gvertices [v0, v1, v3]
      g3x [v0, v3, v2]
      mod [v1, v2, v3]
  $ cat > named.sc <<'EOF'
  > shape W = mesh "words.obj"
  > behaviour B on W = <a, {gprocess}>. nil + <b, {gvertices, mod}>. nil
  > process p = W mass 1 [B]
  > check c: possibly offers(p, a)
  > EOF
  $ scc check words.sc 2>&1 | tail -n 1; scc check named.sc 2>&1 | grep holds
  no properties to check
  c: holds (exhaustive)
      offers(p, a) holds
  1 property: 1 holds
