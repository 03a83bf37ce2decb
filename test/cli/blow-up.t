Where a bound ends an exploration, the values that kept being new are told, and what helps.

  $ cat > leaves.sc <<'END'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > fixed west = Cube at translate (-9, 0, 0)
  > fixed east = Cube at translate (9, 0, 0)
  > process p = Cube mass 1 velocity (1,0,0) [nil]
  > process q = Cube mass 1 velocity (0,0,1) at translate (0,0,20) [nil]
  > check back : AG EF event bounce(p)
  > END
  $ scc check leaves.sc --states 500 | sed -n '/^explored/,$p'
  explored: 500 states, 499 transitions, depth 499, model time 3493; not complete: stopped by the bound of 500 states
    likely cause: q leaves all others, while these come back to where they were: at the end of the deepest run it is 3513.01 from the nearest, and was 3177.01 not long before
      cure: put a `fixed` wall in its way, or one that says `absorb`; or give the check a bound: `within t`
    (specs/guide.md, "Why did my model blow up?")
  1 property: 1 undecided
  $ scc check leaves.sc --states 500 --json | sed -n '/"likely_causes"/,/\]$/p'
      "likely_causes": [
        {
          "kind": "leaves",
          "bodies": ["q"],
          "text": "q leaves all others, while these come back to where they were: at the end of the deepest run it is 3513.01 from the nearest, and was 3177.01 not long before",
          "cure": "put a `fixed` wall in its way, or one that says `absorb`; or give the check a bound: `within t`"
        }
      ]

Not where everything was explored, nor at a depth or a time that was asked for, nor with fingerprints alone.

  $ scc check leaves.sc --depth 100 | grep -c likely
  0
  [1]
  $ scc check leaves.sc --time 100 | grep -c likely
  0
  [1]
  $ sed 's/AG EF event bounce(p)/always x(p) < 9/' leaves.sc > always.sc
  $ scc check always.sc --states 500 --hash-compact | grep -c likely
  0
  [1]
  $ sed '/^process q/d' leaves.sc > closes.sc
  $ scc check closes.sc --json | grep -c likely
  0
  [1]
