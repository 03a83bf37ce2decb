Traces that others recorded. What scc records itself conforms, of course.

  $ M=../../specs/models
  $ scc trace $M/latch.sc > own.jsonl
  $ scc conform $M/latch.sc own.jsonl
  own.jsonl: conforms: 2 events, a run of 3 transitions up to time 2
  $ scc trace $M/enzyme.sc --choose random:5 --steps 60 | scc conform $M/enzyme.sc -
  <standard input>: conforms: 35 events, a run of 60 transitions up to time 25
  $ scc trace $M/pocket.sc --steps 12 | scc conform $M/pocket.sc -
  <standard input>: conforms: 2 events, a run of 12 transitions up to time 3.67582738

CSV, exact and with floats.

  $ cat > exact.csv <<EOF
  > time,event,bodies,channel,features
  > 2,bind,p;q,dock,p.right;q.left
  > 3,weak,p;q,dock,p.right;q.left
  > 10,end
  > EOF
  $ scc conform $M/latch.sc exact.csv --run run.json
  exact.csv: conforms: 2 events, a run of 4 transitions up to time 3
  $ scc trace $M/latch.sc --schedule run.json --states=ends | tail -1
  {"type":"end","steps":4,"time":"3/1","ending":"quiescent"}
  $ sed 's/^2,/2.0000001,/' exact.csv > floats.csv
  $ scc conform $M/latch.sc floats.csv
  floats.csv:2:1: error[SC0804]: the trace has floats: --tolerance tells how far off they may be (0: not at all)
     |
   2 | 2.0000001,bind,p;q,dock,p.right;q.left
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  [3]
  $ scc conform $M/latch.sc floats.csv --tolerance 1e-9
  floats.csv: diverges at line 2, time 2.0000001: wrong-time
    the trace: bind(dock, p.right, q.left)
    bind(dock, p.right, q.left) is allowed at time 2: the trace is 1e-7 too late
    rules: Ftoc, Collision
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ scc conform $M/latch.sc floats.csv --tolerance 1e-6
  floats.csv: conforms: 2 events, a run of 4 transitions up to time 3
    off by at most 1e-7 in time, 0 in position, 0 in velocity (tolerance 1/1000000)
  $ scc diff exact.csv own.jsonl
  the traces differ: event 2 is 1 earlier in the second
    exact.csv, line 3, time 3: weak(dock, p.right, q.left)
    own.jsonl, line 5, time 2: weak(dock, p.right, q.left)
  [1]
  $ scc diff exact.csv floats.csv --tolerance 0
  the traces differ: event 1 is 1e-7 later in the second
    exact.csv, line 2, time 2: bind(dock, p.right, q.left)
    floats.csv, line 2, time 2.0000001: bind(dock, p.right, q.left)
  [1]
  $ scc diff exact.csv floats.csv --tolerance 1e-6
  the traces are the same: 2 events

What is left open is inferred: which of the candidates of Figure 7 bound.

  $ printf 'time,event,bodies\n2,bind,P0 s2\n' | scc conform $M/figure7.sc -
  <standard input>: conforms: 1 event, a run of 2 transitions up to time 2
    it could be in 2 states at once
  $ printf 'time,event\n30,end\n' | scc conform $M/dimers.sc - -D n=4 --unobserved weak
  <standard input>: conforms: 0 events, a run of 4 transitions up to time 0
    it could be in 46 states at once
  $ printf 'time,event\n30,end\n' | scc conform $M/dimers.sc - -D n=12 --unobserved weak --states 30
  <standard input>: undecided after 0 of 1 item: more states than the limit would have to be looked at (--states)
  [2]

Events of separate bodies that happen at nearly the same time may stand in either order, within the tolerance. Of the
same body they may not.

  $ cat > pairs.sc <<EOF
  > model pairs
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > process p = Cube mass 1 velocity (1,0,0) at translate (0,0,0) [nil]
  > process q = Cube mass 1 at translate (4,0,0) [nil]
  > process r = Cube mass 1 velocity (1,0,0) at translate (0,9,0) [nil]
  > process s = Cube mass 1 at translate (4 + 1/1000000,9,0) [nil]
  > process t = Cube mass 1 at translate (6,0,0) [nil]
  > check solid : always distance2(p, q) >= 0
  > EOF
  $ printf 'time,event,bodies\n2.0,bounce,r;s\n2.0,state,r\n2.0,bounce,p;q\n2.0,bounce,q;t\n' > swapped.csv
  $ scc conform pairs.sc swapped.csv --tolerance 1e-5
  swapped.csv: conforms: 3 events, a run of 5 transitions up to time 2.000001
    off by at most 1/1000000 in time, 0 in position, 0 in velocity (tolerance 1/100000)
  $ scc conform pairs.sc swapped.csv --tolerance 1e-7
  swapped.csv: diverges at line 2, time 2: wrong-time
    the trace: bounce(r, s)
    bounce(r, s) is allowed at time 2.000001: the trace is 1/1000000 too early
    rules: Ftoc, Collision
    allowed there:
      bounce(r, s) at time 2.000001   {Bounce}
    after: bounce(q, t) at time 2   {Bounce}
  [1]
  $ printf 'time,event,bodies\n2,bounce,q;t\n2,bounce,p;q\n' | scc conform pairs.sc - --tolerance 1e-5
  <standard input>: diverges at line 2, time 2: wrong-order
    the trace: bounce(q, t)
    bounce(p, q) has to come before it, and the trace has it later
    rules: Successors, Time
    allowed there:
      bounce(p, q) at time 2   {Bounce}
  [1]

A body whose event is still to come at that instant has its value before it or after it, and no other; all bodies of the
event have the same.

  $ sed '/ t = /d' pairs.sc > near.sc
  $ burst() { printf "time,event,bodies,vx\n2.0,bounce,r;s,\n2.0,state,p,$1\n2.0,bounce,p;q,\n2.0,state,p,0\n" | scc conform near.sc - --tolerance 1e-5; }
  $ burst 1
  <standard input>: conforms: 2 events, a run of 4 transitions up to time 2.000001
    off by at most 1/1000000 in time, 0 in position, 0 in velocity (tolerance 1/100000)
  $ burst 0
  <standard input>: conforms: 2 events, a run of 4 transitions up to time 2.000001
    off by at most 1/1000000 in time, 0 in position, 0 in velocity (tolerance 1/100000)
  $ burst 1000000
  <standard input>: diverges at line 3, time 2: wrong-velocity
    the trace: a state
    of p, vx is 1000000 in the trace, and 0, off by 1000000
    rules: Bounce, Response
    what differs:
      p: vx: 1000000 in the trace, 0 expected
    after: bounce(r, s) at time 2.000001   {Bounce}
  [1]
  $ both() { printf '{"type":"transition","time":2.0,"label":{"kind":"bounce","between":["r","s"]},"state":{"processes":[{"leaves":[{"name":"p"}],"velocity":[%s,0,0]},{"leaves":[{"name":"q"}],"velocity":[%s,0,0]}]}}\n{"type":"transition","time":2.0,"label":{"kind":"bounce","between":["p","q"]}}\n' $1 $2 | scc conform near.sc - --tolerance 1e-5; }
  $ both 1.0 0.0
  <standard input>: conforms: 2 events, a run of 4 transitions up to time 2.000001
    off by at most 1/1000000 in time, 0 in position, 0 in velocity (tolerance 1/100000)
  $ both 0.0 1.0
  <standard input>: conforms: 2 events, a run of 4 transitions up to time 2.000001
    off by at most 1/1000000 in time, 0 in position, 0 in velocity (tolerance 1/100000)
  $ both 0.0 0.0
  <standard input>: diverges at line 1, time 2: wrong-velocity
    the trace: a state
    of q, vx is 0 in the trace, and 1, off by -1
    rules: Bounce, Response
    what differs:
      q: vx: 0 in the trace, 1 expected
    after: bounce(r, s) at time 2.000001   {Bounce}
  [1]

Where a body is before an event that happens a little earlier in the model.

  $ sed 's|4 + 1/1000000,9|4,9|; s|4,0,0|4 - 1/1000,0,0|' near.sc > early.sc
  $ place() { printf "time,event,bodies,x,vx\n2.0,bounce,r;s,,\n2.0,state,p,$1,1\n2.0,bounce,p;q,,\n" | scc conform early.sc - --tolerance 1/500; }
  $ place 2.0
  <standard input>: conforms: 2 events, a run of 4 transitions up to time 2
    off by at most 1/1000 in time, 1/1000 in position, 0 in velocity (tolerance 1/500)
  $ place 2.1
  <standard input>: diverges at line 3, time 2: wrong-position
    the trace: a state
    of p, x is 21/10 in the trace, and 1999/1000, off by 101/1000
    rules: Time
    what differs:
      p: x: 21/10 in the trace, 1999/1000 expected
      p: vx: 1 in the trace, 0 expected
    after: bounce(r, s) at time 2   {Bounce}
  [1]

Divergences.

  $ conform() { m=$1; t=$2; shift 2; printf "time,event,bodies,channel,features,x,vx\n$t" | scc conform $M/$m.sc - "$@"; }
  $ conform latch '7/4,bind,p;q\n'
  <standard input>: diverges at line 2, time 7/4: wrong-time
    the trace: bind(p, q)
    bind(dock, p.right, q.left) is allowed at time 2: the trace is 1/4 too early
    rules: Ftoc, Collision
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '2,bounce,p;q\n'
  <standard input>: diverges at line 2, time 2: wrong-kind
    the trace: bounce(p, q)
    bind(dock, p.right, q.left) is allowed there: a collision with a candidate never bounces
    rules: Bind, Bounce
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '2,bind,p;q,dock,p.right;q.top\n'
  <standard input>: diverges at line 2, time 2: wrong-features
    the trace: bind(dock, p.right, q.top)
    bind(dock, p.right, q.left) is allowed there, by other features
    rules: Bind, Collision
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '2,bind,p;q,lock\n'
  <standard input>: diverges at line 2, time 2: wrong-channel
    the trace: bind(lock, p, q)
    bind(dock, p.right, q.left) is allowed there, by another channel
    rules: Bind, Collision
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '3,end\n'
  <standard input>: diverges at line 2, time 3: missing-event
    the trace: nothing more up to this time
    bind(dock, p.right, q.left) has to happen at time 2, and was not recorded: no time passes while bodies collide
    rules: Collision, Time
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '2,end\n'
  <standard input>: diverges at line 2, time 2: missing-event
    the trace: nothing more up to this time
    bind(dock, p.right, q.left) has to happen at time 2, and was not recorded: no time passes while bodies collide
    rules: Collision, Time
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '2,bind,p;q\n2,weak,p;q\n3,weak,p;q\n'
  <standard input>: diverges at line 4, time 3: extra-event
    the trace: weak(p, q)
    nothing can happen any more
    rules: Quiescent, WeakSplit, I-9
    after: weak(dock, p.right, q.left) at time 2   {WeakSplit, Weak, Def}
  [1]
  $ conform latch '2,bind,p;q\n2,quiescent\n'
  <standard input>: diverges at line 3, time 2: wrong-ending
    the trace: nothing will ever happen again
    the trace claims that nothing can happen any more, and something can
    rules: Quiescent
    allowed there:
      weak(dock, p.right, q.left) at time 2   {WeakSplit, Weak, Def}
      weak(dock, p.right, q.left) at time 3   {WeakSplit, Weak, Def}
    after: bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '0,state,p,,,-3,-1\n'
  <standard input>: diverges at line 2, time 0: wrong-velocity
    the trace: a state
    of p, vx is -1 in the trace, and 1, off by -2
    rules: Time
    what differs:
      p: vx: -1 in the trace, 1 expected
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '1,state,p,,,-5/2\n'
  <standard input>: diverges at line 2, time 1: wrong-position
    the trace: a state
    of p, x is -5/2 in the trace, and -2, off by -1/2
    rules: Time
    what differs:
      p: x: -5/2 in the trace, -2 expected
    allowed there:
      bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform latch '2,bind,p;q\n1,state,p\n'
  <standard input>: diverges at line 3, time 1: time-back
    the trace: a state
    the times of the trace decrease
    rules: Time
    allowed there:
      weak(dock, p.right, q.left) at time 2   {WeakSplit, Weak, Def}
    after: bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]
  $ conform chain '3,bind,c[2];c[3]\n1,bind,c[1];c[2]\n'
  <standard input>: diverges at line 2, time 3: wrong-order
    the trace: bind(c[2], c[3])
    bind(link, c[1].right, c[2].left) has to come before it, and the trace has it later
    rules: Successors, Time
    allowed there:
      bind(link, c[1].right, c[2].left) at time 1   {Bind, Pre, Sum, Def}
  [1]
  $ conform chain '1,bind,c[2];c[3]\n3,bind,c[1];c[2]\n'
  <standard input>: diverges at line 2, time 1: wrong-order
    the trace: bind(c[2], c[3])
    bind(link, c[1].right, c[2].left) has to come before it, and the trace has it later
    rules: Successors, Time
    allowed there:
      bind(link, c[1].right, c[2].left) at time 1   {Bind, Pre, Sum, Def}
  [1]
  $ conform dimer '4,end\n'
  <standard input>: diverges at line 2, time 4: missing-event
    the trace: nothing more up to this time
    strong({<bond, {s1.right, s2.left}>}) has to happen at time 3, and was not recorded: a strong split that is enabled is urgent
    rules: StrongSplit, Time
    allowed there:
      weak(bond, w1.right, w2.left) at time 2   {WeakSplit, Weak}
      weak(bond, w1.right, w2.left) at time 5/2   {WeakSplit, Weak}
      weak(bond, w1.right, w2.left) at time 3   {WeakSplit, Weak}
      strong({<bond, {s1.right, s2.left}>}) at time 3   {StrongSplit, Strong}
  [1]
  $ conform rattle '3,end\n' --unobserved bounce
  <standard input>: diverges at line 2, time 3: wrong-time
    the trace: nothing more up to this time
    time does not come to this instant
    rules: Time
  [1]
  $ conform latch '2,bind,p;q\n3.25,weak,p;q\n' --tolerance 1/1000 --json
  {
    "format": "scc-conform",
    "version": 1,
    "semantics": "3",
    "verdict": "diverges",
    "exit": 1,
    "model": {
      "file": "../../specs/models/latch.sc",
      "name": "latch",
      "digest": "md5:739f161b03f9d0afa832dad47dd2a07f",
      "parameters": {},
      "settings": {"split step": "1"}
    },
    "trace": {"file": "<standard input>", "format": "csv", "events": 2, "items": 2},
    "tolerance": {"exact": "1/1000", "about": "0.001"},
    "run": null,
    "divergence": {
      "kind": "wrong-time",
      "at": {
        "line": 3,
        "time": {"exact": "13/4", "about": "3.25"},
        "what": "event",
        "event": {"kind": "weak", "channels": [], "bodies": ["p", "q"], "features": []}
      },
      "rules": ["WeakSplit", "I-9"],
      "why": "weak(dock, p.right, q.left) is allowed at time 3: the trace is 1/4 too late",
      "closest": {
        "label": {
          "kind": "weak",
          "text": "weak(dock, p.right, q.left)",
          "name": "dock",
          "ends": ["p.right", "q.left"]
        },
        "rules": ["WeakSplit", "Weak", "Def"],
        "time": {"exact": "3/1", "about": "3"}
      },
      "off": {"exact": "1/4", "about": "0.25"},
      "differences": [],
      "allowed": [
        {
          "label": {
            "kind": "weak",
            "text": "weak(dock, p.right, q.left)",
            "name": "dock",
            "ends": ["p.right", "q.left"]
          },
          "rules": ["WeakSplit", "Weak", "Def"],
          "time": {"exact": "2/1", "about": "2"}
        },
        {
          "label": {
            "kind": "weak",
            "text": "weak(dock, p.right, q.left)",
            "name": "dock",
            "ends": ["p.right", "q.left"]
          },
          "rules": ["WeakSplit", "Weak", "Def"],
          "time": {"exact": "3/1", "about": "3"}
        },
        {
          "label": {
            "kind": "weak",
            "text": "weak(dock, p.right, q.left)",
            "name": "dock",
            "ends": ["p.right", "q.left"]
          },
          "rules": ["WeakSplit", "Weak", "Def"],
          "time": {"exact": "4/1", "about": "4"}
        }
      ],
      "after": {
        "label": {
          "kind": "bind",
          "text": "bind(dock, p.right, q.left)",
          "name": "dock",
          "ends": ["p.right", "q.left"]
        },
        "rules": ["Bind", "Pre", "Def"],
        "time": {"exact": "2/1", "about": "2"}
      }
    },
    "reason": null,
    "diagnostics": []
  }
  [1]

Split clocks run in a circle.

  $ clock() { printf '{"type":"transition","time":2,"label":{"kind":"bind","bodies":["p","q"]}}\n{"type":"state","time":3,"state":{"processes":[{"clock":%s,"leaves":[{"name":"p"},{"name":"q"}]}]}}\n' $1 | scc conform $M/latch.sc - --tolerance 1e-6; }
  $ clock 0.9999999
  <standard input>: conforms: 1 event, a run of 3 transitions up to time 3
    off by at most 0 in time, 0 in position, 0 in velocity (tolerance 1/1000000)
  $ clock 0.9
  <standard input>: diverges at line 2, time 3: wrong-clock
    the trace: a state
    of p, clock is 9/10 in the trace, and 0, off by 9/10
    rules: I-9
    what differs:
      p: clock: 9/10 in the trace, 0 expected
      q: clock: 9/10 in the trace, 0 expected
    allowed there:
      weak(dock, p.right, q.left) at time 2   {WeakSplit, Weak, Def}
      weak(dock, p.right, q.left) at time 3   {WeakSplit, Weak, Def}
      weak(dock, p.right, q.left) at time 4   {WeakSplit, Weak, Def}
    after: bind(dock, p.right, q.left) at time 2   {Bind, Pre, Def}
  [1]

Invalid traces.

  $ conform latch '2,bind,p;r\n'
  <standard input>:2:1: error[SC0804]: the model has no body `r`
     |
   2 | 2,bind,p;r
     | ^^^^^^^^^^
    hint: did you mean `p`?
  [3]
  $ conform latch '2,bind,p;q,,p.right;q.lleft\n'
  <standard input>:2:1: error[SC0804]: the model has no feature `q.lleft`
     |
   2 | 2,bind,p;q,,p.right;q.lleft
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^
    hint: did you mean `q.left`?
  [3]
  $ conform latch '2,bump,p;q\n'
  <standard input>:2:1: error[SC0804]: `bump` is none of bind, close, bounce, absorb, weak, strong, draw, state, time, end, quiescent and stuck
     |
   2 | 2,bump,p;q
     | ^^^^^^^^^^
  [3]
  $ conform latch '2,bounce,p\nx,end\n2,end,p\n2,bounce,p;q,dock\n'
  <standard input>:2:1: error[SC0804]: a bounce is of two bodies or more, not of 1
     |
   2 | 2,bounce,p
     | ^^^^^^^^^^
  <standard input>:3:1: error[SC0804]: `time` is no number: `x`
     |
   3 | x,end
     | ^^^^^
  <standard input>:4:1: error[SC0804]: a row `end` has nothing in the column `bodies`
     |
   4 | 2,end,p
     | ^^^^^^^
  <standard input>:5:1: error[SC0804]: a row `bounce` has nothing in the column `channel`
     |
   5 | 2,bounce,p;q,dock
     | ^^^^^^^^^^^^^^^^^
  [3]
  $ printf 'time,what\n' | scc conform $M/latch.sc -
  <standard input>:1:1: error[SC0804]: there is no column `what`
     |
   1 | time,what
     | ^^^^^^^^^
  [3]
  $ printf 'time,event\n"2,end\n' | scc conform $M/latch.sc -
  <standard input>:2:1: error[SC0804]: a quote is not closed
     |
   2 | "2,end
     | ^^^^^^
  [3]
  $ scc conform $M/latch.sc - < /dev/null
  <standard input>:1:1: error[SC0804]: the trace is empty
     |
   1 | 
     | ^
  [3]
  $ printf '{"type":"end"}\n' | scc conform $M/latch.sc -
  <standard input>:1:1: error[SC0804]: there is no `time`
     |
   1 | {"type":"end"}
     | ^^^^^^^^^^^^^^
  [3]
  $ printf '{"type":"end","time":1\n' | scc conform $M/latch.sc -
  <standard input>:1:1: error[SC0804]: this is not JSON
     |
   1 | {"type":"end","time":1
     | ^^^^^^^^^^^^^^^^^^^^^^
  [3]
  $ printf '{"type":"transition","time":1,"label":{"kind":"bounce","between":["p"]}}\n' | scc conform $M/latch.sc -
  <standard input>:1:1: error[SC0804]: a bounce is of two bodies or more, `between`
     |
   1 | {"type":"transition","time":1,"label":{"kind":"bounce","between":["p"]}}
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  [3]
  $ scc trace $M/dimer.sc | scc conform $M/latch.sc -
  <standard input>:1:1: error[SC0804]: the trace is of another model, or of another text of this one
     |
   1 | {"type":"header","format":"scc-trace","version":1,"semantics":"3","model":"dimer","digest":"md5:51af2680225f350ea6157f06
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    hint: remove its `digest` to look at it all the same
  [3]
  $ scc trace $M/chain.sc | scc conform $M/chain.sc - -D n=5
  command line: error[SC0804]: the trace was made with another value of `n` than -D gives
  [64]
  $ scc trace $M/chain.sc | scc conform $M/chain.sc - -D n=4
  <standard input>: conforms: 3 events, a run of 6 transitions up to time 6
  $ printf 'time,event\n0.5,end\n' | scc conform $M/pocket.sc - --tolerance 1e-9
  <standard input>:2:1: error[SC0804]: the tolerance is less than the resolution of the model, 1/2097152
     |
   2 | 0.5,end
     | ^^^^^^^
  [3]
  $ conform latch '2,bind,p;q\n' --tolerance=-1
  scc: option '--tolerance': `-1' is negative, and no tolerance
  Usage: scc conform [OPTION]… MODEL TRACE
  Try 'scc conform --help' or 'scc --help' for more information.
  [64]
  $ scc conform - -
  scc: only one of the two can be read from standard input
  [64]
  $ scc diff - -
  scc: only one of the two can be read from standard input
  [64]

Differences.

  $ scc trace $M/billiard.sc --steps 8 > b1.jsonl
  $ sed 's/"-5\/4","1\/4"/"-5\/4","1\/3"/' b1.jsonl > b2.jsonl
  $ scc diff b1.jsonl b2.jsonl
  the traces differ: before any event, y of p, by 1/12
    b1.jsonl, line 3, time 5/4: 1/4
    b2.jsonl, line 3, time 5/4: 1/3
  [1]
  $ scc diff b1.jsonl b2.jsonl --json
  {
    "format": "scc-diff",
    "version": 1,
    "verdict": "different",
    "exit": 1,
    "tolerance": {"exact": "0/1", "about": "0"},
    "first": {
      "file": "b1.jsonl",
      "format": "jsonl",
      "digest": "md5:76ae3a5e5dd37535f4057e5590699fbb",
      "events": 4
    },
    "second": {
      "file": "b2.jsonl",
      "format": "jsonl",
      "digest": "md5:76ae3a5e5dd37535f4057e5590699fbb",
      "events": 4
    },
    "difference": {
      "kind": "state",
      "event": 0,
      "first": {"line": 3, "time": {"exact": "5/4", "about": "1.25"}, "event": null},
      "second": {"line": 3, "time": {"exact": "5/4", "about": "1.25"}, "event": null},
      "body": "p",
      "quantity": "y",
      "told": ["1/4", "1/3"],
      "off": {"exact": "1/12", "about": "0.0833333333"}
    },
    "diagnostics": []
  }
  [1]
  $ head -5 b1.jsonl > b3.jsonl
  $ scc diff b1.jsonl b3.jsonl
  the traces differ: only one has an event 2
    b1.jsonl, line 6, time 5/2: bounce(wall[4], q)
    b3.jsonl: nothing more
  [1]
  $ sed 's/wall\[4\]/wall[3]/g' b1.jsonl | scc diff b1.jsonl -
  the traces differ: before any event, y of wall[3], by 10
    b1.jsonl, line 2, time 0: -5
    <standard input>, line 2, time 0: 5
  [1]
  $ sed 's/"choice":0,"of":1,"label":{"kind":"bounce"/"choice":1,"of":2,"label":{"kind":"bounce"/' b1.jsonl | scc diff b1.jsonl -
  the traces differ: event 1 is another choice: 0, and 1 in the second
    b1.jsonl, line 4, time 5/4: bounce(p, q)
    <standard input>, line 4, time 5/4: bounce(p, q)
  [1]
  $ sed 's/\["Bounce"\]/["Bind"]/' b1.jsonl | scc diff b1.jsonl -
  the traces differ: event 1 is by other rules: {Bounce}, and {Bind} in the second
    b1.jsonl, line 4, time 5/4: bounce(p, q)
    <standard input>, line 4, time 5/4: bounce(p, q)
  [1]
  $ scc trace $M/chain.sc > n4.jsonl
  $ scc trace $M/chain.sc -D n=3 > n3.jsonl
  $ scc diff n4.jsonl n3.jsonl
  the traces differ in the parameter n: they are not of one model
    n4.jsonl: 4
    n3.jsonl: 3
  [1]
  $ scc diff n4.jsonl b1.jsonl
  the traces differ in the digest: they are not of one model
    n4.jsonl: md5:d6ee0fc69e28f1cc80c7acb9e21ab0bd
    b1.jsonl: md5:76ae3a5e5dd37535f4057e5590699fbb
  [1]

A state at another time, a body under another name, and another end are differences.

  $ sed '2s/"time":"0\/1"/"time":"1\/2"/' b1.jsonl | scc diff b1.jsonl -
  the traces differ: before any event, time of wall[1], by 1/2
    b1.jsonl, line 2, time 0: 0
    <standard input>, line 2, time 1/2: 1/2
  [1]
  $ sed '2s/"p"/"r"/; 2s/"-5\/1","1\/4"/"-4\/1","1\/4"/' b1.jsonl | scc diff b1.jsonl -
  the traces differ: before any event, name of p
    b1.jsonl, line 2, time 0: p
    <standard input>, line 2, time 0: r
  [1]
  $ sed '2s/"p"/"wall[9]"/' b1.jsonl | scc diff - b1.jsonl --json | grep -A 9 '"kind"'
      "kind": "state",
      "event": 0,
      "first": {"line": 2, "time": {"exact": "0/1", "about": "0"}, "event": null},
      "second": {"line": 2, "time": {"exact": "0/1", "about": "0"}, "event": null},
      "body": "wall[9]",
      "quantity": "name",
      "told": ["wall[9]", "p"],
      "off": null
    },
    "diagnostics": []
  $ tail -1 b1.jsonl
  {"type":"end","steps":8,"time":"7/2","ending":"open"}
  $ sed '$s/"time":"[^"]*"/"time":"9\/1"/' b1.jsonl | scc diff b1.jsonl -
  the traces differ in the time at which they end, by 11/2
    b1.jsonl, line 11: 7/2
    <standard input>, line 11: 9
  [1]
  $ sed '$s/"open"/"quiescent"/' b1.jsonl | scc diff b1.jsonl -
  the traces differ in how they say that they end
    b1.jsonl, line 11: open
    <standard input>, line 11: quiescent
  [1]
  $ sed '$d' b1.jsonl | scc diff b1.jsonl -
  the traces are the same: 4 events
  $ printf 'time,event,bodies,x\n1,state,p,0\n1,state,q,3\n' > s1.csv
  $ printf 'time,event,bodies,x\n1,state,p,0\n2,state,q,3\n' | scc diff s1.csv -
  the traces differ: before any event, time of q, by 1
    s1.csv, line 3, time 1: 1
    <standard input>, line 3, time 2: 2
  [1]
  $ printf 'time,event,bodies,x\n1,state,p,0\n1.5,state,p,1\n1,state,q,3\n' | scc diff s1.csv - --tolerance 0
  the traces are the same: 0 events
  $ printf 'time,event,bodies,x\n1,state,p,0\n' | scc diff s1.csv -
  the traces are the same: 0 events
  $ printf 'time,event\n5,end\n' > e1.csv
  $ printf 'time,event\n6,end\n' | scc diff e1.csv -
  the traces differ in the time at which they end, by 1
    e1.csv, line 2: 5
    <standard input>, line 2: 6
  [1]

A byte order mark is not read, and no column.

  $ mark() { printf '\357\273\277'; cat $1; }
  $ mark b1.jsonl | scc diff b1.jsonl -
  the traces are the same: 4 events
  $ mark exact.csv | scc conform $M/latch.sc -
  <standard input>: conforms: 2 events, a run of 4 transitions up to time 3
  $ mark b1.jsonl > marked.jsonl
  $ scc trace $M/billiard.sc --schedule marked.jsonl | scc diff b1.jsonl -
  the traces are the same: 4 events
  $ printf 'tim,event\n' > wrong.csv
  $ mark wrong.csv | scc diff s1.csv -
  <standard input>:1:1: error[SC0804]: there is no column `tim`
     |
   1 | tim,event
     | ^^^^^^^^^
    hint: did you mean `time`?
  [3]
  $ printf 'des (0, 1, 2)\n(0, "a", 1)\n' > one.aut
  $ mark one.aut > marked.aut
  $ scc compare one.aut marked.aut
  equivalent modulo branching
  one.aut: 2 states, 1 transition, 2 classes; complete
  marked.aut: 2 states, 1 transition, 2 classes; complete

What is told between events, or after the last, has times that do not decrease either.

  $ conform latch '2,bind,p;q\n3,weak,p;q\n1,quiescent\n'
  <standard input>: diverges at line 4, time 1: time-back
    the trace: nothing will ever happen again
    the times of the trace decrease
    rules: Time
    after: weak(dock, p.right, q.left) at time 3   {WeakSplit, Weak, Def}
  [1]
  $ conform latch '2,bind,p;q\n3,weak,p;q\n10,end\n5,time\n'
  <standard input>: diverges at line 5, time 5: time-back
    the trace: nothing more up to this time
    the times of the trace decrease
    rules: Time
    after: weak(dock, p.right, q.left) at time 3   {WeakSplit, Weak, Def}
  [1]

The bonds of a reaction are told by name and ends together; two of them that swap either are others.

  $ scc trace $M/hexokinase.sc --choose random:2 --states=ends > h.jsonl
  $ scc conform $M/hexokinase.sc h.jsonl
  h.jsonl: conforms: 3 events, a run of 4 transitions up to time 2
  $ sed '/"strong"/ { s/"name":"atp"/"name":"x"/; s/"name":"glc"/"name":"atp"/; s/"name":"x"/"name":"glc"/ }' h.jsonl > h2.jsonl
  $ scc conform $M/hexokinase.sc h2.jsonl
  h2.jsonl: diverges at line 6, time 2: wrong-features
    the trace: strong(<atp, {enzyme.floorB.top, glucose.bottom}>, <glc, {atp.bottom, enzyme.floorA.top}>)
    strong({<atp, {enzyme.floorA.top, atp.bottom}>, <glc, {enzyme.floorB.top, glucose.bottom}>}) is allowed there, by other features
    rules: StrongSplit
    allowed there:
      weak(glc, enzyme.floorB.top, glucose.bottom) at time 2   {WeakSplit, Weak, Sum, Def}
      weak(atp, enzyme.floorA.top, atp.bottom) at time 2   {WeakSplit, Weak, Sum, Def}
      strong({<atp, {enzyme.floorA.top, atp.bottom}>, <glc, {enzyme.floorB.top, glucose.bottom}>}) at time 2   {StrongSplit, Strong, Sum, Def}
    after: bind(atp, enzyme.floorA.top, atp.bottom) at time 2   {Bind, Pre, Sum, Def}
  [1]
  $ scc diff h.jsonl h2.jsonl
  the traces differ: event 3 is another
    h.jsonl, line 6, time 2: strong(<atp, {atp.bottom, enzyme.floorA.top}>, <glc, {enzyme.floorB.top, glucose.bottom}>)
    h2.jsonl, line 6, time 2: strong(<atp, {enzyme.floorB.top, glucose.bottom}>, <glc, {atp.bottom, enzyme.floorA.top}>)
  [1]

A body and a feature of one of its parts are the same to a comparison.

  $ printf 'time,event,bodies\n2,bind,enzyme;glucose\n2,bind,enzyme;atp\n2,strong,enzyme;atp;glucose\n' > h.csv
  $ scc diff h.csv h.jsonl
  the traces are the same: 3 events
  $ sed 's/bind,enzyme;atp/bind,glucose;atp/' h.csv | scc diff - h.jsonl
  the traces differ: event 2 is another
    <standard input>, line 3, time 2: bind(glucose, atp)
    h.jsonl, line 5, time 2: bind(atp, atp.bottom, enzyme.floorA.top)
  [1]

Bodies that are gone: who says that one is there is wrong, and so is who says that another is gone.

  $ scc trace $M/outlet.sc --time 8 > out.jsonl
  $ grep -c '"kind":"absorb"' out.jsonl
  1
  $ scc conform $M/outlet.sc out.jsonl
  out.jsonl: conforms: 6 events, a run of 11 transitions up to time 7
  $ printf 'time,event,bodies\n2,bind,first;enzyme\n3,strong,first;enzyme\n3,bounce,shuttle;roof\n11/3,bounce,first;second\n5,bounce,first;enzyme\n7,absorb,second;outlet\n' > out.csv
  $ scc conform $M/outlet.sc out.csv
  out.csv: conforms: 6 events, a run of 11 transitions up to time 7
  $ sed 's/7,absorb/7,bounce/' out.csv | scc conform $M/outlet.sc -
  <standard input>: diverges at line 7, time 7: wrong-kind
    the trace: bounce(second, outlet)
    absorb(second, outlet) is allowed there: what hits a body that absorbs never bounces
    rules: Bind, Bounce
    allowed there:
      absorb(second, outlet) at time 7   {Absorb}
    after: bounce(enzyme, first) at time 5   {Bounce}
  [1]
  $ (cat out.csv; echo '8,absorb,first') | scc conform $M/outlet.sc -
  <standard input>:8:1: error[SC0804]: a row `absorb` is of two bodies, who is gone and who took it, not of 1
     |
   8 | 8,absorb,first
     | ^^^^^^^^^^^^^^
  [3]
  $ gone() { (sed '/"kind":"absorb"/q' out.jsonl; printf '{"type":"state","time":7,"state":{"processes":[%s],"gone":[%s]}}\n' "$1" "$2") | scc conform $M/outlet.sc -; }
  $ gone '' '"second"'
  <standard input>: conforms: 6 events, a run of 11 transitions up to time 7
  $ gone '' '"first"'
  <standard input>: diverges at line 14, time 7: wrong-presence
    the trace: a state
    of first, presence is gone in the trace, and there
    rules: Absorb
    what differs:
      first: presence: gone in the trace, there expected
    allowed there:
      bounce(shuttle, ground) at time 9   {Bounce}
    after: absorb(second, outlet) at time 7   {Absorb}
  [1]
  $ gone '{"leaves":[{"name":"second"}]}' ''
  <standard input>: diverges at line 14, time 7: wrong-presence
    the trace: a state
    of second, presence is there in the trace, and gone
    rules: Absorb
    what differs:
      second: presence: there in the trace, gone expected
    allowed there:
      bounce(shuttle, ground) at time 9   {Bounce}
    after: absorb(second, outlet) at time 7   {Absorb}
  [1]

Bonds that lots release at once (rule Lot) may be told one by one, in any order, and none of them may be missing.

  $ cat > pairs.sc <<END
  > split_step 1
  > shape Cube = box(1, 1, 1)
  > process p = Cube mass 1 [omega(a, {right}) chance 1 . nil]
  > process q = Cube mass 1 at translate (1, 0, 0) [omega(a, {left}) . nil]
  > process u = Cube mass 1 at translate (10, 0, 0) [omega(b, {right}) push(1) chance 1/2 . nil]
  > process v = Cube mass 1 at translate (11, 0, 0) [omega(b, {left}) . nil]
  > bond <a, {p.right, q.left}>
  > bond <b, {u.right, v.left}>
  > END
  $ told() { (echo time,event,bodies,channel; printf "$1\n") > told.csv; shift; scc conform pairs.sc told.csv "$@"; }
  $ told '1,weak,p;q,\n1,weak,u;v,\n3/2,end,,'
  told.csv: conforms: 2 events, a run of 4 transitions up to time 1
    it could be in 2 states at once
  $ told '1,weak,u;v,b\n1,weak,p;q,a\n3/2,end,,'
  told.csv: conforms: 2 events, a run of 4 transitions up to time 1
  $ told '1,weak,p;q,\n2,weak,u;v,\n5/2,end,,'
  told.csv: conforms: 2 events, a run of 7 transitions up to time 2
    it could be in 2 states at once
  $ told '1,weak,u;v,\n3/2,end,,'
  told.csv: diverges at line 3, time 3/2: wrong-time
    the trace: nothing more up to this time
    time does not come to this instant
    rules: Time
    allowed there:
      bounce(q, u) at time 9   {Bounce}
    after: weak({<a, {p.right, q.left}>, <b, {u.right, v.left}> push(1)}) at time 1   {WeakSplit, Weak}
  [1]
  $ told '1,weak,u;v,\n3/2,end,,' --unobserved 'weak(a, *)'
  told.csv: conforms: 1 event, a run of 4 transitions up to time 1
  $ told '3/2,end,,' --unobserved 'weak(b, *)'
  told.csv: diverges at line 2, time 3/2: wrong-time
    the trace: nothing more up to this time
    time does not come to this instant
    rules: Time
    allowed there:
      weak(a, p.right, q.left) at time 1   {WeakSplit, Weak}
      weak({<a, {p.right, q.left}>, <b, {u.right, v.left}> push(1)}) at time 1   {WeakSplit, Weak}
  [1]
  $ scc trace pairs.sc --choose random:1 -o told.jsonl && scc conform pairs.sc told.jsonl
  told.jsonl: conforms: 4 events, a run of 10 transitions up to time 10
    it could be in 4 states at once
  $ grep -o '"kind":"weak","text":"[^"]*"' told.jsonl
  "kind":"weak","text":"weak(a, p.right, q.left)"
  "kind":"weak","text":"weak(b, u.right, v.left) push(1)"
