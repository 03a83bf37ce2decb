Are two models equivalent? A model and itself:

  $ scc compare ../../specs/models/hexokinase.sc ../../specs/models/hexokinase.sc
  equivalent modulo branching
    as labels tell it, which know no places: beside a third body the two may differ
  the first ../../specs/models/hexokinase.sc: 11 states, 16 transitions, 9 classes; complete, at split step 1
    semantics 3: split step 1
  the second ../../specs/models/hexokinase.sc: 11 states, 16 transitions, 9 classes; complete, at split step 1
    semantics 3: split step 1
  $ scc compare ../../specs/models/hexokinase.sc ../../specs/models/hexokinase.sc --modulo timed
  equivalent modulo timed
    as labels tell it, which know no places: beside a third body the two may differ
  the first ../../specs/models/hexokinase.sc: 11 states, 16 transitions, 10 classes; complete, at split step 1
    semantics 3: split step 1
  the second ../../specs/models/hexokinase.sc: 11 states, 16 transitions, 10 classes; complete, at split step 1
    semantics 3: split step 1

When they are not, a trace of one that the other does not have, and a formula:

  $ scc compare ../../specs/models/figure7.sc ../../specs/models/figure7-offset.sc --modulo weak
  not equivalent modulo weak
    ../../specs/models/figure7-offset.sc can do this, and ../../specs/models/figure7.sc cannot:
      1. bind(a, P0.s1.[v2,v3], s2.f3)
    this is true of ../../specs/models/figure7.sc, and not of ../../specs/models/figure7-offset.sc:
      [[bind(a, P0.s0.[v2,v3], s2.f3)]]false
  ../../specs/models/figure7.sc: 4 states, 3 transitions, 2 classes; complete
    semantics 3
  ../../specs/models/figure7-offset.sc: 4 states, 3 transitions, 2 classes; complete
    semantics 3
  [1]

Parameters for one of the two:

  $ scc compare ../../specs/models/chain.sc ../../specs/models/chain.sc --left n=2 --right n=3 --modulo trace
  not equivalent modulo trace
    the second ../../specs/models/chain.sc can do this, and the first ../../specs/models/chain.sc cannot:
      1. bind(link, c[1].right, c[2].left)
      2. bind(link, c[2].right, c[3].left)
    this is true of the first ../../specs/models/chain.sc, and not of the second ../../specs/models/chain.sc:
      [[bind(link, c[1].right, c[2].left)]][[bind(link, c[2].right, c[3].left)]]false
  the first ../../specs/models/chain.sc: 3 states, 2 transitions, 2 classes; complete
    semantics 3
  the second ../../specs/models/chain.sc: 5 states, 4 transitions, 3 classes; complete
    semantics 3
  [1]

Names that differ do not matter when one is told:

  $ sed 's/w1/one/g; s/w2/two/g' ../../specs/models/dimer.sc > renamed.sc
  $ scc compare ../../specs/models/dimer.sc renamed.sc --modulo timed | head -1
  not equivalent modulo timed
  $ scc compare ../../specs/models/dimer.sc renamed.sc --modulo timed --rename w1=one --rename w2=two
  equivalent modulo timed
    as labels tell it, which know no places: beside a third body the two may differ
  ../../specs/models/dimer.sc: 11 states, 14 transitions, 9 classes; complete, at split step 1/2
    semantics 3: split step 1/2
  renamed.sc: 11 states, 14 transitions, 9 classes; complete, at split step 1/2
    semantics 3: split step 1/2

What is hidden does not matter either:

  $ scc compare ../../specs/models/dimer.sc renamed.sc --hide weak
  equivalent modulo branching
    as labels tell it, which know no places: beside a third body the two may differ
  ../../specs/models/dimer.sc: 11 states, 14 transitions, 2 classes; complete, at split step 1/2
    semantics 3: split step 1/2
  renamed.sc: 11 states, 14 transitions, 2 classes; complete, at split step 1/2
    semantics 3: split step 1/2

A delay that is longer is seen by timed equivalence alone:

  $ sed 's/eps(3)/eps(4)/' ../../specs/models/dimer.sc > slow.sc
  $ scc compare ../../specs/models/dimer.sc slow.sc --modulo branching | head -1
  equivalent modulo branching
  $ scc compare ../../specs/models/dimer.sc slow.sc --modulo timed
  not equivalent modulo timed
    ../../specs/models/dimer.sc can do this, and slow.sc cannot:
      1. time(2)
      2. weak(bond, w1.right, w2.left)
      3. time(1)
      4. strong({<bond, {s1.right, s2.left}>})
    this is true of ../../specs/models/dimer.sc, and not of slow.sc:
      <time(2)><weak(bond, w1.right, w2.left)><time(1)><strong({<bond, {s1.right, s2.left}>})>true
  ../../specs/models/dimer.sc: 11 states, 14 transitions, 9 classes; complete, at split step 1/2
    semantics 3: split step 1/2
  slow.sc: 15 states, 20 transitions, 13 classes; complete, at split step 1/2
    semantics 3: split step 1/2
  [1]

Graphs that others have written. Where the traces are the same, the formula says what a trace cannot:

  $ cat > late.aut <<'EOF'
  > des (0, 3, 4)
  > (0, "a", 1)
  > (1, "b", 2)
  > (1, "c", 3)
  > EOF
  $ cat > early.aut <<'EOF'
  > des (0, 4, 5)
  > (0, "a", 1)
  > (0, "a", 2)
  > (1, "b", 3)
  > (2, "c", 4)
  > EOF
  $ scc compare late.aut early.aut --modulo trace
  equivalent modulo trace
  late.aut: 4 states, 3 transitions, 3 classes; complete
  early.aut: 5 states, 4 transitions, 4 classes; complete
  $ scc compare late.aut early.aut --modulo weak
  not equivalent modulo weak
    their traces are the same
    this is true of late.aut, and not of early.aut:
      [[a]]<<c>>true
  late.aut: 4 states, 3 transitions, 3 classes; complete
  early.aut: 5 states, 4 transitions, 4 classes; complete
  [1]
  $ scc compare late.aut early.aut --modulo branching
  not equivalent modulo branching
    their traces are the same
    this is true of late.aut, and not of early.aut:
      not (true until <a>not (true until <b>true))
  late.aut: 4 states, 3 transitions, 3 classes; complete
  early.aut: 5 states, 4 transitions, 4 classes; complete
  [1]
  $ scc compare late.aut early.aut --modulo strong
  not equivalent modulo strong
    their traces are the same
    this is true of late.aut, and not of early.aut:
      [a]<b>true
  late.aut: 4 states, 3 transitions, 3 classes; complete
  early.aut: 5 states, 4 transitions, 4 classes; complete
  [1]
  $ scc compare late.aut early.aut --modulo branching --rename '*=x'
  not equivalent modulo branching
    early.aut can do this, and late.aut cannot:
      1. a
    this is true of late.aut, and not of early.aut:
      not (true until <a>true)
  late.aut: 4 states, 3 transitions, 3 classes; complete
  early.aut: 5 states, 4 transitions, 4 classes; complete
  [1]
  $ scc compare late.aut early.aut --modulo strong --json
  {
    "format": "scc-compare",
    "version": 1,
    "semantics": "3",
    "relation": "strong",
    "verdict": "different",
    "exit": 1,
    "trace": null,
    "trace_known": true,
    "formula": {"operators": 5, "text": "[a]<b>true"},
    "reason": null,
    "first": {
      "file": "late.aut",
      "kind": "graph",
      "model": null,
      "digest": null,
      "parameters": {},
      "settings": {},
      "states": 4,
      "transitions": 3,
      "complete": true,
      "stopped_by": [],
      "faults": [],
      "compared_states": 4,
      "compared_transitions": 3,
      "classes": 3
    },
    "second": {
      "file": "early.aut",
      "kind": "graph",
      "model": null,
      "digest": null,
      "parameters": {},
      "settings": {},
      "states": 5,
      "transitions": 4,
      "complete": true,
      "stopped_by": [],
      "faults": [],
      "compared_states": 5,
      "compared_transitions": 4,
      "classes": 4
    },
    "diagnostics": []
  }
  [1]

A model can be compared with its graph, and what is compared can be written:

  $ scc explore ../../specs/models/hexokinase.sc -o hexokinase.aut
  scc: semantics 3: split step 1
  scc: explored: 11 states, 16 transitions; complete
  $ scc compare ../../specs/models/hexokinase.sc hexokinase.aut --modulo weak
  equivalent modulo weak
  ../../specs/models/hexokinase.sc: 11 states, 16 transitions, 9 classes; complete, at split step 1
    semantics 3: split step 1
  hexokinase.aut: 12 states, 19 transitions, 9 classes; complete
  $ scc compare ../../specs/models/hexokinase.sc hexokinase.aut --modulo strong --write graph | head -1
  equivalent modulo strong
  $ cat graph-1.aut
  des (0, 19, 12)
  (0, "time", 1)
  (1, "bind(atp, atp.bottom, enzyme.floorA.top)", 2)
  (1, "bind(glc, enzyme.floorB.top, glucose.bottom)", 3)
  (2, "bind(glc, enzyme.floorB.top, glucose.bottom)", 4)
  (2, "weak(atp, atp.bottom, enzyme.floorA.top)", 5)
  (3, "bind(atp, atp.bottom, enzyme.floorA.top)", 4)
  (3, "weak(glc, enzyme.floorB.top, glucose.bottom)", 6)
  (4, "weak(atp, atp.bottom, enzyme.floorA.top)", 7)
  (4, "weak(glc, enzyme.floorB.top, glucose.bottom)", 8)
  (4, "strong({<atp, {atp.bottom, enzyme.floorA.top}>, <glc, {enzyme.floorB.top, glucose.bottom}>})", 9)
  (5, "bind(glc, enzyme.floorB.top, glucose.bottom)", 7)
  (6, "bind(atp, atp.bottom, enzyme.floorA.top)", 8)
  (7, "time", 7)
  (7, "weak(glc, enzyme.floorB.top, glucose.bottom)", 10)
  (8, "time", 8)
  (8, "weak(atp, atp.bottom, enzyme.floorA.top)", 10)
  (9, "time", 11)
  (10, "time", 11)
  (11, "time", 11)
  $ scc compare graph-1.aut ../../specs/models/hexokinase.sc --modulo strong | head -1
  equivalent modulo strong

What was not explored is not guessed at:

  $ scc compare ../../specs/models/dimer.sc ../../specs/models/dimer.sc --states 4
  undecided modulo branching: no difference within what is known; it may lie in what was not explored
  the first ../../specs/models/dimer.sc: 4 states, 3 transitions; not complete: stopped by the bound of 4 states, at split step 1/2
    semantics 3: split step 1/2
  the second ../../specs/models/dimer.sc: 4 states, 3 transitions; not complete: stopped by the bound of 4 states, at split step 1/2
    semantics 3: split step 1/2
  [2]
  $ scc compare ../../specs/models/figure7.sc ../../specs/models/figure7-offset.sc --depth 1 --modulo strong
  not equivalent modulo strong
    ../../specs/models/figure7-offset.sc can do this, and ../../specs/models/figure7.sc cannot:
      1. time
      2. bind(a, P0.s1.[v2,v3], s2.f3)
    this is true of ../../specs/models/figure7.sc, and not of ../../specs/models/figure7-offset.sc:
      <time><bind(a, P0.s0.[v2,v3], s2.f4)>true
  ../../specs/models/figure7.sc: 4 states, 3 transitions; not complete: stopped by the depth bound 1
    semantics 3
  ../../specs/models/figure7-offset.sc: 4 states, 3 transitions; not complete: stopped by the depth bound 1
    semantics 3
  [1]

Wrong inputs:

  $ scc compare late.aut nothing.sc
  nothing.sc: error[SC0101]: cannot read: No such file or directory
  [3]
  $ echo 'des (0, 1, 1) (0, a, 0)' > bad.aut
  $ scc compare late.aut bad.aut
  bad.aut:1:15: error[SC0803]: more than fits the line
     |
   1 | des (0, 1, 1) (0, a, 0)
     |               ^^^^^^^^^
  [3]
  $ printf 'des (0, 1, 1)\n(0, "a", 1)\n' > bad.aut
  $ scc compare late.aut bad.aut
  bad.aut:2:10: error[SC0803]: state 1 is not below the number of states, 1
     |
   2 | (0, "a", 1)
     |          ^
  [3]
  $ scc compare late.aut early.aut -D n=3
  command line: error[SC0209]: late.aut is a graph, and has no parameters that could be given a value
  [64]
  $ scc compare - -
  scc: only one of the two can be read from standard input
  [64]
  $ scc compare late.aut early.aut --rename a 2>&1 | head -1
  scc: option '--rename': `a' is not of the form FROM=TO
  $ scc compare late.aut early.aut --rename 'a*=*b*' 2>&1 | head -1
  scc: option '--rename': `a*=*b*' has more stars after the = than before

The order in which bodies are declared is not seen, not even when what bounces is a process of several.

  $ shape() { echo 'shape Cube { vertices a (-1,-1,-1) b (1,-1,-1) c (1,1,-1) d (-1,1,-1)'
  >   echo ' e (-1,-1,1) f (1,-1,1) g (1,1,1) h (-1,1,1)'
  >   echo ' faces bottom [a,d,c,b] top [e,f,g,h] left [a,e,h,d] right [b,c,g,f] front [a,b,f,e] back [d,h,g,c] }'
  >   echo 'behaviour R = <a, {right}>. nil'; echo 'behaviour L = <~a, {left}>. nil'; }
  $ p='process p = Cube mass 1 velocity (1,0,0) at translate (0,0,0) [R]'
  $ q='process q = Cube mass 1 at translate (3,0,0) [L]'
  $ w='fixed w = Cube at translate (9,0,0)'
  $ { shape; echo "$p"; echo "$q"; echo "$w"; } > one.sc; { shape; echo "$w"; echo "$q"; echo "$p"; } > two.sc
  $ scc compare one.sc two.sc --modulo timed | head -1
  equivalent modulo timed
  $ sed 's/process q/process b/' two.sc > three.sc
  $ scc compare one.sc three.sc --modulo timed --rename q=b | head -1
  equivalent modulo timed

Labels tell no places: two models that are equivalent by themselves may differ beside a third body:

  $ cat > cube.txt << 'END'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > END
  $ (cat cube.txt; echo 'process p = Cube mass 1 [nil]') > here.sc
  $ (cat cube.txt; echo 'process p = Cube mass 1 at translate (0,40,0) [nil]') > there.sc
  $ scc compare here.sc there.sc --modulo timed 2> warnings
  equivalent modulo timed
    as labels tell it, which know no places: beside a third body the two may differ
  here.sc: 1 state, 0 transitions, 1 class; complete
    semantics 3
  there.sc: 1 state, 0 transitions, 1 class; complete
    semantics 3
  $ echo 'process q = Cube mass 1 velocity (-1,0,0) at translate (9,0,0) [nil]' | tee -a here.sc >> there.sc
  $ scc compare here.sc there.sc --modulo trace 2> warnings | head -n 3
  not equivalent modulo trace
    here.sc can do this, and there.sc cannot:
      1. bounce(p, q)

What is drawn at one instant is one transition: it is not seen which of two pairs is drawn for first, nor which of them chooses first. Here the
first pair is on the left of the other one, and there on its right:

  $ grep -v '^check' ../../specs/models/laws/pairs.sc > left.sc
  $ sed '/^process [pq]/s/translate (/translate (20 + /' left.sc > right.sc
  $ scc compare left.sc right.sc --modulo timed
  equivalent modulo timed
    as labels tell it, which know no places: beside a third body the two may differ
  left.sc: 25 states, 37 transitions, 12 classes; complete, at split step 1
    semantics 3: split step 1
  right.sc: 25 states, 37 transitions, 12 classes; complete, at split step 1
    semantics 3: split step 1
  $ scc compare left.sc right.sc --modulo strong --write as | head -1
  equivalent modulo strong
  $ head -6 as-2.aut
  des (0, 38, 22)
  (0, "time", 1)
  (1, "{keep(a, p.right, q.left), keep(a, u.right, v.left)} chance(1/3)", 0)
  (1, "{release(a, p.right, q.left), release(a, u.right, v.left)} chance(1/6)", 2)
  (1, "{keep(a, p.right, q.left), release(a, u.right, v.left)} chance(1/3)", 3)
  (1, "{keep(a, u.right, v.left), release(a, p.right, q.left)} chance(1/6)", 4)
  $ scc explore left.sc --format aut -o left.aut
  scc: semantics 3: split step 1
  scc: explored: 25 states, 37 transitions; complete
  $ scc compare left.aut right.sc | head -1
  equivalent modulo branching

What is hidden of a draw is left out; and what has other chances is another draw:

  $ scc compare left.sc right.sc --modulo strong --hide 'keep(*)' --write as | head -1
  equivalent modulo strong
  $ head -6 as-2.aut
  des (0, 38, 22)
  (0, "time", 1)
  (1, "tau", 0)
  (1, "{release(a, p.right, q.left), release(a, u.right, v.left)} chance(1/6)", 2)
  (1, "release(a, u.right, v.left) chance(1/3)", 3)
  (1, "release(a, p.right, q.left) chance(1/6)", 4)
  $ scc compare left.sc left.sc --right one=1/4
  not equivalent modulo branching
    the second left.sc can do this, and the first left.sc cannot:
      1. {keep(a, p.right, q.left), release(a, u.right, v.left)} chance(3/8)
    this is true of the first left.sc, and not of the second left.sc:
      (true until <{keep(a, p.right, q.left), keep(a, u.right, v.left)} chance(1/3)>true)
  the first left.sc: 25 states, 37 transitions, 9 classes; complete, at split step 1
    semantics 3: split step 1
  the second left.sc: 25 states, 37 transitions, 9 classes; complete, at split step 1
    semantics 3: split step 1
  [1]

What is known after an interruption is compared as it is after `--seconds`, in either order:

  $ cat > far.sc << END
  > shape C = box(1,1,1)
  > process p = C mass 1 velocity (1,0,0) [nil]
  > motion p = (if vx > 1000000 then 0 else vx + dt, vy, vz)
  > END
  $ printf 'des (0, 1, 2)\n(0, "a", 1)\n' > a.aut
  $ scc compare a.aut far.sc --modulo timed --seconds 0.3 --states 100000000 | head -3
  not equivalent modulo timed
    a.aut can do this, and far.sc cannot:
      1. a
  $ python3 -B interrupt.py 0.3 scc compare a.aut far.sc --modulo timed --states 100000000 | head -3
  not equivalent modulo timed
    a.aut can do this, and far.sc cannot:
      1. a
  $ python3 -B interrupt.py 0.3 scc compare far.sc a.aut --modulo timed --states 100000000 | head -3
  not equivalent modulo timed
    a.aut can do this, and far.sc cannot:
      1. a
