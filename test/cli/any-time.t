Bonds may be released at any time (split_step any): s arrives at 9/4, when p needs 1 from the release on to be ready.

  $ cat > window.sc <<'END'
  > model window
  > split_step any
  > shape Cube = box(2,2,2)
  > behaviour P on Cube = omega(b, {right}). eps(1). <c, {left}>. PC
  > behaviour Q on Cube = omega(b, {left}). eps(2). <a, {right}>. QA
  > behaviour S on Cube = <~c, {right}>. nil
  > behaviour R on Cube = <~a, {left}>. nil
  > behaviour PC on Cube = nil
  > behaviour QA on Cube = nil
  > process p = Cube mass 1 at translate (0,0,0) [P]
  > process q = Cube mass 1 at translate (2,0,0) [Q]
  > bond <b, {p.right, q.left}>
  > process s = Cube mass 1 velocity (1,0,0) at translate (-17/4,0,0) [S]
  > process r = Cube mass 1 velocity (-1,0,0) at translate (15/2,0,0) [R]
  > check alone : possibly event bounce(q, r)
  > END

A run that is not told otherwise splits where something else happens:

  $ scc trace window.sc --human --states=ends --steps 3 | grep '[0-9][.] '
      1.  p and q release <b, {p.right, q.left}> (choice 0 of 2)   {WeakSplit, Weak, Def}
    2-3.  time passes 2 times by 1   {Time, TimeBehaviour}

A schedule may let less time pass than until the next event, by the label of time:

  $ cat > some.json <<'END'
  > { "format": "scc-schedule", "version": 2, "choices": [
  >   { "label": "time(4/3)" }, { "choice": 1, "label": "time(1/24)" }, { "choice": 0 } ], "offset": "1/2" }
  > END
  $ scc trace window.sc --schedule some.json > run.jsonl
  $ scc trace window.sc --schedule run.jsonl | cmp - run.jsonl
  $ scc trace window.sc --schedule some.json --human --states=ends | grep '[0-9][.:] \|passes'
      1.  time passes by 4/3 (choice 1 of 2)   {Time, TimeBehaviour}
      2.  time passes by 1/24 (choice 1 of 2)   {Time, TimeBehaviour}
      3.  p and q release <b, {p.right, q.left}> (choice 0 of 2)   {WeakSplit, Weak, Def}
          time passes by 1/2
  3 transitions, time 15/8: more can happen

But not more, no time at all, and not on a grid:

  $ for t in 7/2 0 -1; do
  >   echo "{ \"format\": \"scc-schedule\", \"version\": 2, \"choices\": [ { \"label\": \"time($t)\" } ] }" > bad.json
  >   scc trace window.sc --schedule bad.json 2>&1 >/dev/null | grep 'error\|note'
  > done
  bad.json:1:56: error[SC0802]: step 1 at time 0: `time(7/2)` is not possible here
  note: possible there: 0: weak(b, p.right, q.left); 1: time(9/4), or any time before
  bad.json:1:56: error[SC0802]: step 1 at time 0: `time(0)` is not possible here
  note: possible there: 0: weak(b, p.right, q.left); 1: time(9/4), or any time before
  bad.json:1:56: error[SC0802]: step 1 at time 0: `time(-1)` is not possible here
  note: possible there: 0: weak(b, p.right, q.left); 1: time(9/4), or any time before
  $ sed 's/split_step any/split_step 3/' window.sc > grid.sc
  $ scc trace grid.sc --schedule some.json 2>&1 >/dev/null | grep 'error\|note'
  some.json:2:3: error[SC0802]: step 1 at time 0: `time(4/3)` is not possible here
  note: possible there: 0: weak(b, p.right, q.left); 1: time(9/4)

Where nothing else is to come, any time may pass:

  $ sed '/process [rs]/d; /check/d' window.sc > alone.sc
  $ cat > long.json <<'END'
  > { "format": "scc-schedule", "version": 2, "choices": [
  >   { "label": "time(1000)" }, { "choice": 1, "label": "time(1/3)" }, { "choice": 0 } ], "offset": "1/7" }
  > END
  $ scc trace alone.sc --schedule long.json 2>/dev/null > run.jsonl
  $ scc trace alone.sc --schedule run.jsonl 2>/dev/null | cmp - run.jsonl
  $ scc trace alone.sc --schedule long.json --human --states=ends 2>/dev/null | grep '[0-9][.:] \|passes'
      1.  time passes by 1000 (choice 1 of 2)   {Time, TimeBehaviour}
      2.  time passes by 1/3 (choice 1 of 2)   {Time, TimeBehaviour}
      3.  p and q release <b, {p.right, q.left}>   {WeakSplit, Weak, Def}
          time passes by 1/7
  3 transitions, time 21010/21: more can happen

The graph of all sets of states has passings of time that end before the next event, to zones that are halted for a split:

  $ scc explore window.sc -o window.json
  scc: semantics 3: split step any
  scc: explored: 115 zones, 120 edges; complete
  $ grep -c '"halted":true' window.json
  4
  $ scc explore window.sc -o - --format dot --depth 2 2>/dev/null | grep 'z[025] '
    z0 [label="0\n<b, {p.right, q.left}>\np: P\nq: Q"]
    z0 -> z1 [label="time(9/4)", color=gray]
    z0 -> z2 [label="time(time passed)\nwhere time passed >= 0, time passed < 9/4", color=gray]
    z2 [label="2\n<b, {p.right, q.left}>\np: P\nq: Q\nx(s) >= -17/4, x(s) < -2", style=dotted]
    z2 -> z5 [label="weak(b, p.right, q.left)"]
    z5 [label="5\np: eps(1). <c, {left}>. PC\nq: eps(2). <a, {right}>. QA\nx(s) >= -17/4, x(s) < -2", style=dashed]

What looks at one state after the other says so:

  $ scc explore window.sc -o out.aut 2>&1 | grep error
  error[SC0902]: bonds of this model may be released at any time (`split_step any`), and this looks at the instants of a grid
  $ scc compare window.sc window.sc 2>&1 | grep error
  error[SC0902]: bonds of this model may be released at any time (`split_step any`), and this looks at the instants of a grid

A run of such a model is explained, tried without who seems not to matter, as any other:

  $ cp ../../specs/models/moment.sc .
  $ echo 'process y1 = Cube mass 1 velocity (0,0,1) at translate (50,0,0) [nil]' >> moment.sc
  $ echo 'process y2 = Cube mass 1 at translate (50,0,5) [nil]' >> moment.sc
  $ scc check moment.sc --no-reduce slice,order --witness runs > /dev/null
  [1]
  $ scc explain runs/alone.json moment.sc
  semantics 3: split step any
  
  alone: possibly bound(q, y) and not bound(p, x) and time >= 7/2 within 4
  at time 7/2:
    bound(q, y) holds
    bound(p, x) fails
    time >= 7/2 holds: time = 7/2
  because of step 9 (bonds of q)
  
       1. time passes by 3/2, at time 3/2
  *    2. p and q release <hold, {p.right, q.left}>, at time 3/2
           because of how everything started
     3-7. 2 events that do not matter (of p, x, y1 and y2), to time 3
  *    8. time passes by 1/2, at time 7/2
           a delay of q is over, because of step 2 (behaviour of q)
  *    9. q and y collide and bind by <below, {q.bottom, y.top}>, at time 7/2
           because of step 2 (bonds of q), step 8 (behaviour of q)
  
  2 of 4 events matter
  checked: the same happens without y1 and y2

And traces are held against it, at the instants that they tell: both bind if p and q part up to the time 5/4.

  $ scc trace moment.sc --schedule runs/both.json > both.jsonl
  $ scc conform moment.sc both.jsonl
  both.jsonl: conforms: 4 events, a run of 9 transitions up to time 7/2
    it could be in 2 states at once
  $ cat > at.py <<'END'
  > import json, sys
  > for line in open("both.jsonl"):
  >     item = json.loads(line)
  >     if item["type"] == "transition" and item["label"]["kind"] != "time":
  >         if item["label"]["kind"] == "weak":
  >             item["time"] = sys.argv[1]
  >         del item["state"]
  >         print(json.dumps(item))
  >     elif item["type"] == "header":
  >         print(line, end="")
  > END
  $ for t in 1/2 5/4 4/3 2; do python3 at.py $t > at.jsonl; scc conform moment.sc at.jsonl; done
  at.jsonl: conforms: 4 events, a run of 10 transitions up to time 7/2
  at.jsonl: conforms: 4 events, a run of 9 transitions up to time 7/2
  at.jsonl: diverges at line 3, time 9/4: wrong-kind
    the trace: bind(above, p.top, x.bottom)
    bounce(p, x) is allowed there: the collision has no such candidate
    rules: Bind, Bounce
    allowed there:
      bounce(p, x) at time 9/4   {Bounce}
    after: weak(hold, p.right, q.left) at time 4/3   {WeakSplit, Weak, Def}
  at.jsonl: diverges at line 3, time 9/4: wrong-kind
    the trace: bind(above, p.top, x.bottom)
    bounce(p, x) is allowed there: the collision has no such candidate
    rules: Bind, Bounce
    allowed there:
      bounce(p, x) at time 9/4   {Bounce}
    after: weak(hold, p.right, q.left) at time 2   {WeakSplit, Weak, Def}
  [1]
  $ scc conform moment.sc both.jsonl --tolerance 1/10
  error[SC0902]: bonds of this model may be released at any time (`split_step any`), so that all events and their exact times have to be in the trace
    hint: leave out --tolerance and --unobserved, or give a `split_step`
  [3]
  $ scc conform moment.sc both.jsonl --unobserved weak
  error[SC0902]: bonds of this model may be released at any time (`split_step any`), so that all events and their exact times have to be in the trace
    hint: leave out --tolerance and --unobserved, or give a `split_step`
  [3]
