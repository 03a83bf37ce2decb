Where p starts is known by ranges alone. It meets q iff its y and z are both less than 2 in size.

  $ cat > meet.sc <<'END'
  > param y in [-5, 5]
  > param z in [-5, 5]
  > shape Cube = box(2,2,2)
  > behaviour A on Cube = <a, {right}>. Bound
  > behaviour B on Cube = <~a, {left}>. Bound
  > behaviour Bound on Cube = nil
  > process p = Cube mass 1 velocity (1,0,0) at translate (0, y, z) [A]
  > process q = Cube mass 1 at translate (12, 0, 0) [B]
  > let near = abs(y) < 2 and abs(z) < 2
  > check met : possibly bound(p, q)
  > check near : always (bound(p, q) => near)
  > check surely : eventually (bound(p, q) or not near)
  > check below : always (bound(p, q) => y - z/2 + 1 <= x(p) - 10)
  > END
  $ scc check meet.sc --where | sed '/^explored/,$d'
  semantics 3
  
  met: violated for y = -3, z = 0
    possibly bound(p, q)
    no run from there does otherwise: everything that counts was explored
    holds where
      -2 < y < 2, -2 < z < 2
    fails elsewhere
    probability 4/25 = 0.16
  
  near: holds (exhaustive, all y in [-5, 5], z in [-5, 5])
    always bound(p, q) => near
    holds everywhere
    probability 1
  
  surely: holds (exhaustive, all y in [-5, 5], z in [-5, 5])
    eventually bound(p, q) or not near
    holds everywhere
    probability 1
  
  below: violated for y = 0, z = 0
    always bound(p, q) => y - z/2 + 1 <= x(p) - 10
    fails where
      -2 < z < 2, y < 2, z < 2y + 2
    holds elsewhere
    probability 22/25 = 0.88
    a run that violates it:
      1. time passes by 10, to time 10
      2. p and q collide and bind by <a, {p.right, q.left}>, at time 10
      bound(p, q) holds
      ((0 - (0 / 2)) + 1) > (x(p) - 10) holds: ((0 - (0 / 2)) + 1) = 1, (x(p) - 10) = 0
      there:
        one process, velocity (1/2, 0, 0), <a, {p.right, q.left}>
          p at (10, 0, 0) [Bound]
          q at (12, 0, 0) [Bound]
  

A value, or a narrower range, may be given:

  $ scc check meet.sc -D y=1 -D z=-1 | grep ':'
  met: holds (exhaustive)
    a run that shows it:
      there:
  near: holds (exhaustive)
  surely: holds (exhaustive)
  below: violated
    a run that violates it:
      5/2 <= (x(p) - 10) fails: (x(p) - 10) = 0
      there:
  explored: 3 states, 2 transitions, depth 2, model time 10; complete
  4 properties: 3 hold, 1 violated
  $ scc check meet.sc -D 'y=[1,3]' --where | sed -n '/^met/,/^$/p'
  met: violated for y = 2, z = -3
    possibly bound(p, q)
    no run from there does otherwise: everything that counts was explored
    holds where
      -2 < z < 2, y < 2
    fails elsewhere
    probability 1/5 = 0.2
  
  $ scc check meet.sc -D 'y=[2,3)' -D z=0 --where | sed -n '/^met/,/^$/p'
  warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  meet.sc:11:22: warning[SC0702]: no run ever meets `bound(p, q)`, so that what `near` says of it is never asked
      |
   11 | check near : always (bound(p, q) => near)
      |                      ^^^^^^^^^^^
  meet.sc:13:23: warning[SC0702]: no run ever meets `bound(p, q)`, so that what `below` says of it is never asked
      |
   13 | check below : always (bound(p, q) => y - z/2 + 1 <= x(p) - 10)
      |                       ^^^^^^^^^^^
  met: violated for y = 5/2
    possibly bound(p, q)
    no run from there does otherwise: everything that counts was explored
    fails everywhere
    probability 0
  
  $ scc check meet.sc -D y=5.5
  command line: error[SC0217]: `y = 11/2` is not within `y in [-5, 5]`
  [64]
  $ scc check meet.sc -D 'y=[-6,1]'
  command line: error[SC0217]: `y in [-6, 1]` is not within `y in [-5, 5]`
  [64]
  $ scc check meet.sc -D 'y=[1,0]'
  command line: error[SC0217]: `y in [1, 0]` has no numbers: its first end is the greater one
  [64]

A range of all numbers between is in brackets; values one after the other are for loops and sweeps:

  $ scc check meet.sc -D y=1..2 2>&1 | head -2
  scc: option '-D': `1..2' are values one after the other, as scc sweep takes
       them: a range of all numbers between is written [1,2]
  $ scc check meet.sc -D y=1:2:1/8 2>&1 | head -2
  scc: option '-D': `1:2:1/8' are values one after the other, as scc sweep
       takes them: a range of all numbers between is written [1,2]
  $ scc check meet.sc -D y=1,2 2>&1 | head -2
  scc: option '-D': `1,2' are values one after the other, as scc sweep takes
       them: a range of all numbers between is written [1,2]
  $ scc sweep meet.sc -D 'y=[1,2)' 2>&1 | head -2
  scc: option '-D': `[1,2)' is a range of all numbers between, for scc check;
       the values of a sweep are 1..2, or 1:2:1/8 with steps of 1/8
  $ refused() { (cat meet.sc; echo "$1") > other.sc; scc check other.sc 2>&1 | grep error; }
  $ refused 'param s in 1..2'
  other.sc:14:12: error[SC0110]: `1` does not fit here: expected a range such as `[0, 6]`, or `(0, 6]` without its first end (`0..6` are integers, for loops)
  $ refused 'for i in [1, 2] { check c : always y(p) > i }'
  other.sc:14:10: error[SC0110]: `[` does not fit here: expected a range of integers, such as `1..n`
  $ refused 'check c : always forall i in [1, 2]: y(p) > i'
  other.sc:14:30: error[SC0110]: `[` does not fit here: expected the name of a shape, or a range of integers such as `1..n`

  $ scc check meet.sc -D 'y=[1;2]' 2>&1 | head -1
  scc: option '-D': `[1;2]' is no range such as [1, 3) or [0, 1/2]
  $ scc check meet.sc -D y=1 -D 'y=[1,2]'
  command line: error[SC0212]: the parameter `y` is given two values by -D
  [64]

A witness is a run from one start, which the schedule names:

  $ mkdir runs
  $ scc check meet.sc --witness runs > report
  [1]
  $ grep parameters runs/below.json
    "parameters": {"y":"0/1","z":"0/1"},
  $ scc trace meet.sc --schedule runs/below.json --human --states=ends | tail -1
  2 transitions, time 10: nothing will ever happen again

What needs values says so:

  $ scc trace meet.sc
  error[SC0903]: this needs the values of all parameters, and of `y`, `z` a range is known
    hint: `scc check` answers for all values; `-D y=VALUE` gives one; `--start simple` chooses them
  [3]
  $ scc explore meet.sc -o out.aut 2>&1 | grep error
  error[SC0903]: this needs the values of all parameters, and of `y`, `z` a range is known

The graph of all sets of states, as a picture:

  $ scc explore meet.sc -o - --format dot --positions -D 'y=[0,5]'
  digraph "model" {
    node [shape=box, fontname="Helvetica", fontsize=10]
    edge [fontname="Helvetica", fontsize=9]
    start [shape=point]
    start -> z0
    z0 [label="0\np: A\nq: B\np at (0, y, z)\nq at (12, 0, 0)\ny >= 0, z >= -5, z <= 5, y <= 5\nat rest where y >= 0, z >= 2, z <= 5, y <= 5\nat rest where y >= 0, z >= -5, z <= -2, y <= 5\nat rest where y >= 2, z > -2, z < 2, y <= 5", peripheries=2]
    z0 -> z1 [label="time(10)\nwhere y >= 0, z > -2, z < 2, y < 2", color=gray]
    z1 [label="1\np: A\nq: B\np at (10, y, z)\nq at (12, 0, 0)\ny >= 0, z > -2, z < 2, y < 2"]
    z1 -> z2 [label="bind(a, p.right, q.left)"]
    z2 [label="2\n<a, {p.right, q.left}>\np: Bound\nq: Bound\np at (10, y, z)\nq at (12, 0, 0)\ny >= 0, z > -2, z < 2, y < 2", peripheries=2]
    legend [shape=plain, label="model without a name, y in [0, 5], z in [-5, 5]\nsemantics 3\nexplored: 3 zones, 2 edges; complete\ndouble border: nothing need happen any more, from all of it or where told\ngray: time passes"]
  }
  scc: semantics 3
  scc: explored: 3 zones, 2 edges; complete

and in full. A bound leaves something out, which is told:

  $ scc explore meet.sc -o zones.json
  scc: semantics 3
  scc: explored: 3 zones, 2 edges; complete
  $ grep -o '"format": .*\|"number":[0-9]*\|"label":{[^}]*}\|"target":[0-9]*' zones.json
  "format": "scc-zones",
  "number":0
  "label":{"kind":"time","text":"time(10)","duration":{"coefficients":{}
  "target":1
  "number":1
  "label":{"kind":"bind","text":"bind(a, p.right, q.left)","name":"a","ends":["p.right","q.left"]}
  "target":2
  "number":2
  $ scc explore meet.sc -o zones.json --states 2
  scc: semantics 3
  scc: explored: 2 zones, 1 edges
  scc: TRUNCATED: 1 zones unexplored, by the bound of 2 states
  $ grep '^"complete\|^"unexplored\|^"bounds' zones.json
  "complete": false,
  "unexplored": 1,
  "bounds": ["the bound of 2 states"],
  $ scc explore meet.sc -o zones.json --time 9
  scc: semantics 3
  scc: explored: 1 zones, 0 edges
  scc: TRUNCATED, by the time bound 9
  $ grep -o '^"complete.*\|^"bounds.*\|"late":\[\[[^]]*\]\]' zones.json
  "complete": false,
  "bounds": ["the time bound 9"],
  "late":[[{"coefficients":{"y":"-1/1"},"relation":"<","bound":"2/1"},{"coefficients":{"z":"-1/1"},"relation":"<","bound":"2/1"},{"coefficients":{"z":"1/1"},"relation":"<","bound":"2/1"},{"coefficients":{"y":"1/1"},"relation":"<","bound":"2/1"}]]
  $ scc explore meet.sc -o zones.json --depth 1
  scc: semantics 3
  scc: explored: 2 zones, 1 edges
  scc: TRUNCATED: 1 zones unexplored, by the depth bound 1

A trace samples a start when told how, and tells which one. -D gives the same one again:

  $ scc trace meet.sc --start simple --human --states=ends | sed -n '1,2p;$p'
  for y = 0, z = 0
  time 0
  2 transitions, time 10: nothing will ever happen again
  $ scc trace meet.sc --start simple > simple.jsonl
  $ head -1 simple.jsonl | grep -o '"parameters":{[^}]*}'
  "parameters":{"y":"0/1","z":"0/1"}
  $ scc trace meet.sc -D y=0 -D z=0 | cmp - simple.jsonl
  $ scc trace meet.sc --schedule simple.jsonl | cmp - simple.jsonl
  $ scc trace meet.sc --start random:7 --choose random:7 > random.jsonl
  $ head -1 random.jsonl | grep -o '"parameters":{[^}]*}'
  "parameters":{"y":"795/256","z":"165/256"}
  $ scc trace meet.sc -D y=795/256 -D z=165/256 --choose random:7 | cmp - random.jsonl
  $ scc trace meet.sc --start random:8 | head -1 | grep -o '"parameters":{[^}]*}'
  "parameters":{"y":"1095/256","z":"535/128"}
  $ scc trace meet.sc --start random:7 --itf | grep -o '"parameters": *{[^}]*}'
  "parameters":{"y":"795/256","z":"165/256"}

What -D or a schedule gives is kept, and a model of one start has none to choose:

  $ scc trace meet.sc -D y=4 --start simple --human --states=ends | sed -n '1p;$p'
  for z = 0
  0 transitions, time 0: nothing will ever happen again
  $ scc trace meet.sc -D z=-3/2 --start random:7 | head -1 | grep -o '"parameters":{[^}]*}'
  "parameters":{"y":"795/256","z":"-3/2"}
  $ scc trace meet.sc -D y=0 -D z=0 --start random:7 | cmp - simple.jsonl
  $ scc trace meet.sc --schedule runs/below.json --start random:7 --human --states=ends | sed -n '1p;$p'
  time 0
  2 transitions, time 10: nothing will ever happen again
  $ scc trace meet.sc --schedule simple.jsonl -D y=1 2>&1 | grep error
  command line: error[SC0801]: the schedule was made with another value of `y` than -D gives

A range that -D narrows is the one that is sampled; a schedule or a trace made with a value of it will do:

  $ scc trace meet.sc -D 'y=[1,3]' --start simple --human --states=ends | sed -n '1p'
  for y = 2, z = 0
  $ scc trace meet.sc -D 'y=[2,3)' -D 'z=[4,5]' --start random:8 > narrow.jsonl
  $ head -1 narrow.jsonl | grep -o '"parameters":{[^}]*}'
  "parameters":{"y":"1499/512","z":"1259/256"}
  $ scc trace meet.sc -D y=1499/512 -D z=1259/256 | cmp - narrow.jsonl
  $ scc trace meet.sc -D 'y=[1,3]' 2>&1 | grep error
  error[SC0903]: this needs the values of all parameters, and of `y`, `z` a range is known
  $ scc trace meet.sc -D 'y=[5,9]' --start simple
  command line: error[SC0217]: `y in [5, 9]` is not within `y in [-5, 5]`
  [64]
  $ scc trace meet.sc -D 'y=[-1,3]' --schedule simple.jsonl | cmp - simple.jsonl
  $ scc trace meet.sc -D 'y=[1,3]' --schedule simple.jsonl 2>&1 | grep error
  command line: error[SC0801]: the schedule was made with another value of `y` than -D gives
  $ scc explain simple.jsonl meet.sc -D 'y=[-1,3]' | grep matter
  1 of 1 events matter
  $ scc explain simple.jsonl meet.sc -D 'y=[1,3]' 2>&1 | grep error
  command line: error[SC0801]: the schedule was made with another value of `y` than -D gives
  $ scc conform meet.sc simple.jsonl -D 'y=[-1,3]'
  simple.jsonl: conforms: 1 event, a run of 2 transitions up to time 10
  $ scc conform meet.sc simple.jsonl -D 'y=[1,3]'
  command line: error[SC0804]: the trace was made with another value of `y` than -D gives
  [64]

No word but these tells which start:

  $ scc trace meet.sc --start random:x 2>&1 | head -1
  scc: option '--start': the seed is no integer of 64 bits
  $ scc trace meet.sc --start middle 2>&1 | head -1
  scc: option '--start': `middle' is neither `simple' nor `random:SEED'

What is listed state by state needs values:

  $ scc compare meet.sc meet.sc 2>&1 | grep error
  error[SC0903]: this needs the values of all parameters, and of `y`, `z` a range is known
  $ scc trace meet.sc -D y=0 -D z=0 --steps 1 --human --states=ends | tail -1
  1 transitions, time 10: more can happen

Where bodies interpenetrate, or are apart that are bound, for some values, the places at fault are those of the model at such values:

  $ sed 's/translate (12, 0, 0)/translate (0, 0, z)/' meet.sc > over.sc
  $ scc check over.sc
  over.sc:8:9: error[SC0403]: `p` and `q` interpenetrate for some starts: for y = 0, z = 0
     |
   8 | process q = Cube mass 1 at translate (0, 0, z) [B]
     |         ^
  over.sc:7:9: note: `p` is here
     |
   7 | process p = Cube mass 1 velocity (1,0,0) at translate (0, y, z) [A]
     |         ^
  [3]
  $ sed -e '/^check/d' -e '/^process q/s/mass 1 at translate (12, 0, 0)/mass 1 velocity (1,0,0) at translate (2, 0, 0)/' meet.sc > apart.sc
  $ echo 'bond <a, {p.right, q.left}>' >> apart.sc
  $ scc check apart.sc -D z=0
  apart.sc:9:5: warning[SC0211]: the `let` `near` is not used
     |
   9 | let near = abs(y) < 2 and abs(z) < 2
     |     ^^^^
  apart.sc:10:6: error[SC0401]: p.right and q.left do not touch for some starts: for y = -3
      |
   10 | bond <a, {p.right, q.left}>
      |      ^^^^^^^^^^^^^^^^^^^^^^
  [3]

and a trace from such a start is refused, from another one it is not:

  $ scc trace over.sc --start simple
  over.sc:8:9: error[SC0403]: `p` and `q` interpenetrate: the point (0, 0, 0) is inside both
     |
   8 | process q = Cube mass 1 at translate (0, 0, z) [B]
     |         ^
  over.sc:7:9: note: `p` is here
     |
   7 | process p = Cube mass 1 velocity (1,0,0) at translate (0, y, z) [A]
     |         ^
  [3]
  $ scc trace over.sc -D y=3 --start simple --human --states=ends | sed -n '1p;$p'
  for z = 0
  0 transitions, time 0: nothing will ever happen again

Delays and parts of compounds are sampled as well:

  $ cat > delay.sc <<'END'
  > param w in (0, 1/2]
  > param d in [-1, 1]
  > shape Cube = box(2,2,2)
  > compound Pair { part one : Cube mass 1 part two : Cube mass 1 at translate (2,d,0) glue one.right ~ two.left }
  > behaviour A on Pair = eps(w). nil
  > process p = Pair at translate (0, 0, 0) [A]
  > END
  $ scc trace delay.sc --start simple --human
  for w = 1/3, d = 0
  time 0
          p at (0, 0, 0) [A], velocity (0, 0, 0)
      1.  time passes by 1/3   {Time, TimeBehaviour}
  time 1/3
          p at (0, 0, 0) [nil], velocity (0, 0, 0)
  1 transitions, time 1/3: nothing will ever happen again
  $ scc trace delay.sc --start random:1 --human | head -1
  for w = 527/2048, d = 323/512

What is not found in passing is explored for one start, with its values in the formula as well:

  $ sed '/^check\|^let/d' meet.sc > interval.sc
  $ echo 'check there : AG[1, 4] (x(p) = 5 - y)' >> interval.sc
  $ scc check interval.sc -D z=0
  semantics 3
  
  there: violated for y = 0
    AG[1, 4] x(p) = 5 - y
    a run that violates it:
      then time passes, until time 1
      x(p) = (5 - 0) fails: x(p) = 1, (5 - 0) = 5
      there:
        p at (1, 0, 0) [A], velocity (1, 0, 0)
        q at (12, 0, 0) [B], velocity (0, 0, 0)
  
  explored: 1 state, 0 transitions, depth 0; complete
  1 property: 1 violated
  [1]
