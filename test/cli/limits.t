Limits hold for numbers, and each document is there as a whole or not at all.

  $ cat > grow.sc <<'EOF'
  > model grow
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
  > }
  > process p = Cube mass 1 velocity (1,0,0) [nil]
  > motion p = (vx*vx*2, 0, 0)
  > check right : always x(p) >= 0
  > EOF

A number that doubles its length in each step.

  $ scc check grow.sc
  grow.sc: warning[SC0705]: the velocity of `p` takes 131073 bits after 16 transitions, and what follows is not explored
    hint: `round velocity 2^-k`, or `round(e, q)` in a law of motion, keeps numbers short; `--bits N` lets them grow
  semantics 3: timestep 1
  
  right: holds up to the bound: the bound of 100000 bits for a number (a default)
    always x(p) >= 0
  
  explored: 17 states, 16 transitions, depth 16, model time 16; not complete: stopped by the bound of 100000 bits for a number (a default)
    likely cause: the numbers of p grow: its velocity takes 17, 257, 4097 and 131073 bits in the quarters of the deepest run
      cure: `round(e, q)` in the law of motion, or `round velocity 2^-10`, keeps numbers short
    (specs/guide.md, "Why did my model blow up?")
  1 property: 1 holds up to the bound
  [2]
  $ scc check grow.sc --bits 1000 | tail -2
  grow.sc: warning[SC0705]: the velocity of `p` takes 1025 bits after 9 transitions, and what follows is not explored
    hint: `round velocity 2^-k`, or `round(e, q)` in a law of motion, keeps numbers short; `--bits N` lets them grow
  explored: 10 states, 9 transitions, depth 9, model time 9; not complete: stopped by the bound of 1000 bits for a number
  1 property: 1 holds up to the bound
  $ scc check grow.sc --bits 0 2>&1 | head -n 2
  scc: option '--bits': `0' is no number of bits from 1 to 16777216
  Usage: scc check [OPTION]… MODEL
  $ sed 's/vx\*vx\*2/1 + vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx/' grow.sc > wild.sc
  $ scc check wild.sc --bits 16777216 | grep undecided
  wild.sc:9:1: error[SC0601]: the law of motion of p cannot be evaluated: it makes a number of more than 16777216 bits
     |
   9 | motion p = (1 + vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx*vx, 0, 0)
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  right: undecided: the law of motion of p cannot be evaluated: it makes a number of more than 16777216 bits; one unexplored state matters
  1 property: 1 undecided

What cannot be written keeps nothing else from being told.

  $ scc check grow.sc --sarif nowhere/log.sarif | tail -1
  grow.sc: warning[SC0705]: the velocity of `p` takes 131073 bits after 16 transitions, and what follows is not explored
    hint: `round velocity 2^-k`, or `round(e, q)` in a law of motion, keeps numbers short; `--bits N` lets them grow
  nowhere/log.sarif: error[SC0103]: cannot write: No such file or directory
  1 property: 1 holds up to the bound
  $ scc check grow.sc --sarif nowhere/log.sarif > /dev/null
  grow.sc: warning[SC0705]: the velocity of `p` takes 131073 bits after 16 transitions, and what follows is not explored
    hint: `round velocity 2^-k`, or `round(e, q)` in a law of motion, keeps numbers short; `--bits N` lets them grow
  nowhere/log.sarif: error[SC0103]: cannot write: No such file or directory
  [74]
  $ scc check grow.sc --json --sarif nowhere/log.sarif --witness nowhere/runs > report.json
  [74]
  $ grep -c '"name": "right"' report.json && grep '"exit"' report.json
  1
    "exit": 74,
  $ echo before > log.sarif; chmod 640 log.sarif; ln -s log.sarif link.sarif
  $ scc check grow.sc --sarif link.sarif > /dev/null
  grow.sc: warning[SC0705]: the velocity of `p` takes 131073 bits after 16 transitions, and what follows is not explored
    hint: `round velocity 2^-k`, or `round(e, q)` in a law of motion, keeps numbers short; `--bits N` lets them grow
  [2]
  $ head -c 1 log.sarif; stat -c %a log.sarif; readlink link.sarif
  {640
  log.sarif

Models are rewritten through links, with their mode, and nothing beside them is touched.

  $ chmod 600 grow.sc; ln -s grow.sc by-link.sc; ln grow.sc twin.sc; echo mine > grow.sc.scc-fmt
  $ sed -i 's/  *: always/ : always/' grow.sc; ln -f grow.sc twin.sc; printf '\n\n\n' >> grow.sc
  $ scc fmt -i by-link.sc; readlink by-link.sc; stat -c '%a %h' grow.sc; cat grow.sc.scc-fmt
  grow.sc
  600 2
  mine
  $ cmp grow.sc twin.sc && tail -n 1 grow.sc; ls -A | grep part
  check right : always x(p) >= 0
  [1]
  $ scc fmt -i -
  scc: standard input cannot be rewritten: `-' does not go with --inplace
  [64]

Numbers that nobody would read are told as decimals in text; the JSON has all of them.

  $ sed 's/always x(p) >= 0/possibly x(p) > 1e60/' grow.sc > far.sc
  $ scc check far.sc | sed -n '/^explored/p; /p at/p' | cut -c 1-150
        p at (~5.789604e76 (77 characters), 0, 0) [nil], velocity (~6.703904e153 (154 characters), 0, 0)
  explored: 9 states, 8 transitions, depth 8, model time 8; not complete: every property was decided before
