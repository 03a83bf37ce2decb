Whatever the input, scc ends soon, in bounded memory, with a located error, its code and exit 3.

  $ cat > cube.sc <<'END'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > process p = Cube mass 1 [nil]
  > END
  $ repeat() { head -c "$2" /dev/zero | sed "s/\x0/$1/g"; }
  $ scc() { timeout 600 scc "$@"; }

Files.

  $ scc check nowhere.sc
  nowhere.sc: error[SC0101]: cannot read: No such file or directory
  [3]
  $ scc check .
  .: error[SC0101]: cannot read: it is a directory
  [3]
  $ scc check /dev/null
  /dev/null:1:1: error[SC0112]: this model declares nothing
     |
   1 | 
     | ^
    hint: a model declares at least one `process`
  [3]
  $ scc check cube.sc/inside
  cube.sc/inside: error[SC0101]: cannot read: Not a directory
  [3]
  $ head -c 1000 /dev/zero > zeros.sc
  $ scc check zeros.sc 2>&1 | head -n 1
  zeros.sc:1:1: error[SC0102]: this is not text: it holds the control character U+0000
  $ scc check /dev/zero
  /dev/zero: error[SC0101]: cannot read: it is larger than 64 MiB
  [3]
  $ scc view cube.sc --trace /dev/zero
  /dev/zero: error[SC0101]: cannot read: it is larger than 64 MiB
    hint: `scc trace --states=ends` writes no states between the first and the last one: such a trace is small
  [3]
  $ scc view cube.sc --trace missing.jsonl
  missing.jsonl: error[SC0101]: cannot read: No such file or directory
  [3]
  $ touch unreadable; mkdir folder
  $ scc check cube.sc --witness unreadable
  unreadable: error[SC0103]: cannot make the folder: it is a file
  semantics 3
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  no properties to check
  [74]
  $ scc check cube.sc --witness nowhere/deep
  nowhere/deep: error[SC0103]: cannot make the folder: No such file or directory
  semantics 3
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  no properties to check
  [74]
  $ scc check cube.sc > /dev/full
  standard output: error[SC0103]: cannot write: No space left on device
  [74]

Deep nesting.

  $ (cat cube.sc; printf 'param x = '; repeat '(' 100000; printf 1; repeat ')' 100000) > parentheses.sc
  $ scc check parentheses.sc 2>&1 | cut -c 1-120
  parentheses.sc:8:1011: error[SC0111]: brackets are nested too deeply (the limit is 1000)
     |
   8 | (((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((
     |                                         ^
  $ (cat cube.sc; printf 'param x = '; repeat '(' 100000) > open.sc
  $ scc check open.sc 2>&1 | cut -c 1-120
  open.sc:8:1011: error[SC0111]: brackets are nested too deeply (the limit is 1000)
     |
   8 | (((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((
     |                                         ^
  $ (cat cube.sc; printf 'param x = '; repeat '-' 100000; printf 1) > minus.sc
  $ scc check minus.sc 2>&1 | cut -c 1-120
  minus.sc:8:10011: error[SC0111]: this declaration goes more than 10000 operators and prefixes deep: a chain is as deep a
     |
   8 | -------------------------------------------------------------------------------------------------------------------
     |                                         ^
  $ (cat cube.sc; printf 'check c : '; repeat 'AG EF ' 501; printf 'x(p) = 0') > operators.sc
  $ scc check operators.sc 2>&1 | head -n 1
  operators.sc:8:11: error[SC0111]: operators of time nest more than 1000 deep, with their `let`s
  $ (cat cube.sc; printf 'behaviour B on Cube = '; repeat 'eps(1). ' 100000; printf nil) > delays.sc
  $ scc check delays.sc 2>&1 | cut -c 1-120
  delays.sc:8:80021: error[SC0111]: this declaration goes more than 10000 operators and prefixes deep: a chain is as deep 
     |
   8 | . eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). eps(1). e
     |                                         ^
  $ (cat cube.sc; printf 'check c : always 1'; repeat '+1' 100000; printf ' > 0') > sum.sc
  $ scc check sum.sc 2>&1 | cut -c 1-120
  sum.sc:8:20017: error[SC0111]: this declaration goes more than 10000 operators and prefixes deep: a chain is as deep as 
     |
   8 | +1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+
     |                                         ^
    hint: brackets around parts of a chain make it less deep: `(a + b) + (c + d)`
  $ part="$(repeat '+1' 999)"
  $ (cat cube.sc; printf 'check c : always (1'; for i in $(seq 1 99); do printf '%s)+(1' "$part"; done; printf '%s) > 0' "$part") > sum.sc
  $ scc check sum.sc 2>&1 | grep '^c:'
  c: holds (exhaustive)
  $ (cat cube.sc; repeat 'for i in 1..2 { ' 100000) > loops.sc
  $ scc check loops.sc 2>&1 | cut -c 1-120 | head -n 4
  loops.sc:8:16015: error[SC0111]: brackets are nested too deeply (the limit is 1000)
     |
   8 | in 1..2 { for i in 1..2 { for i in 1..2 { for i in 1..2 { for i in 1..2 { for i in 1..2 { for i in 1..2 { for i in 
     |                                         ^
  $ repeat '[' 100000 > brackets.json
  $ scc trace cube.sc --schedule brackets.json 2>&1 | cut -c 1-120
  brackets.json:1:1: error[SC0801]: values are nested deeper than 200
     |
   1 | [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[
     | ^

Large numbers, and models that grow.

  $ (cat cube.sc; printf 'param x = '; repeat 7 10000; echo) > digits.sc
  $ scc check digits.sc 2>&1 | cut -c 1-120
  digits.sc:8:11: error[SC0106]: this number has more than 4000 digits when written out
     |
   8 | param x = 777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777
     |           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  $ (cat cube.sc; printf 'param x = '; repeat 7 200000; echo) > more-digits.sc
  $ scc check more-digits.sc 2>&1 | cut -c 1-120
  more-digits.sc:8:11: error[SC0106]: this number has more than 4000 digits when written out
     |
   8 | param x = 777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777777
     |           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  $ (cat cube.sc; echo 'param x = 1e1000000000') > exponent.sc
  $ scc check exponent.sc
  exponent.sc:8:11: error[SC0106]: this number has more than 4000 digits when written out
     |
   8 | param x = 1e1000000000
     |           ^^^^^^^^^^^^
  [3]
  $ scc check cube.sc -D x=1e1000000000 2> /dev/null
  [64]
  $ (cat cube.sc; echo 'param n = 1e9'; echo 'for i in 1..n { process c[i] = Cube mass 1 at translate (3*i,0,0) [nil] }') > many.sc
  $ scc check many.sc
  many.sc:9:1: error[SC0111]: the loops of the model make more than 1000000 declarations
     |
   9 | for i in 1..n { process c[i] = Cube mass 1 at translate (3*i,0,0) [nil] }
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  [3]
  $ (cat cube.sc; echo 'let x0 = 10'; for i in $(seq 1 64); do echo "let x$i = x$((i-1)) * x$((i-1))"; done) > squares.sc
  $ scc check squares.sc 2>&1 | head -n 3 | cut -c 1-120
  squares.sc:27:11: error[SC0106]: this constant is too large (more than 1000000 bits)
      |
   27 | let x19 = x18 * x18

Unterminated things.

  $ (cat cube.sc; echo '/* never closed') > comment.sc
  $ scc check comment.sc
  comment.sc:8:1: error[SC0105]: this comment is not closed
     |
   8 | /* never closed
     | ^^
    hint: close it with `*/`
  [3]
  $ (cat cube.sc; printf 'process q = Cube') > end.sc
  $ scc check end.sc
  end.sc:8:17: error[SC0110]: the text ends here: expected an attribute (`mass`, `velocity`, `spin` or `at`), `scaled`, or the behaviour in square brackets, as in `[nil]`
     |
   8 | process q = Cube
     |                 ^
  [3]

Formulas of the command line that change the direction of the text are warned of, and are shown by the numbers of their characters:

  $ back=$(printf '\342\200\256')
  $ cat > moving.sc <<'EOF'
  > shape C = box(1,1,1)
  > process p = C mass 1 velocity (1,0,0) [nil]
  > EOF
  $ scc export moving.sc --time 1 --observe "x(p) /* $back */" --format csv -o - | tr -d '\r'
  <observable 1>:1:9: warning[SC0113]: the character U+202E on this line changes the direction in which it is shown: what is read may not be what is seen
     |
   1 | x(p) /* <U+202E> */
     |         ^^^^^^^^
    hint: reports of scc show them by their numbers; take them out, or keep them if the text is meant so
  time,time (float),event,x(p) /* <U+202E> */,x(p) /* <U+202E> */ (float)
  0,0,,0,0
  1,1,,1,1
  $ scc estimate moving.sc --property "P = ? [ eventually x(p) > 1 /* $back */ ]" --runs 2
  <property 1>:1:32: warning[SC0113]: the character U+202E on this line changes the direction in which it is shown: what is read may not be what is seen
     |
   1 | P = ? [ eventually x(p) > 1 /* <U+202E> */ ]
     |                                ^^^^^^^^
    hint: reports of scc show them by their numbers; take them out, or keep them if the text is meant so
  property1: estimated: 1, from 0.07071 to 1 with confidence 99/100, 2 runs
  $ scc view moving.sc --plot "x(p) /* $back */" -o page.html 2>&1 | head -1
  --plot x(p) /* <U+202E> */:1:9: warning[SC0113]: the character U+202E on this line changes the direction in which it is shown: what is read may not be what is seen
  $ scc simulate moving.sc --runs 1 --observe "x(p) /* $back */" --every 1 --until 1 --plot plot.svg 2> errors > table.csv
  $ cat errors table.csv plot.svg | grep -c "$back"
  0
  [1]

Names are shown so, too:

  $ escape=$(printf '\033')
  $ scc "$back$escape[31m" 2>&1 | head -n 1 | cut -c 1-44
  scc: unknown command '<U+202E><U+001B>[31m',
  $ scc check moving.sc "--$back=$escape" 2>&1 | head -n 1
  scc: unknown option '--<U+202E>'.
  $ printf 'shape  C = box(1,1,1)\nprocess p = C mass 1 [nil]' > "wide$back.sc"
  $ scc fmt --check "wide$back.sc"
  wide<U+202E>.sc
  [1]

A compound or a shape with an `=` before its bracket:

  $ printf 'compound Wall(a) = { part a : box(1,1,1) mass 1 }\n' > braced.sc; scc check braced.sc 2>&1 | grep hint
    hint: a compound has no `=` before `{`, as in `compound Wall { part a : SHAPE mass 1 }`
  $ printf 'for i in 1..2 { let k = i }\nshape Wall(a) = {\n vertices a (0,0,0) }\n' > braced.sc; scc check braced.sc 2>&1 | grep hint
    hint: a shape has no `=` before `{`, as in `shape Cube { vertices … faces … }`

A mass that is missing, after faces and after a file:

  $ faces='vertices a (0,0,0) b (1,0,0) c (0,1,0) d (0,0,1) faces f [a,c,b] g [a,b,d] h [a,d,c] i [b,c,d]'
  $ printf 'compound W = decompose { %s }\nfixed p = W\n' "$faces" > faces.sc; scc check faces.sc 2>&1 | grep hint
    hint: write `mass m` with m > 0 after the faces: its parts share it by their volumes
  $ printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n' > four.off
  $ printf 'compound W = decompose "four.off"\nfixed p = W\n' > file.sc; scc check file.sc 2>&1 | grep hint
    hint: write `mass m` with m > 0 after the file: its parts share it by their volumes

Too many behaviours, one by one and of a family that has no end:

  $ (for i in $(seq 10050); do echo "behaviour B$i = eps(1). B$((i + 1))"; done; echo 'behaviour B10051 = nil'; echo 'process p = box(1,1,1) mass 1 [B1]') > chain.sc
  $ scc check chain.sc 2>&1 | grep 'error\|hint'
  chain.sc:10000:28: error[SC0111]: the model has more than 10000 behaviours: `B10001`
  $ printf 'behaviour K[i] = eps(1). K[i+1]\nprocess p = box(1,1,1) mass 1 [K[0]]\n' > endless.sc
  $ scc check endless.sc 2>&1 | grep 'error\|hint'
  endless.sc:1:26: error[SC0111]: the model has more than 10000 instances of behaviours: `K[10000]`
    hint: a family that asks for an instance of its own with ever other arguments has no end
