From drawings to solids.

  $ cat > ring.pbm <<'END'
  > P1
  > 7 5
  > 0 1 1 1 1 1 0
  > 1 1 1 1 1 1 1
  > 1 1 0 0 1 1 1
  > 1 1 1 1 1 1 1
  > 0 1 1 1 1 1 0
  > END
  $ scc inflate ring.pbm --faces 60 -o ring.obj
  ring.pbm: 7 x 5 pixels, of which the shape has 29, with 1 hole
  inflated: highest 3.285 pixels (diffused, radius 2)
    no height is farther than 0.001866 pixels from that of the exact solution
  solid: 30 vertices, 60 faces
    simplified: heights change by at most 1.832 pixels, the outline by at most 0.7891
  $ grep -c '^f' ring.obj
  60
  $ scc inflate ring.pbm --faces all --profile round --scale 1/10 -o ring.off | tail -2
    no height is farther than 0.001745 pixels from that of the exact solution
  solid: 88 vertices, 176 faces
  $ sed -n '2,4p' ring.off
  88 176 264
  -0.2 0.2 0.178125
  -0.2 0.25 0

One pixel, as a template for a model; the solid is convex, and so it can be one.

  $ echo 'P1 1 1 1' > dot.pbm
  $ scc inflate dot.pbm -o dot.sc
  dot.pbm: 1 x 1 pixels, of which the shape has 1
  inflated: highest 1 pixels (diffused, radius 1)
    no height is farther than 9.095e-13 pixels from that of the exact solution
  solid: 6 vertices, 8 faces
  $ cat dot.sc
  shape Dot {
    vertices
      v0 (0, 0, 1)
      v1 (0, 1/2, 0)
      v2 (-1/2, 0, 0)
      v3 (1/2, 0, 0)
      v4 (0, -1/2, 0)
      v5 (0, 0, -1)
    faces
      f0 [v0, v1, v2]
      f1 [v0, v3, v1]
      f2 [v0, v2, v4]
      f3 [v0, v4, v3]
      f4 [v5, v2, v1]
      f5 [v5, v1, v3]
      f6 [v5, v4, v2]
      f7 [v5, v3, v4]
  }
  $ scc shape dot.sc:Dot | sed -n 1,5p
  dot.sc:Dot
  vertices: 6, edges: 12, faces: 8
  names of faces: f0, f1, f2, f3, f4, f5, f6, f7
  names of vertices: v0, v1, v2, v3, v4, v5
  convex closed polyhedron: yes

Strengths of colours, and by how dark a pixel is.

  $ printf 'P3 5 1 255 0 0 0 0 0 0 255 0 0 0 0 0 0 0 0' > red.ppm
  $ heights() { scc inflate red.ppm --faces all -o red.obj "$@" > out || cat out; grep '^v' red.obj | cut -d' ' -f4 | grep -v '^0$' | grep -v - | xargs; }
  $ heights
  1.4609375 1.84765625 1.921875 1.84765625 1.4609375
  $ heights --strength 1/2
  0.73046875 0.921875 0.9609375 0.921875 0.73046875
  $ heights --strength '#ff0000=3'
  1.6171875 2.4609375 4.23046875 2.4609375 1.6171875
  $ heights --strength 0 --strength '#ff0000=3'
  0.23046875 0.921875 3.4609375 0.921875 0.23046875
  $ heights --shaded
  1.4375 1.7421875 1.5390625 1.7421875 1.4375

A drawing in SVG, on whose pieces one may insist; what is wrong is told where it is.

  $ cat > two.svg <<'END'
  > <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">
  >   <circle cx="5" cy="5" r="4"/>
  >   <rect x="12" y="2" width="4" height="4"/>
  > </svg>
  > END
  $ scc inflate two.svg --resolution 20
  two.svg:1:1: error[SC0344]: the drawing is in 2 pieces (1: 52 pixels from column 4, row 2 on, 2: 16 pixels from column 13, row 3 on)
     |
   1 | <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">
     | ^
    hint: --piece 1 takes the largest one, --pieces apart all of them, and --pieces plate puts them on a plate; pixels that only touch at a corner do not hang together
  [3]
  $ scc inflate two.svg --resolution 20 --piece 3
  two.svg:1:1: error[SC0344]: there is no such piece: the drawing has 2 (1: 52 pixels from column 4, row 2 on, 2: 16 pixels from column 13, row 3 on)
     |
   1 | <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">
     | ^
  [3]
  $ scc inflate two.svg --resolution 20 --piece 2
  two.svg: 20 x 10 pixels, of which the shape has 16
  inflated: highest 3.332 pixels (diffused, radius 2)
    no height is farther than 0.001303 pixels from that of the exact solution
  solid: 48 vertices, 92 faces
  $ sed 's/<rect /<rect stroke="red" stroke-width="2" fill="none" /' two.svg > stroke.svg
  $ scc inflate stroke.svg --resolution 20 --piece 2
  stroke.svg: 20 x 10 pixels, of which the shape has 32, with 1 hole
  inflated: highest 3.77 pixels (diffused, radius 1.418)
    no height is farther than 0.001635 pixels from that of the exact solution
  solid: 96 vertices, 192 faces
  $ sed 's/<rect .*/<text>A<\/text>/' two.svg > text.svg
  $ scc inflate text.svg
  text.svg:3:3: error[SC0341]: this is not read: the element "text": turn the text into paths (in Inkscape: Path, Object to Path)
     |
   3 |   <text>A</text>
     |   ^^^^^
    hint: shapes with fills and strokes are read, in groups and where they are used, with transforms and clip paths
  [3]
  $ sed 's/"4"/"four"/' two.svg > four.svg
  $ scc inflate four.svg
  four.svg:2:3: error[SC0340]: a fault in the drawing: a number is missing at "four"
     |
   2 |   <circle cx="5" cy="5" r="four"/>
     |   ^^^^^^^
  [3]

Programs in a drawing are not run, and a size that is too large for a drawing is told with one that is not.

  $ sed 's/<circle/<script>a()<\/script><circle/' two.svg > program.svg
  $ scc inflate program.svg --resolution 20 --piece 1 2>&1 | head -1
  program.svg:2:3: warning[SC0324]: programs in the drawing are not run: what they would change is left out
  $ scc inflate two.svg --resolution 2000
  two.svg:1:1: error[SC0342]: the picture has 2000 x 1000 pixels, which are too many
     |
   1 | <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">
     | ^
    hint: give `--resolution 512`, or less: at most 262144 pixels, and no side longer than 2048
  [3]
  $ scc inflate program.svg --resolution 20 --piece 1 --json 2> err | grep SC0324
        "code": "SC0324",

All pieces: as several surfaces, each in a file of its own, on a plate, or each as a template.

  $ scc inflate two.svg --resolution 20 --pieces apart --faces all -o all.off
  two.svg: 20 x 10 pixels, of which the shape has 68
  inflated: highest 5.395 pixels (diffused, radius 3.609)
    no height is farther than 0.001823 pixels from that of the exact solution
  pieces: 2
  solid: 184 vertices, 360 faces
  $ scc inflate two.svg --resolution 20 --pieces each -o each.obj | tail -2
  solid: 104 vertices, 200 faces
    simplified: heights change by at most 0.7188 pixels, the outline by at most 0
  $ grep -c '^f' each-1.obj each-2.obj
  each-1.obj:152
  each-2.obj:48
  $ scc inflate two.svg --resolution 20 --pieces plate=1/2 --faces all -o plate.off
  two.svg: 20 x 10 pixels, of which the shape has 68
  inflated: highest 5.895 pixels (diffused, radius 3.609)
    no height is farther than 0.001823 pixels from that of the exact solution
  solid: 518 vertices, 1032 faces
  $ scc decompose plate.off | head -1
  plate.off: 310 plane faces, 144 reflex edges, volume 38485/64
  $ scc inflate two.svg --resolution 20 --pieces apart --faces 60 -o both.sc | grep solid
  solid: 34 vertices, 60 faces
  $ grep -E '^(shape|compound)' both.sc
  shape Both_1 {
  shape Both_2 {
  $ scc inflate two.svg --pieces each --faces 12
  two.svg:1:1: error[SC0345]: the drawing cannot be had with so few faces
     |
   1 | <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">
     | ^
    hint: allow more, at least --faces 16, or all of them: --faces all
  [3]
  $ scc inflate two.svg --pieces plate=70000
  two.svg:1:1: error[SC0345]: with these strengths it would be higher than 65536 pixels
     |
   1 | <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">
     | ^
    hint: choose smaller strengths, and --scale to make all of it larger
  [3]
  $ scc inflate two.svg --pieces each --piece 1
  scc: --piece takes one piece, and --pieces all of them: give one of the two
  Usage: scc inflate [OPTION]… ICON
  Try 'scc inflate --help' or 'scc --help' for more information.
  [64]
  $ scc inflate two.svg --pieces some
  scc: option '--pieces': `some' is none of one, apart, each, plate and
       plate=HEIGHT
  Usage: scc inflate [OPTION]… ICON
  Try 'scc inflate --help' or 'scc --help' for more information.
  [64]

An icon as sets have them: a style sheet, strokes with round caps, a part that is used twice, a clip.

  $ cat > icon.svg <<'END'
  > <svg xmlns="http://www.w3.org/2000/svg" width="24" height="24" viewBox="0 0 24 24">
  >   <style>.pen { fill: none; stroke: currentColor; stroke-width: 2; stroke-linecap: round }</style>
  >   <defs>
  >     <path id="wing" d="M12 12c3-6 8-6 8-1s-5 5-8 1"/>
  >     <clipPath id="above"><path d="M0 0h24v18H0z"/></clipPath>
  >   </defs>
  >   <g class="pen" clip-path="url(#above)">
  >     <use href="#wing"/>
  >     <use href="#wing" transform="matrix(-1 0 0 1 24 0)"/>
  >     <line x1="12" y1="12" x2="12" y2="23"/>
  >   </g>
  > </svg>
  > END
  $ scc inflate icon.svg --resolution 48
  icon.svg: 48 x 48 pixels, of which the shape has 402, with 2 holes
  inflated: highest 7.574 pixels (diffused, radius 3.609)
    no height is farther than 0.001951 pixels from that of the exact solution
  solid: 97 vertices, 198 faces
    simplified: heights change by at most 2.664 pixels, the outline by at most 0.7109

What cannot be inflated.

  $ echo 'P1 2 1 0 0' > empty.pbm
  $ scc inflate empty.pbm
  empty.pbm: error[SC0343]: nothing is drawn here: no pixel differs from the background
    hint: a pixel is of the shape when it is opaque, in a picture with transparency, and otherwise when it is far from white; --background tells another colour
  [3]
  $ scc inflate ring.pbm --faces 6
  ring.pbm: error[SC0345]: the drawing cannot be had with so few faces
    hint: allow more, at least --faces 18, or all of them: --faces all
  [3]
  $ scc inflate ring.pbm --strength 0
  ring.pbm: error[SC0345]: all pixels of the shape have the strength 0: it stays flat
    hint: give some colour a strength that is greater than 0
  [3]
  $ scc inflate ring.pbm --strength 1e9
  ring.pbm: error[SC0345]: with these strengths it would be higher than 65536 pixels
    hint: choose smaller strengths, and --scale to make all of it larger
  [3]
  $ scc inflate red.ppm --strength '#00ff00=1'
  red.ppm: error[SC0345]: no pixel of the shape has the colour #00ff00
    hint: it has the colours (with their numbers of pixels) #000000: 4, #ff0000: 1
  [3]
  $ echo 'P5 10000 10000 255' > large.pgm
  $ scc inflate large.pgm
  large.pgm: error[SC0342]: the picture has 10000 x 10000 pixels, which are too many
    hint: make it smaller: at most 262144 pixels, and no side longer than 2048
  [3]
  $ echo 'P5 10 10 255' > short.pgm
  $ scc inflate short.pgm --json
  {
    "format": "scc-diagnostics",
    "version": 1,
    "exit": 3,
    "diagnostics": [
      {
        "code": "SC0340",
        "severity": "error",
        "message": "the Netpbm file ends too early",
        "place": {"file": "short.pgm", "start": {"offset": 0}, "end": {"offset": 0}},
        "notes": [],
        "hint": null
      }
    ]
  }
  [3]
  $ scc inflate ring.off
  ring.off: error[SC0341]: this is no picture that scc reads
    hint: pictures are PNG, Netpbm (PBM, PGM, PPM) and SVG
  [3]
  $ scc inflate nothing.png
  nothing.png: error[SC0101]: cannot read: No such file or directory
  [3]
  $ scc inflate ring.pbm -o missing/ring.obj
  ring.pbm: 7 x 5 pixels, of which the shape has 29, with 1 hole
  inflated: highest 3.285 pixels (diffused, radius 2)
    no height is farther than 0.001866 pixels from that of the exact solution
  solid: 88 vertices, 176 faces
  missing/ring.obj: error[SC0103]: cannot write: No such file or directory
  [74]

Bounds of seconds and of memory:

  $ { echo P1 400 400; yes 1 | head -n 160000; } > square.pbm
  $ scc inflate square.pbm -o square.obj --seconds 0.05
  scc: the limit of 0.05 seconds has passed: nothing was written
  [4]
  $ scc inflate square.pbm -o square.obj --memory 1
  scc: the limit of memory was met: nothing was written
  [4]
