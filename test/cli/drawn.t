Solids in models that need not be convex, `compound C = decompose …`. Here it is a chair (the letter L), half as high as its
file says. Its faces are features of the compound, however it is cut: a guest that lands on the seat binds to it, one
that comes down on the back bounces, and a stick binds to the wall behind.

  $ cat > named.py <<'END'
  > lines = open("ell.off").read().split("\n")
  > names = {2: "ground", 4: "seat", 7: "wall"}
  > for line in lines[2:14]:
  >     print("v", line)
  > for i, line in enumerate(lines[14:22]):
  >     print("g", names.get(i, f"side{i}"))
  >     print("f", " ".join(str(int(v) + 1) for v in line.split()[1:]))
  > END
  $ python3 named.py > chair.obj
  $ cat > model.sc <<'END'
  > compound Chair = decompose "chair.obj" scaled (1, 1, 1/2) mass 100
  > behaviour Free on Chair = <sit, {seat}>. Free + <lean, {wall}>. Free
  > process chair = Chair [Free]
  > process guest = box(1/2, 1/2, 1/2) mass 1 velocity (0, 0, -1) at translate (3/2, 1/2, 3) [<~sit, {bottom}>. nil]
  > process tall  = box(1/2, 1/2, 1/2) mass 1 velocity (0, 0, -1) at translate (1/2, 3/2, 2) [<~sit, {bottom}>. nil]
  > process stick = box(1/2, 1/2, 1/2) mass 1 velocity (1, 0, 0) at translate (-2, 1, 1/2) [<~lean, {right}>. nil]
  > check sits   : eventually bound(chair, guest)
  > check height : AG (event bind(sit) => z(guest) - z(chair) = 1/3)
  > check no_back: AG not bound(chair, tall)
  > check bounces: possibly event hit(chair, tall)
  > check leans  : eventually bound(chair, stick)
  > END
  $ scc check model.sc 2>&1 | grep '^[a-z_]*:'
  sits: holds (exhaustive)
  height: holds (exhaustive)
  no_back: holds (exhaustive)
  bounces: holds (exhaustive)
  leans: holds (exhaustive)
  explored: 7 states, 6 transitions, depth 6, model time 91217/40004; complete

Names of vertices, and edges by two of them, are features too; what the file does not have is none, and no guess is made.

  $ scc check - 2>&1 <<'END' | grep -v "^ *$\||"
  > compound Chair = decompose "chair.obj" mass 1
  > behaviour A on Chair = <a, {seat, v3, [v3, v9]}>. nil
  > behaviour B on Chair = <a, {sit}>. nil + <a, {v99}>. nil + <a, {[v0, v3]}>. nil + <a, {cut1}>. nil
  > process p = Chair [A]
  > process q = Chair at translate (9, 0, 0) [B]
  > END
  <standard input>:3:29: error[SC0203]: `Chair` has no feature `sit`
  note: its faces are side0, side1, ground, side3, seat, side5, side6, wall; its vertices v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10, v11
  <standard input>:3:47: error[SC0203]: `Chair` has no feature `v99`
  note: its faces are side0, side1, ground, side3, seat, side5, side6, wall; its vertices v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10, v11
    hint: did you mean `v9`?
  <standard input>:3:65: error[SC0203]: [v0,v3] is no feature of `Chair`
  <standard input>:3:88: error[SC0203]: `Chair` has no feature `cut1`
  note: its faces are side0, side1, ground, side3, seat, side5, side6, wall; its vertices v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10, v11

What is wrong with a file is told where the model names it.

  $ bad() { echo "compound Chair = decompose \"$1\" $2 process p = Chair [nil]" > bad.sc; scc check bad.sc; }
  $ bad nothing.obj 'mass 1'
  bad.sc:1:28: error[SC0101]: cannot read the mesh `nothing.obj`: No such file or directory
     |
   1 | compound Chair = decompose "nothing.obj" mass 1 process p = Chair [nil]
     |                            ^^^^^^^^^^^^^
  [3]
  $ grep -v '^4 5 11 6 0' ell.off | sed 's/^12 8 0/12 7 0/' > open.off; bad open.off 'mass 1' 2>&1 | grep error
  bad.sc:1:28: error[SC0302]: the solid is not closed: edge [v0,v6] belongs to one face only, f2
  bad.sc:1:28: error[SC0302]: the solid is not closed: edge [v5,v0] belongs to one face only, f0
  bad.sc:1:28: error[SC0302]: the solid is not closed: edge [v6,v11] belongs to one face only, f1
  $ bad crossing.off 'mass 1'
  bad.sc:1:28: error[SC0337]: the faces `f0` and `f5` have the point (2, 1, 0) in common, which is at no edge or corner of both
     |
   1 | compound Chair = decompose "crossing.off" mass 1 process p = Chair [nil]
     |                            ^^^^^^^^^^^^^^
    hint: write `union` after the file: solids that overlap, share faces or touch become one
  [3]
  $ bad crossing.off 'scaled (1, 1, 1/2) mass 1' 2>&1 | head -n 1
  bad.sc:1:28: error[SC0337]: the faces `f0` and `f5` have the point (2, 1, 0) in common, which is at no edge or corner of both
  $ sed 's/^\(3 [4567]\) \([4567]\) \([4567]\)$/\1 \3 \2/' hollow.off > outward.off; bad outward.off 'mass 1'
  bad.sc:1:28: error[SC0375]: `f4` and the faces around it are within the solid, but turned outward: those of a hollow look into it
     |
   1 | compound Chair = decompose "outward.off" mass 1 process p = Chair [nil]
     |                            ^^^^^^^^^^^^^
    hint: write `orient` after the file: faces are turned over so that all look out of the solid
  [3]
  $ bad ell.off '' 2>&1 | head -n 1
  bad.sc:1:10: error[SC0208]: this compound has no mass
  $ bad ell.off 'mass 0' 2>&1 | head -n 1
  bad.sc:1:43: error[SC0208]: the mass must be positive, and it is 0
  $ bad ell.off 'scaled (1, 1, 0) mass 1' 2>&1 | head -n 1
  bad.sc:1:28: error[SC0311]: this transformation is singular: it flattens shapes
  $ bad ell.off 'scaled (1, 1, -1) mass 1' 2>&1 | head -n 1
  bad.sc:1:28: error[SC0311]: this transformation is a reflection: it would turn the faces of a shape inside out
  $ bad model.sc 'mass 1' 2>&1 | head -n 1
  model.sc:1:1: error[SC0321]: the format of this mesh file is not known
