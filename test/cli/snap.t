Solids whose decimals are rounded: a triangular prism, turned.

  $ cat > prism.off <<'END'
  > OFF
  > 6 5 0
  > -0.131 0.370 -0.424
  > 0.454 0.101 0.342
  > -0.324 -0.471 0.082
  > 0.455 -0.143 -1.052
  > 1.040 -0.412 -0.286
  > 0.262 -0.983 -0.546
  > 4 0 1 4 3
  > 3 0 2 1
  > 4 0 3 5 2
  > 4 1 2 5 4
  > 3 3 4 5
  > END
  $ scc shape prism.off | head -8
  prism.off
  vertices: 6, edges: 9, faces: 5
  names of faces: f0, f1, f2, f3, f4
  names of vertices: v0, v1, v2, v3, v4, v5
  convex closed polyhedron: no
    error[SC0305]: face f2 is not planar: v5 is off its plane
      hint: if its decimals are rounded and the solid is convex: `snap 1e-5` after a mesh, or scc shape --snap 1e-5, finds an exact one; of other solids, export the faces as triangles
    error[SC0305]: face f3 is not planar: v5 is off its plane
  $ scc shape --snap 1e-3 prism.off -o prism.sc | head -5
  snapped within 0.001: 6 vertices moved, v4 the farthest, by 0.000417; coordinates of at most 72 bits
  prism.off
  vertices: 6, edges: 9, faces: 5
  names of faces: f0, f1, f2, f3, f4
  names of vertices: v0, v1, v2, v3, v4, v5
  $ cat prism.sc
  shape Prism {
    vertices
      v0 (-12198347875/93063446176, 4302341131/11632930772, -19739896777/46531723088)
      v1 (3677843069/8101165728, 102045739/1012645716, 1385558231/4050582864)
      v2 (-29715280633/91756237280, -1080979075/2293905932, 3752670517/45878118640)
      v3 (633488681/1392067616, -24870369/174008452, -732070309/696033808)
      v4 (7391909723/7109191776, -366026051/888648972, -1017782863/3554595888)
      v5 (11505326479/43920415456, -5395715799/5490051932, -11982757427/21960207728)
    faces
      f0 [v0, v1, v4, v3]
      f1 [v0, v2, v1]
      f2 [v0, v3, v5, v2]
      f3 [v1, v2, v5, v4]
      f4 [v3, v4, v5]
  }
  $ scc shape prism.sc:Prism | sed -n 4p
  names of vertices: v0, v1, v2, v3, v4, v5
  $ scc shape --snap 1e-3 prism.off --json | tail -63 | head -20
          "2653353994548453433961062694930011090449564244029960077863566245219045973803268670439522060441383664973664675179602526204502014147678056313622289200509850500745114432038765061945155304886148304/173357116448666330628559768521148826963517620002497507002284087537254776595611678013402749730729294286992518851275793653357775563047288062388971848476112530352519991525165112355138163323409658625"
        ],
        [
          "608545831809439504674468108294736982047426755182214541261458739771254200280690772253256432285724619385995497078385112200684055282661411118316710480021307127634201038567800435609347442657319216/48539992605626572575996735185921671549784933600699301960639544510431337446771269843752769924604202400357905278357222222940177157653240657468912117573311508498705597627046231459438685730554704415",
          "675298644221752619869711858666229840179707618737642751151734878437055115271558518422013147278983017177062545031991683234530180709312758419953056342701325483201392220310072640108471460725236768/5919511293369094216584967705600203847534748000085280726907261525662358225216008517530825600561488097604622594921612466212216726543078128959623428972355062012037268003298320909687644601287159075",
          "-30949678965385214900158943857429315631045734986598451419169691195152507695289505052444621903037046295996318963136422244584900204538609631222173325266539798118076381079389988659395457814329936/2311428219315551075047463580281984359513568266699966760030454500496730354608155706845369996409723923826566918017010582044770340840630507498519624646348167071366933220335534831401842177645462115"
        ],
        [
          "2653353994548453433961062694930011090449564244029960077863566245219045973803268670439522060441383664973664675179602526204502014147678056313622289200509850500745114432038765061945155304886148304/173357116448666330628559768521148826963517620002497507002284087537254776595611678013402749730729294286992518851275793653357775563047288062388971848476112530352519991525165112355138163323409658625",
          "-30949678965385214900158943857429315631045734986598451419169691195152507695289505052444621903037046295996318963136422244584900204538609631222173325266539798118076381079389988659395457814329936/2311428219315551075047463580281984359513568266699966760030454500496730354608155706845369996409723923826566918017010582044770340840630507498519624646348167071366933220335534831401842177645462115",
          "131695880733501228798621122862104758477702988508006320566787222217812402619473267518970761280528477953102168887373723340548567539937268937096246397618507304438204474217257056687983784760576538016/1213499815140664314399918379648041788744623340017482549015988612760783436169281746093819248115105060008947631958930555573504428941331016436722802939332787712467639940676155786485967143263867610375"
        ]
      ]
    },
    "snapped": {
      "distance": "1/1000",
      "moved": [
        {"vertex": "v0", "by": "0.000285"},
        {"vertex": "v1", "by": "0.000238"},
        {"vertex": "v2", "by": "0.000349"},
  $ scc shape --snap 1e-3 prism.off -o exact.off > /dev/null
  $ cat exact.off
  OFF
  6 5 9
  -12198347875/93063446176 4302341131/11632930772 -19739896777/46531723088
  3677843069/8101165728 102045739/1012645716 1385558231/4050582864
  -29715280633/91756237280 -1080979075/2293905932 3752670517/45878118640
  633488681/1392067616 -24870369/174008452 -732070309/696033808
  7391909723/7109191776 -366026051/888648972 -1017782863/3554595888
  11505326479/43920415456 -5395715799/5490051932 -11982757427/21960207728
  4 0 1 4 3
  3 0 2 1
  4 0 3 5 2
  4 1 2 5 4
  3 3 4 5
  $ scc shape --snap 1e-3 exact.off | head -1
  snapped within 0.001: nothing moved, it is exact as it is

How far is told where that is too far, and what else is in the way.

  $ scc shape --snap 1e-6 prism.off
  error[SC0322]: this cannot be snapped: there is no convex solid within 1e-6, as far as is known: the nearest has v1 0.000176 away
    hint: a distance somewhat above 0.000176 might do
  [3]
  $ sed 's/^3 3 4 5$/3 3 5 4/' prism.off > turned.off
  $ scc shape --snap 1e-3 turned.off
  error[SC0322]: this cannot be snapped: no small move of its vertices mends it: face f4 is turned over: it runs the other way round than its neighbours
    hint: reverse the order of the corners of f4: [v3,v4,v5]
  [3]
  $ sed '$d; s/6 5 0/6 4 0/' prism.off > open.off
  $ scc shape --snap 1e-3 open.off
  error[SC0322]: this cannot be snapped: no small move of its vertices mends it: the solid is not closed: edge [v4,v3] belongs to one face only, f0
  [3]
  $ sed 's/^3 0 2 1$/3 0 1 2/; s/^3 3 4 5$/3 3 5 4/; s/^4 0 1 4 3/4 3 4 1 0/; s/^4 0 3 5 2/4 2 5 3 0/; s/^4 1 2 5 4/4 4 5 2 1/' prism.off > inside.off
  $ scc shape --snap 1e-3 inside.off | head -1
  snapped within 0.001: 6 vertices moved, v4 the farthest, by 0.000417; coordinates of at most 72 bits; all faces were turned over, as they were listed clockwise
  $ scc shape --snap 0 prism.off
  scc: the distance of --snap is to be greater than 0
  [64]
  $ scc shape prism.off -o prism.step
  scc: `prism.step' does not tell a format that shapes are written in, by its ending: .off, .obj, .stl, .ply, .sc
  [64]
  $ scc shape prism.off -o never.off > /dev/null
  [3]
  $ ls never.off
  ls: cannot access 'never.off': No such file or directory
  [2]
  $ scc shape exact.off -o nowhere/exact.off > report
  nowhere/exact.off: error[SC0103]: cannot write: No such file or directory
  [74]
  $ grep -c convex report
  2

In a model.

  $ cat > model.sc <<'END'
  > param fine = 1/1000
  > shape P = mesh "prism.off" snap fine scaled (2, 1, 1)
  > process p = P mass 1 [nil]
  > process q = mesh "prism.off" snap fine/2*2 mass 1 at translate (5, 0, 0) [nil]
  > check apart : always distance2(p, q) > 0
  > END
  $ scc check model.sc | head -3
  model.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  semantics 3
  
  apart: holds (exhaustive)
  $ scc fmt model.sc | diff model.sc -
  $ sed 's/snap fine scaled/scaled/' model.sc > unsnapped.sc
  $ scc check unsnapped.sc
  unsnapped.sc:2:16: error[SC0305]: face f2 is not planar: v5 is off its plane
     |
   2 | shape P = mesh "prism.off" scaled (2, 1, 1)
     |                ^^^^^^^^^^^
    hint: if its decimals are rounded and the solid is convex: `snap 1e-5` after a mesh, or scc shape --snap 1e-5, finds an exact one; of other solids, export the faces as triangles
  unsnapped.sc:2:16: error[SC0305]: face f3 is not planar: v5 is off its plane
     |
   2 | shape P = mesh "prism.off" scaled (2, 1, 1)
     |                ^^^^^^^^^^^
    hint: if its decimals are rounded and the solid is convex: `snap 1e-5` after a mesh, or scc shape --snap 1e-5, finds an exact one; of other solids, export the faces as triangles
  [3]
  $ sed 's|1/1000$|1/1000000|' model.sc > near.sc
  $ scc check near.sc
  near.sc:2:16: error[SC0322]: the mesh `prism.off` cannot be snapped: there is no convex solid within 1e-6, as far as is known: the nearest has v1 0.000176 away
     |
   2 | shape P = mesh "prism.off" snap fine scaled (2, 1, 1)
     |                ^^^^^^^^^^^
    hint: a distance somewhat above 0.000176 might do
  near.sc:4:18: error[SC0322]: the mesh `prism.off` cannot be snapped: there is no convex solid within 1e-6, as far as is known: the nearest has v1 0.000176 away
     |
   4 | process q = mesh "prism.off" snap fine/2*2 mass 1 at translate (5, 0, 0) [nil]
     |                  ^^^^^^^^^^^
    hint: a distance somewhat above 0.000176 might do
  [3]
  $ sed 's|= 1/1000$|= -1|' model.sc > negative.sc
  $ scc check negative.sc
  negative.sc:2:33: error[SC0208]: the distance to snap must be positive, and it is -1
     |
   2 | shape P = mesh "prism.off" snap fine scaled (2, 1, 1)
     |                                 ^^^^
  negative.sc:4:35: error[SC0208]: the distance to snap must be positive, and it is -1
     |
   4 | process q = mesh "prism.off" snap fine/2*2 mass 1 at translate (5, 0, 0) [nil]
     |                                   ^^^^^^^^
  [3]
  $ sed 's/snap fine scaled/snip fine scaled/' model.sc > snip.sc
  $ scc check snip.sc
  snip.sc:2:28: error[SC0110]: `snip` does not fit here: expected `grid`, `weld`, `orient`, `merge`, `snap`, `union` (in this order), `scaled`, an attribute, or the next declaration
     |
   2 | shape P = mesh "prism.off" snip fine scaled (2, 1, 1)
     |                            ^^^^
    hint: did you mean `snap`?
  [3]
  $ sed 's/snap fine scaled/snap scaled/' model.sc > without.sc
  $ scc check without.sc
  without.sc:2:33: error[SC0110]: `scaled` does not fit here: expected a number: how far vertices may be moved, as in `snap 1e-5`
     |
   2 | shape P = mesh "prism.off" snap scaled (2, 1, 1)
     |                                 ^^^^^^
    hint: `scaled` is a word of the language and cannot be a name
  [3]

Names of groups become names of faces, and an unknown name lists those that there are.

  $ cat > wedge.obj <<'END'
  > o Wedge
  > v 0 0 0
  > v 2 0 0
  > v 0 2 0
  > v 0 0 2
  > v 2 0 2
  > v 0 2 2
  > g floor
  > f 1 3 2
  > g lid.top
  > f 4 5 6
  > g 2
  > f 1 2 5 4
  > g slope
  > f 2 3 6 5
  > f 3 1 4 6
  > END
  $ scc shape wedge.obj | sed -n 3,4p
  names of faces: floor, lid_top, g2, slope0, slope1
  names of vertices: v0, v1, v2, v3, v4, v5
  $ scc shape wedge.obj -o again.obj > /dev/null && scc shape again.obj | sed -n 3,4p
  names of faces: floor, lid_top, g2, slope0, slope1
  names of vertices: v0, v1, v2, v3, v4, v5
  $ cat > dock.sc <<'END'
  > shape Wedge = mesh "wedge.obj"
  > behaviour A = <dock, {flor}>. nil
  > process w = Wedge mass 1 [A]
  > END
  $ scc check dock.sc
  dock.sc:2:23: error[SC0203]: `Wedge` has no feature `flor`
     |
   2 | behaviour A = <dock, {flor}>. nil
     |                       ^^^^
  note: its faces are floor, lid_top, g2, slope0, slope1; its vertices v0, v1, v2, v3, v4, v5
    hint: did you mean `floor`?
  [3]

The hull of points, exactly; which of them are in one plane is decided by their decimals as written.

  $ cat > cloud.off <<'END'
  > OFF
  > 11 0 0
  > 0 0 0
  > 1 0 0
  > 0 1 0
  > 1 1 0
  > 0 0 1
  > 1 0 1
  > 0 1 1
  > 1 1 1
  > 0.5 0.5 0.5
  > 0.5 0.5 1
  > 1 1 0.5
  > END
  $ scc shape --hull cloud.off -o cube.sc | head -5
  cloud.off
  vertices: 8, edges: 12, faces: 6
  names of faces: f0, f1, f2, f3, f4, f5
  names of vertices: v0, v1, v2, v3, v4, v5, v6, v7
  convex closed polyhedron: yes
  $ cat cube.sc
  shape Cube {
    vertices
      v0 (0, 0, 0)
      v1 (1, 0, 0)
      v2 (0, 1, 0)
      v3 (1, 1, 0)
      v4 (0, 0, 1)
      v5 (1, 0, 1)
      v6 (0, 1, 1)
      v7 (1, 1, 1)
    faces
      f0 [v0, v1, v5, v4]
      f1 [v0, v2, v3, v1]
      f2 [v0, v4, v6, v2]
      f3 [v1, v3, v7, v5]
      f4 [v2, v6, v7, v3]
      f5 [v4, v5, v7, v6]
  }
  $ scc shape cloud.off | head -5
  cloud.off
  vertices: 11, edges: 0, faces: 0
  names of faces: none
  names of vertices: v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10
  convex closed polyhedron: no
  $ printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n' > flat.obj
  $ scc shape --hull flat.obj
  error[SC0301]: all points are in one plane: they span no solid
  [3]

Of rounded points faces are bent: the hull of a dodecahedron in five decimals has triangles, until it is snapped.

  $ cat > points.obj <<'END'
  > v -0.20000 -0.52000 -1.64000
  > v -0.20000 -1.72000 -0.04000
  > v -1.40000 0.76000 -0.68000
  > v -1.40000 -0.44000 0.92000
  > v 1.40000 0.44000 -0.92000
  > v 1.40000 -0.76000 0.68000
  > v 0.20000 1.72000 0.04000
  > v 0.20000 0.52000 1.64000
  > v 0.37082 0.57528 -1.59108
  > v 0.47639 -1.33220 -0.99915
  > v -1.29443 -0.40584 -1.07692
  > v 0.37082 -1.36636 0.99777
  > v -1.46525 0.73889 0.55416
  > v -1.29443 -1.14748 -0.08807
  > v -0.37082 1.36636 -0.99777
  > v 1.46525 -0.73889 -0.55416
  > v 1.29443 1.14748 0.08807
  > v -0.37082 -0.57528 1.59108
  > v -0.47639 1.33220 0.99915
  > v 1.29443 0.40584 1.07692
  > v 0.1 0.2 0.3
  > END
  $ scc shape --hull points.obj | sed -n 2p
  vertices: 20, edges: 54, faces: 36
  $ scc shape --hull --snap 1e-5 points.obj -o dodecahedron.sc | sed -n '1,2p;5p'
  snapped within 0.00001: 20 vertices moved, v13 the farthest, by 7.09e-6; coordinates of at most 106 bits
  points.obj
  names of vertices: v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10, v11, v12, v13, v14, v15, v16, v17, v18, v19
  $ grep -c ' f[0-9]* \[\([^,]*,\)\{4\}[^,]*\]' dodecahedron.sc
  12
  $ scc shape dodecahedron.sc:Dodecahedron | sed -n 2p
  vertices: 20, edges: 30, faces: 12
  $ scc shape --hull --snap 2 points.obj | head -1
  snapped within 2: nothing moved, it is exact as it is; without 12 vertices of the hull
  $ printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n' > corner.obj
  $ scc shape --hull --snap 1e-5 corner.obj | head -1
  snapped within 0.00001: nothing moved, it is exact as it is
  $ scc shape --hull --snap 1 corner.obj
  error[SC0322]: the hull cannot be snapped: the faces that are flat within that distance bound no solid
    hint: without --snap the hull is exact as it is, with more faces; a smaller distance merges fewer of them
  [3]

A solid with fewer faces around the hull, and how far it goes beyond; no fewer than a cube of six has.

  $ scc shape --hull --faces 12 points.obj -o around.sc | sed -n '1,3p;6p'
  simplified: 12 faces for 36 of the hull, which is inside, and beyond it by at most 0.00006495
  points.obj
  vertices: 20, edges: 30, faces: 12
  convex closed polyhedron: yes
  $ scc shape --hull --faces 12 --json points.obj | grep simplified
    "simplified": {"faces_of_hull": 36, "beyond": "1169969529959/18014398509481984"},
  $ scc shape --hull --faces 40 points.obj | head -1
  the hull has 36 faces
  $ scc shape --hull --faces 5 cube.sc:Cube
  error[SC0370]: no solid around the hull was found with so few of its faces
    hint: --faces 6 is enough
  [3]

Its numbers may be long. What takes more than 400 bytes is rounded in the text, and exact in JSON.

  $ longest() { awk '{ if (length($0) > n) n = length($0) } END { print n }'; }
  $ seq 0 119 | awk '{t = $1 * 2.399963; z = 1 - (2 * $1 + 1) / 120; r = sqrt(1 - z * z)
  >   printf "%.6f %.6f %.6f\n", r * cos(t), r * sin(t), z}' > ball.xyz
  $ scc shape --hull --faces 30 ball.xyz | tail -n +5 | longest
  219
  $ scc shape --hull --faces 30 ball.xyz | sed -n '/^volume/,$p' | sed 's/[0-9.]*[0-9]/N/g' | sort -u
    about (-N, N, N)
    about (N, N, -N)
    about (N, N, N)
  centroid: about (-N, -N, -N)
  inertia about the centroid, density N:
  inertia about the centroid, mass N:
  volume: about N
  $ scc shape --hull --faces 30 --json ball.xyz | grep -c '"[0-9]\{500\}[0-9]*/[0-9]\{500\}[0-9]*"'
  15
  $ scc shape --hull --faces 30 ball.xyz --svg ball.svg > ball.out; grep -o 'volume [^<]*' ball.svg
  volume about 4.42383.

Of an XYZ file, which has points alone.

  $ printf "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n.1 .1 .1 9\n" > scan.xyz
  $ scc shape scan.xyz | sed -n '2p;5,7p'
  vertices: 5, edges: 0, faces: 0
  convex closed polyhedron: no
    error[SC0301]: there is no face, so no solid is enclosed
      hint: of points alone scc shape --hull makes a solid, their convex hull
  $ scc shape --hull scan.xyz | sed -n '2p;5p'
  vertices: 4, edges: 6, faces: 4
  convex closed polyhedron: yes
