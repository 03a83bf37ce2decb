A model that takes its shapes and behaviours from other files, each relative to the one that imports it:

  $ mkdir -p parts/more
  $ cat > parts/shapes.sc <<EOF
  > import "more/keys.sc" (Key)
  > param edge = 2
  > shape Brick(n) = box(n*edge, edge, edge)
  > behaviour Left  = Key(left)
  > behaviour Right = <dock, {right}>. nil
  > EOF
  $ cat > parts/more/keys.sc <<EOF
  > behaviour Key(f) = <~dock, {f}>. nil
  > EOF
  $ cat > model.sc <<EOF
  > import "parts/shapes.sc"   // the bricks
  > import <solids> (Chamfered as Die)
  > for i in 1..3 if i != 2 { process b[i] = shapes.Brick(i) mass i at translate (9*i, 0, 0) [shapes.Left] }
  > process die = Die(2, 1/4) mass 1 velocity (1, 0, 0) [shapes.Right]
  > for i in 0..1 { check meets : possibly bound(die, b[2*i + 1]) }
  > EOF
  $ scc check model.sc
  semantics 3
  
  meets[0]: holds (exhaustive)
    possibly bound(die, b[1])
    a run that shows it:
      1. time passes by 7, to time 7
      2. b[1] and die collide and bind by <dock, {b[1].left, die.right}>, at time 7
      bound(die, b[1]) holds
      there:
        one process, velocity (1/2, 0, 0), <dock, {b[1].left, die.right}>
          b[1] at (9, 0, 0) [nil]
          die at (7, 0, 0) [nil]
        b[3] at (27, 0, 0) [shapes.Left], velocity (0, 0, 0)
  
  meets[1]: violated
    possibly bound(die, b[3])
    no run shows it: everything that counts was explored
  
  explored: 5 states, 4 transitions, depth 4, model time 35; complete
  2 properties: 1 holds, 1 violated
  [1]
  $ scc check -D shapes.edge=4 model.sc | grep 'to time'
      1. time passes by 6, to time 6
  $ scc check -D edge=4 model.sc
  command line: error[SC0209]: the model has no parameter `edge`
    hint: its parameters: `shapes.edge`
  [64]
  $ scc fmt model.sc
  import "parts/shapes.sc" // the bricks
  import <solids> (Chamfered as Die)
  for i in 1..3 if i != 2 {
    process b[i] = shapes.Brick(i) mass i at translate (9*i, 0, 0) [shapes.Left]
  }
  process die = Die(2, 1/4) mass 1 velocity (1, 0, 0) [shapes.Right]
  for i in 0..1 { check meets : possibly bound(die, b[2*i + 1]) }
  $ scc shape 'model.sc:shapes.Brick(3)' | head -2
  model.sc:shapes.Brick(3)
  vertices: 8, edges: 12, faces: 6
  $ scc shape 'model.sc:Die(2, 1/4)' | head -2
  model.sc:Die(2, 1/4)
  vertices: 24, edges: 48, faces: 26
  $ scc trace --human model.sc | head -4
  time 0
          b[1] at (9, 0, 0) [shapes.Left], velocity (0, 0, 0)
          b[3] at (27, 0, 0) [shapes.Left], velocity (0, 0, 0)
          die at (0, 0, 0) [shapes.Right], velocity (1, 0, 0)

The parameter of a module has the name that reports give it, and those that the model has for it:

  $ sed 's/shapes.sc"/shapes.sc" as s import "parts\/shapes.sc" (edge as length)/; s/shapes\.\([BLR]\)/s.\1/g' model.sc > named.sc
  $ for name in s.edge shapes.edge length; do scc check -D $name=4 named.sc | grep 'to time'; done
      1. time passes by 6, to time 6
      1. time passes by 6, to time 6
      1. time passes by 6, to time 6
  $ scc check -D s.edge=4 -D length=4 --json named.sc | grep -A2 '"parameters"'
    "parameters": {"shapes.edge": "4/1"},
    "settings": {},
    "exit": 1,
  $ scc check -D edge=4 named.sc
  command line: error[SC0209]: the model has no parameter `edge`
    hint: its parameters: `shapes.edge` or `s.edge` or `length`
  [64]
  $ scc check -D s.edg=4 named.sc
  command line: error[SC0209]: the model has no parameter `s.edg`
    hint: did you mean `s.edge`?
  [64]
  $ scc check -D s.edge=4 -D length=5 named.sc
  command line: error[SC0209]: `s.edge` and `length` are one parameter, and have two values
  [64]
  $ scc shape 'named.sc:s.Brick(1)' -D edge=4
  command line: error[SC0209]: the model has no parameter `edge`
    hint: its parameters: `shapes.edge` or `s.edge` or `length`
  [64]
  $ cat > parts/other.sc <<EOF
  > import "../shapes.sc"
  > param twice = 2*shapes.edge
  > EOF
  $ echo 'param edge = 3' > shapes.sc
  $ echo 'import "parts/other.sc" import "parts/shapes.sc" process p = shapes.Brick(1) mass 1 [nil]' > twins.sc
  $ scc check -D shapes.edge=4 twins.sc
  command line: error[SC0209]: `shapes.edge` can be more than one parameter; reports call them `shapes.edge` and `shapes'2.edge`
    hint: call an import otherwise, with `as`
  [64]
  $ rm shapes.sc

Faults are told where they are:

  $ sed -i 's/Key(f)/Key(f, g)/' parts/more/keys.sc
  $ scc check model.sc
  parts/shapes.sc:4:19: error[SC0201]: unknown behaviour `Key(left)`; declared is `Key(_,_)`
     |
   4 | behaviour Left  = Key(left)
     |                   ^^^
  [3]
  $ echo 'process p = Cube mass 1 [nil]' >> parts/more/keys.sc
  $ scc check model.sc
  parts/more/keys.sc:2:1: error[SC0210]: this declaration cannot be imported
     |
   2 | process p = Cube mass 1 [nil]
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    hint: a module declares parameters, lets, shapes, compounds and behaviours; bodies, laws, checks and settings are the model's
  parts/shapes.sc:4:19: error[SC0201]: unknown behaviour `Key(left)`; declared is `Key(_,_)`
     |
   4 | behaviour Left  = Key(left)
     |                   ^^^
  [3]
  $ echo 'import "../shapes.sc"' > parts/more/keys.sc
  $ scc check model.sc
  parts/more/keys.sc:1:8: error[SC0216]: `parts/shapes.sc` imports itself, by `parts/more/keys.sc`
     |
   1 | import "../shapes.sc"
     |        ^^^^^^^^^^^^^^
  parts/shapes.sc:1:24: error[SC0201]: `more/keys.sc` declares no `Key`
     |
   1 | import "more/keys.sc" (Key)
     |                        ^^^
  parts/shapes.sc:4:19: error[SC0201]: unknown behaviour `Key(left)`
     |
   4 | behaviour Left  = Key(left)
     |                   ^^^
  [3]
  $ rm parts/more/keys.sc
  $ scc check model.sc
  parts/shapes.sc:1:8: error[SC0101]: cannot read the import `more/keys.sc`: No such file or directory
     |
   1 | import "more/keys.sc" (Key)
     |        ^^^^^^^^^^^^^^
  parts/shapes.sc:4:19: error[SC0201]: unknown behaviour `Key(left)`
     |
   4 | behaviour Left  = Key(left)
     |                   ^^^
  [3]

Where a model comes as a text, its imports are files of the request, or of the library:

  $ cat > ask.jsonl <<EOF
  > {"jsonrpc": "2.0", "id": 1, "method": "model.load", "params": {"text": "import \"a.sc\" process p = a.A mass 1 [nil]"}}
  > {"jsonrpc": "2.0", "id": 2, "method": "model.load", "params": {"text": "import \"a.sc\" process p = a.A mass 1 [nil]", "files": {"a.sc": "shape A = bix(1, 1, 1)"}}}
  > {"jsonrpc": "2.0", "id": 3, "method": "model.load", "params": {"text": "import \"a.sc\" import <solids> process p = a.A mass 1 [nil]", "files": {"a.sc": "shape A = box(1, 1, 1)"}}}
  > EOF
  $ scc oracle < ask.jsonl | cut -c 1-400
  {"jsonrpc":"2.0","id":1,"error":{"code":-32003,"message":"the model is refused: cannot read the import `a.sc`: it is not among the files of the request","data":{"diagnostics":[{"code":"SC0101","severity":"error","message":"cannot read the import `a.sc`: it is not among the files of the request","place":{"file":"<model>","start":{"offset":7,"line":1,"column":8},"end":{"offset":13,"line":1,"column":
  {"jsonrpc":"2.0","id":2,"error":{"code":-32003,"message":"the model is refused: unknown template `bix(1,1,1)`","data":{"diagnostics":[{"code":"SC0201","severity":"error","message":"unknown template `bix(1,1,1)`","place":{"file":"a.sc","start":{"offset":10,"line":1,"column":11},"end":{"offset":13,"line":1,"column":14}},"notes":[],"hint":"did you mean `box`?"}]}}}
  {"jsonrpc":"2.0","id":3,"result":{"model":"m1","digest":"md5:11c4479b2795fde47c396746b07937bc","name":null,"parameters":{},"settings":{},"rigid":false,"resolution":null,"leaves":[{"name":"p","shape":"a.A","fixed":false}],"checks":[],"warnings":[]}}

A name that an import does not have: one like it, or what it has.

  $ unknown() { printf '%s\nprocess p = %s mass 1 [nil]\n' "$1" "$2" > unknown.sc; scc check unknown.sc 2>&1 | grep 'error\|hint'; }
  $ unknown 'import <solids>' 'solids.Cuboid(1, 1, 1)'
  unknown.sc:2:20: error[SC0201]: unknown template `solids.Cuboid(1,1,1)`
    hint: `solids` has `Chamfered`, `Cube`, `Dodecahedron`, `Icosahedron`, `Octahedron`, `Plank`, `Room`, `Tetrahedron`, `Wedge`
  $ unknown 'import <solids>' 'solids.Cub(1)'
  unknown.sc:2:20: error[SC0201]: unknown template `solids.Cub(1)`
    hint: did you mean `solids.Cube`? `solids` has `Chamfered`, `Cube`, `Dodecahedron`, `Icosahedron`, `Octahedron`, `Plank`, `Room`, `Tetrahedron`, `Wedge`
  $ unknown '' 'solids.Cube(1)'
  unknown.sc:2:13: error[SC0201]: no import is called `solids`
    hint: `import <solids>` is missing
  $ unknown 'import <solids> as s' 's.Cuboid(1, 1, 1)'
  unknown.sc:2:15: error[SC0201]: unknown template `s.Cuboid(1,1,1)`
    hint: `s` has `Chamfered`, `Cube`, `Dodecahedron`, `Icosahedron`, `Octahedron`, `Plank`, `Room`, `Tetrahedron`, `Wedge`

Without the name of the import, and with one that is missing or has a typing error:

  $ printf 'import <solids> as s\nprocess p = Cube(1) mass 1 [nil]\n' > short.sc; scc check short.sc
  short.sc:2:13: error[SC0201]: unknown template `Cube(1)`
     |
   2 | process p = Cube(1) mass 1 [nil]
     |             ^^^^
    hint: did you mean `s.Cube`?
  [3]
  $ printf 'process p = Cube(1) mass 1 [nil]\n' > without.sc; scc check without.sc
  without.sc:1:13: error[SC0201]: unknown template `Cube(1)`
     |
   1 | process p = Cube(1) mass 1 [nil]
     |             ^^^^
    hint: `solids.Cube` is in a module of scc: say `import <solids>`
  [3]
  $ printf 'import <solid>\nprocess p = solid.Cube(1) mass 1 [nil]\n' > typo.sc; scc check typo.sc
  typo.sc:1:9: error[SC0201]: there is no library `solid`; those that there are: solids
     |
   1 | import <solid>
     |         ^^^^^
    hint: did you mean `solids`?
  [3]

A module has no predefined names, whatever stands before; and a text is told of names as it writes them:

  $ printf 'import <solids>\nprocess q = solids.Cube(1) mass 1 [nil]\nprocess p = solids.box(1,1,1) mass 1 at translate (9,0,0) [nil]\n' > leak.sc
  $ scc check leak.sc
  leak.sc:3:20: error[SC0201]: unknown template `solids.box(1,1,1)`
     |
   3 | process p = solids.box(1,1,1) mass 1 at translate (9,0,0) [nil]
     |                    ^^^
    hint: did you mean `box`? It needs no import
  [3]
  $ printf 'shape Cube = box(1,1,1)\nshape Wall(a) = Cub\nbehaviour K on Cube = <a, {topp}>. nil\n' > my-lib.sc
  $ printf 'import "my-lib.sc" as lib\nprocess p = lib.box(1,1,1) mass 1 [nil]\nprocess q = lib.Cube(2) mass 1 [lib.L]\nprocess r = lib.Cube mass 1 [<a, {x}>. nil]\n' > hyphen.sc
  $ scc check hyphen.sc 2>&1 | grep 'error\|hint'
  hyphen.sc:2:17: error[SC0201]: unknown template `lib.box(1,1,1)`
    hint: did you mean `box`? It needs no import
  hyphen.sc:3:17: error[SC0201]: unknown template `lib.Cube(2)`; declared is `lib.Cube`
  hyphen.sc:4:35: error[SC0203]: `lib.Cube` has no feature `x`
    hint: did you mean `a`?
  my-lib.sc:2:17: error[SC0201]: unknown template `Cub`
    hint: did you mean `Cube`?
  my-lib.sc:3:28: error[SC0203]: `Cube` has no feature `topp`
    hint: did you mean `top`?
