Why a run leads where it does: y pushes p, which comes back from the wall, and x has pushed y out of its way.

  $ cat > billiard.sc <<'EOF'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > param m = 1/2
  > process y = Cube mass 1 velocity (2,0,0) at translate (-10,0,0) [nil]
  > process p = Cube mass 1 at translate (0,0,0) [nil]
  > fixed wall = Cube at translate (10,0,0)
  > process r = Cube mass 1 velocity (1,0,0) at translate (0,0,50) [nil]
  > process s = Cube mass 1 at translate (5,0,50) [nil]
  > process x = Cube mass m velocity (0,-2,0) at translate (-2,20,0) [nil]
  > check back : possibly x(p) < -3
  > check far  : always x(p) < 7
  > EOF
  $ scc check billiard.sc --witness runs > /dev/null
  [1]
  $ scc explain runs/back.json
  back: possibly x(p) < -3
  at time 29/2:
    x(p) < -3 holds: x(p) = -5
  because of step 6 (motion of p)
  
     1-3. one event that does not matter (of r and s), to time 4
  *    4. y and p collide and bounce, at time 4
           because of how everything started
       5. time passes by 4, at time 8
  *    6. p and wall collide and bounce, at time 8
           because of step 4 (motion of p)
       7. time passes by 1, at time 9
  *    8. y and x collide and bounce, at time 9
           keeps bodies out of the way; because of step 4 (motion of y)
  
  3 of 4 events matter
  x matters by what it keeps away: without it, x(p) < -3 fails: x(p) = 0 at the end
  checked: the same happens without r and s
  $ scc explain runs/far.json
  far: always x(p) < 7
  at time 8:
    x(p) < 7 fails: x(p) = 8
  because of step 4 (motion of p)
  
     1-3. one event that does not matter (of r and s), to time 4
  *    4. y and p collide and bounce, at time 4
           because of how everything started
       5. time passes by 4, at time 8
  
  1 of 2 events matter
  checked: the same happens without wall, r, s and x

For another check, and for a trace: without a check, the last event is explained.

  $ scc explain runs/far.json --check back
  back: possibly x(p) < -3
  at time 8:
    x(p) < -3 fails: x(p) = 8
  because of step 4 (motion of p)
  
     1-3. one event that does not matter (of r and s), to time 4
  *    4. y and p collide and bounce, at time 4
           because of how everything started
       5. time passes by 4, at time 8
  
  1 of 2 events matter
  checked: the same happens without wall, r, s and x
  $ scc trace billiard.sc --time 9 > run.jsonl
  $ scc explain run.jsonl billiard.sc
  the last event
  because of step 8
  
     1-3. one event that does not matter (of r and s), to time 4
  *    4. y and p collide and bounce, at time 4
           because of how everything started
     5-7. one event that does not matter (of p and wall), to time 9
  *    8. y and x collide and bounce, at time 9
           because of step 4 (motion of y)
  
  2 of 4 events matter
  checked: the same happens without wall, r and s

Schedules of earlier versions name neither.

  $ sed '/"model":/d; /"check":/d' runs/back.json > old.json
  $ scc explain old.json billiard.sc | head -2
  the last event
  because of step 8
  $ scc explain old.json billiard.sc --check back | head -4
  back: possibly x(p) < -3
  at time 29/2:
    x(p) < -3 holds: x(p) = -5
  because of step 6 (motion of p)

Bonds.

  $ scc check ../../specs/models/chain.sc --witness chain > /dev/null
  [1]
  $ for run in chain/*.json; do scc explain $run || break; done
  free: always processes >= 2
  at time 6:
    processes >= 2 fails: processes = 1
  because of step 6 (bonds of c[1])
  
       1. time passes by 1, at time 1
  *    2. c[1] and c[2] collide and bind by <link, {c[1].right, c[2].left}>, at time 1
           because of how everything started
       3. time passes by 2, at time 3
  *    4. c[2] and c[3] collide and bind by <link, {c[2].right, c[3].left}>, at time 3
           because of step 2 (motion of c[2], bonds of c[2], behaviour of c[2])
       5. time passes by 3, at time 6
  *    6. c[3] and c[4] collide and bind by <link, {c[3].right, c[4].left}>, at time 6
           because of step 4 (motion of c[3], bonds of c[3], behaviour of c[3])
  
  3 of 3 events matter
  every body takes part: none could be left out to try

Errors.

  $ scc explain run.jsonl
  run.jsonl:1:1: error[SC0801]: this does not tell for which model it was made
     |
   1 | {"type":"header","format":"scc-trace","version":1,"semantics":"3","model":null,"digest":"md5:64665c2be453d10e7276c9ee238
     | ^
    hint: name the model: `scc explain WITNESS MODEL`
  [3]
  $ scc explain runs/back.json nowhere.sc
  nowhere.sc: error[SC0101]: cannot read: No such file or directory
  [3]
  $ scc explain runs/back.json --check bcak
  command line: error[SC0201]: the model has no check `bcak`
    hint: did you mean `back`?
  [64]
  $ sed 's/"back"/"front"/' runs/back.json > front.json
  $ scc explain front.json
  front.json:1:1: error[SC0801]: the model has no check `front`
     |
   1 | { "format": "scc-schedule",
     | ^
  [3]
  $ sed 's/"back"/3/' runs/back.json > number.json
  $ scc explain number.json
  number.json:1:1: error[SC0801]: `check` is not a text
     |
   1 | { "format": "scc-schedule",
     | ^
  [3]
  $ scc explain runs/back.json -D m=2
  command line: error[SC0801]: the schedule was made with another value of `m` than -D gives
  runs/back.json:1:1: note: it is here
     |
   1 | { "format": "scc-schedule",
     | ^
  [64]
  $ scc explain runs/back.json ../../specs/models/dimer.sc
  runs/back.json:1:1: error[SC0209]: the model has no parameter `m`
     |
   1 | { "format": "scc-schedule",
     | ^
  [3]
  $ grep -v digest runs/back.json > free.json
  $ scc explain free.json ../../specs/models/dimer.sc
  free.json:1:1: error[SC0209]: the model has no parameter `m`
     |
   1 | { "format": "scc-schedule",
     | ^
  [3]
  $ scc explain runs/back.json nowhere.sc --json
  {
    "format": "scc-diagnostics",
    "version": 1,
    "exit": 3,
    "diagnostics": [
      {
        "code": "SC0101",
        "severity": "error",
        "message": "cannot read: No such file or directory",
        "place": {"file": "nowhere.sc", "start": {"offset": 0}, "end": {"offset": 0}},
        "notes": [],
        "hint": null
      }
    ]
  }
  [3]

A run that ends in a dead end is explained up to there. That it is over is one of the facts, unless the check looks for
something that it has met.

  $ scc check ../../specs/models/topple.sc --witness topple > /dev/null 2>&1
  [1]
  $ scc explain topple/falls.json
  warning[SC0602]: persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch
  note: after step 4, at time 2
    hint: runs end there: the model is given up, and the calculus says nothing of what follows
  semantics 3: timestep 1, dynamics constant_spin, resolution 1/524288
  
  falls: AF z(p) < 0
  at time 2:
    z(p) < 0 fails: z(p) = 0
    the run is over: spike and p are in persistent contact
  because of step 4 (motion of p)
  
     1-3. one event that does not matter (of far and away), to time 2
  *    4. p and push collide and bounce, at time 2
           because of how everything started
         the run ends here, in a dead end: persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch
  
  1 of 2 events matter
  checked: the same happens without far and away
  $ scc explain topple/falls.json --json | grep -v '^  "digest'
  {
    "format": "scc-explanation",
    "version": 1,
    "semantics": "3",
    "model": "topple",
    "parameters": {},
    "settings": {"timestep": "1", "dynamics": "constant_spin", "resolution": "1/524288"},
    "exit": 0,
    "check": "falls",
    "formula": "AF z(p) < 0",
    "time": "2/1",
    "facts": ["z(p) < 0 fails: z(p) = 0", "the run is over: spike and p are in persistent contact"],
    "because": [{"step": 4, "what": "motion", "of": "p"}],
    "steps": [
      {
        "step": 1,
        "label": {"kind": "time", "text": "time(1/2)", "duration": "1/2"},
        "time": "1/2",
        "events": []
      },
      {
        "step": 2,
        "label": {
          "kind": "bounce",
          "text": "bounce(far, away)",
          "between": ["far", "away"],
          "touching": [["far", "away"]]
        },
        "time": "1/2",
        "events": [{"kind": "transition", "of": null, "role": "irrelevant", "because": []}]
      },
      {
        "step": 3,
        "label": {"kind": "time", "text": "time(3/2)", "duration": "3/2"},
        "time": "2/1",
        "events": []
      },
      {
        "step": 4,
        "label": {
          "kind": "bounce",
          "text": "bounce(p, push)",
          "between": ["p", "push"],
          "touching": [["p", "push"]]
        },
        "time": "2/1",
        "events": [{"kind": "transition", "of": null, "role": "cause", "because": []}]
      }
    ],
    "ending": "stuck",
    "left_out": [["far"], ["away"]],
    "keep_away": [],
    "diagnostics": [
      {
        "code": "SC0602",
        "severity": "warning",
        "message": "persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch",
        "place": null,
        "notes": [{"message": "after step 4, at time 2", "place": null}],
        "hint": "runs end there: the model is given up, and the calculus says nothing of what follows"
      }
    ]
  }
  $ scc explain topple/falls.json --check pushed 2> /dev/null
  semantics 3: timestep 1, dynamics constant_spin, resolution 1/524288
  
  pushed: possibly vx(p) > 0
  at time 2:
    vx(p) > 0 holds: vx(p) = 8/11
  because of step 4 (motion of p)
  
     1-3. one event that does not matter (of far and away), to time 2
  *    4. p and push collide and bounce, at time 2
           because of how everything started
         the run ends here, in a dead end: persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch
  
  1 of 2 events matter
  checked: the same happens without spike, far and away
