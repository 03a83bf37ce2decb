A run as JSON Lines.

  $ scc trace ../../specs/models/figure7.sc | sed 's/"md5:[^"]*"/"md5:…"/'
  {"type":"header","format":"scc-trace","version":1,"semantics":"3","model":"figure7","digest":"md5:…","parameters":{},"settings":{}}
  {"type":"state","time":"0/1","state":{"processes":[{"velocity":["0/1","0/1","0/1"],"clock":null,"leaves":[{"name":"P0","position":["0/1","0/1","0/1"],"behaviour":"Open0","origin":"Open0"}],"bonds":[]},{"velocity":["0/1","-1/1","0/1"],"clock":null,"leaves":[{"name":"s2","position":["109/41","4491/820","0/1"],"behaviour":"Open1","origin":"Open1"}],"bonds":[]}],"step":null}}
  {"type":"transition","step":1,"choice":0,"of":1,"label":{"kind":"time","text":"time(2)","duration":"2/1"},"rules":["Time","TimeBehaviour"],"time":"2/1","state":{"processes":[{"velocity":["0/1","0/1","0/1"],"clock":null,"leaves":[{"name":"P0","position":["0/1","0/1","0/1"],"behaviour":"Open0","origin":"Open0"}],"bonds":[]},{"velocity":["0/1","-1/1","0/1"],"clock":null,"leaves":[{"name":"s2","position":["109/41","2851/820","0/1"],"behaviour":"Open1","origin":"Open1"}],"bonds":[]}],"step":null}}
  {"type":"transition","step":2,"choice":0,"of":2,"label":{"kind":"bind","text":"bind(a, P0.s0.[v2,v3], s2.f4)","name":"a","ends":["P0.s0.[v2,v3]","s2.f4"]},"rules":["Bind","Pre","Def"],"time":"2/1","state":{"processes":[{"velocity":["0/1","-1/3","0/1"],"clock":null,"leaves":[{"name":"P0","position":["0/1","0/1","0/1"],"behaviour":"B0","origin":"B0"},{"name":"s2","position":["109/41","2851/820","0/1"],"behaviour":"B1","origin":"B1"}],"bonds":[{"name":"a","ends":["P0.s0.[v2,v3]","s2.f4"]}]}],"step":null}}
  {"type":"end","steps":2,"time":"2/1","ending":"quiescent"}
  $ scc trace ../../specs/models/hexokinase.sc --human --choose random:3
  time 0
          enzyme at (0, 0, 0) [Empty], fixed
          atp at (-9/4, 3, 0) [Atp], velocity (0, -1, 0)
          glucose at (9/4, 3, 0) [Glucose], velocity (0, -1, 0)
      1.  time passes by 2   {Time, TimeBehaviour}
  time 2
          enzyme at (0, 0, 0) [Empty], fixed
          atp at (-9/4, 1, 0) [Atp], velocity (0, -1, 0)
          glucose at (9/4, 1, 0) [Glucose], velocity (0, -1, 0)
      2.  enzyme and atp collide and bind by <atp, {enzyme.floorA.top, atp.bottom}> (choice 0 of 2)   {Bind, Pre, Sum, Def}
  time 2
          one process, fixed, <atp, {enzyme.floorA.top, atp.bottom}>
            enzyme at (0, 0, 0) [WithAtp]
            atp at (-9/4, 1, 0) [AtpBound]
          glucose at (9/4, 1, 0) [Glucose], velocity (0, -1, 0)
      3.  enzyme and atp release <atp, {enzyme.floorA.top, atp.bottom}> (choice 0 of 2)   {WeakSplit, Weak, Sum, Def}
  time 2
          enzyme at (0, 0, 0) [Empty], fixed
          atp at (-9/4, 1, 0) [Atp], velocity (0, 0, 0)
          glucose at (9/4, 1, 0) [Glucose], velocity (0, -1, 0)
      4.  enzyme and glucose collide and bind by <glc, {enzyme.floorB.top, glucose.bottom}>   {Bind, Pre, Sum, Def}
  time 2
          one process, fixed, <glc, {enzyme.floorB.top, glucose.bottom}>
            enzyme at (0, 0, 0) [WithGlucose]
            glucose at (9/4, 1, 0) [GlucoseBound]
          atp at (-9/4, 1, 0) [Atp], velocity (0, 0, 0)
      5.  time passes by 1 (choice 1 of 2)   {Time, TimeBehaviour}
  time 3
          as before: enzyme+glucose and atp
      6.  time passes by 1 (choice 1 of 2)   {Time, TimeBehaviour}
  time 4
          as before: enzyme+glucose and atp
      7.  enzyme and glucose release <glc, {enzyme.floorB.top, glucose.bottom}> (choice 0 of 2)   {WeakSplit, Weak, Sum, Def}
  time 4
          enzyme at (0, 0, 0) [Empty], fixed
          atp at (-9/4, 1, 0) [Atp], velocity (0, 0, 0)
          glucose at (9/4, 1, 0) [Glucose], velocity (0, 0, 0)
  7 transitions, time 4: nothing will ever happen again

The same bytes each time; a trace is its own schedule. A model with ranges has no start of its own.

  $ for model in $(grep -L "^param [a-z]* in" ../../specs/models/*.sc); do
  >   for choose in first random:-7; do
  >     scc trace $model --steps 25 --choose $choose > one.jsonl 2> /dev/null
  >     scc trace $model --steps 25 --choose $choose > two.jsonl 2> /dev/null
  >     scc trace $model --schedule one.jsonl > three.jsonl 2> /dev/null
  >     cmp one.jsonl two.jsonl && cmp one.jsonl three.jsonl && test -s one.jsonl || echo "$model $choose"
  >   done
  > done

Also with a limit of time that falls between two events, and with parameters, which a schedule repeats.

  $ scc trace ../../specs/models/drift.sc --time 7/2 | tee one.jsonl | tail -n 2
  {"type":"instant","offset":"7/2","time":"7/2","state":{"processes":[{"velocity":["1/3","0/1","0/1"],"clock":null,"leaves":[{"name":"p","position":["7/6","0/1","0/1"],"behaviour":"nil","origin":null}],"bonds":[]}],"step":null}}
  {"type":"end","steps":0,"time":"7/2","ending":"quiescent"}
  $ scc trace ../../specs/models/drift.sc --schedule one.jsonl | cmp - one.jsonl
  $ scc trace ../../specs/models/gas.sc -D n=1 --time 1 > one.jsonl
  $ scc trace ../../specs/models/gas.sc --schedule one.jsonl | cmp - one.jsonl
  $ scc trace ../../specs/models/gas.sc -D n=1 --schedule one.jsonl | cmp - one.jsonl
  $ scc trace ../../specs/models/gas.sc -D n=2 --schedule one.jsonl
  command line: error[SC0801]: the schedule was made with another value of `n` than -D gives
  one.jsonl:3:1: note: it is here
     |
   3 | {"type":"instant","offset":"1/1","time":"1/1","state":{"processes":[{"velocity":["-1/8","1/8","1/8"],"clock":null,"leave
     | ^
  [64]

The witness of a violated property leads to the violating state: right after x(p) passes 3 in this model.

  $ scc check ../../specs/models/drift.sc --witness runs > /dev/null
  ../../specs/models/drift.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  [1]
  $ ls runs | LC_ALL=C sort
  near.json
  near_at.json
  passes.json
  $ sed 's/"md5:[^"]*"/"md5:…"/' runs/near.json
  { "format": "scc-schedule",
    "version": 1,
    "model": "../../specs/models/drift.sc",
    "check": "near",
    "digest": "md5:…",
    "parameters": {},
    "choices": [ ],
    "offset": "10/1" }
  $ scc trace ../../specs/models/drift.sc --schedule runs/near.json | grep instant
  {"type":"instant","offset":"10/1","time":"10/1","state":{"processes":[{"velocity":["1/3","0/1","0/1"],"clock":null,"leaves":[{"name":"p","position":["10/3","0/1","0/1"],"behaviour":"nil","origin":null}],"bonds":[]}],"step":null}}

A schedule that does not fit is refused at the step where it fails.

  $ cat > hexokinase.json <<'END'
  > { "format": "scc-schedule", "version": 1,
  >   "choices": [
  >     { "label": "time(2)" },
  >     { "choice": 1 },
  >     { "label": "bounce(atp, glucose)" } ] }
  > END
  $ scc trace ../../specs/models/hexokinase.sc --schedule hexokinase.json > /dev/null
  hexokinase.json:5:5: error[SC0802]: step 3 at time 2: `bounce(atp, glucose)` is not possible here
     |
   5 |     { "label": "bounce(atp, glucose)" } ] }
     |     ^
  note: possible there: 0: weak(glc, enzyme.floorB.top, glucose.bottom); 1: bind(atp, enzyme.floorA.top, atp.bottom)
  [3]
  $ sed 's/choice": 1/choice": 2/' hexokinase.json > far.json
  $ scc trace ../../specs/models/hexokinase.sc --schedule far.json > /dev/null
  far.json:4:5: error[SC0802]: step 2 at time 2: choice 2 is not possible here
     |
   4 |     { "choice": 2 },
     |     ^
  note: possible there: 0: bind(atp, enzyme.floorA.top, atp.bottom); 1: bind(glc, enzyme.floorB.top, glucose.bottom)
  [3]
  $ sed 's/"choices"/"offset": "5", "choices"/; /bounce/d; s/1 },$/1 } ] }/' hexokinase.json > late.json
  $ scc trace ../../specs/models/hexokinase.sc --schedule late.json > /dev/null
  late.json:1:1: error[SC0802]: after step 2 at time 2: time cannot pass by 5 here
     |
   1 | { "format": "scc-schedule", "version": 1,
     | ^
  note: possible there: 0: weak(glc, enzyme.floorB.top, glucose.bottom); 1: bind(atp, enzyme.floorA.top, atp.bottom)
  [3]
  $ scc trace ../../specs/models/dimer.sc --schedule runs/near.json > /dev/null
  runs/near.json:1:1: error[SC0801]: the schedule was made for another model, or for another text of this one
     |
   1 | { "format": "scc-schedule",
     | ^
    hint: remove its `digest` to try it all the same: every choice is checked by its label
  [3]
  $ echo '{ "format": "scc-schedule", "version": 9 }' > new.json
  $ scc trace ../../specs/models/dimer.sc --schedule new.json > /dev/null
  new.json:1:1: error[SC0801]: `version` is not one of 1 and 2, the versions of the format that this scc reads
     |
   1 | { "format": "scc-schedule", "version": 9 }
     | ^
  [3]
  $ scc trace ../../specs/models/dimer.sc --schedule nowhere.json > /dev/null
  nowhere.json: error[SC0101]: cannot read: No such file or directory
  [3]

A run that never leaves an instant is stopped.

  $ scc trace ../../specs/models/slot.sc | tail -n 1
  scc: the run is left after 1000 transitions, each draw is one; `--time` or `--steps` makes it longer
  {"type":"end","steps":1000,"time":"0/1","ending":"open"}
  $ scc trace ../../specs/models/slot.sc --steps 20000 -o zeno.jsonl
  scc: stopped after 10000 transitions without time passing (Zeno behaviour)
  [4]
  $ tail -n 1 zeno.jsonl
  {"type":"end","steps":10000,"time":"0/1","ending":"zeno"}

Outputs.

  $ scc trace ../../specs/models/figure5.sc -o nowhere/run.jsonl
  nowhere/run.jsonl: error[SC0103]: cannot write: No such file or directory
  [74]
  $ scc trace ../../specs/models/figure5.sc -o .
  .: error[SC0103]: cannot write: Is a directory
  [74]
  $ scc trace ../../specs/models/figure5.sc > /dev/full
  standard output: error[SC0103]: cannot write: No space left on device
  [74]
  $ scc trace ../../specs/models/billiard.sc | head -n 1 | cut -c 1-40
  {"type":"header","format":"scc-trace","v

Wrong command lines.

  $ scc trace ../../specs/models/figure5.sc --choose last 2>&1 | head -n 1
  scc: option '--choose': `last' is neither `first' nor `random:SEED'
  $ scc trace ../../specs/models/figure5.sc --choose random:x 2> /dev/null
  [64]
  $ scc trace ../../specs/models/figure5.sc --steps=-1 2> /dev/null
  [64]

A long run of many bodies, with the first and the last state only. Its transitions are the same, and it is its own
schedule, from which the whole trace comes back.

  $ scc trace ../../specs/models/figure7.sc --states=ends | cut -c 1-88
  {"type":"header","format":"scc-trace","version":1,"semantics":"3","model":"figure7","dig
  {"type":"state","time":"0/1","state":{"processes":[{"velocity":["0/1","0/1","0/1"],"cloc
  {"type":"transition","step":1,"choice":0,"of":1,"label":{"kind":"time","text":"time(2)",
  {"type":"transition","step":2,"choice":0,"of":2,"label":{"kind":"bind","text":"bind(a, P
  {"type":"state","time":"2/1","state":{"processes":[{"velocity":["0/1","-1/3","0/1"],"clo
  {"type":"end","steps":2,"time":"2/1","ending":"quiescent"}
  $ scc trace ../../specs/models/figure7.sc --states=ends --human
  time 0
          P0 at (0, 0, 0) [Open0], velocity (0, 0, 0)
          s2 at (109/41, 4491/820, 0) [Open1], velocity (0, -1, 0)
      1.  time passes by 2   {Time, TimeBehaviour}
  time 2
      2.  P0 and s2 collide and bind by <a, {P0.s0.[v2,v3], s2.f4}> (choice 0 of 2)   {Bind, Pre, Def}
  time 2
          one process, velocity (0, -1/3, 0), <a, {P0.s0.[v2,v3], s2.f4}>
            P0 at (0, 0, 0) [B0]
            s2 at (109/41, 2851/820, 0) [B1]
  2 transitions, time 2: nothing will ever happen again
  $ scc trace ../../specs/models/drift.sc --time 7/2 --states=ends | cut -c 1-88
  {"type":"header","format":"scc-trace","version":1,"semantics":"3","model":"drift","diges
  {"type":"state","time":"0/1","state":{"processes":[{"velocity":["1/3","0/1","0/1"],"cloc
  {"type":"instant","offset":"7/2","time":"7/2","state":{"processes":[{"velocity":["1/3","
  {"type":"end","steps":0,"time":"7/2","ending":"quiescent"}
  $ scc trace ../../specs/models/gas.sc --steps 60 > all.jsonl
  $ scc trace ../../specs/models/gas.sc --steps 60 --states=ends > ends.jsonl
  $ scc trace ../../specs/models/gas.sc --schedule ends.jsonl | cmp - all.jsonl
  $ scc trace ../../specs/models/gas.sc --schedule ends.jsonl --states=ends | cmp - ends.jsonl
  $ grep -c '"state":{' ends.jsonl
  2
  $ sed '1,2d; s/,"state":{.*/}/' all.jsonl > without.jsonl
  $ grep -v '"type":"state"' ends.jsonl | sed 1d | cmp - without.jsonl

A run that ends in a dead end is told up to there: the trace is complete, is its own schedule, and is one of the model.

  $ scc trace ../../specs/models/topple.sc > topple.jsonl
  error[SC0602]: persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch
  note: after step 4, at time 2
  [2]
  $ sed 's/"rounded.*//' topple.jsonl | cut -c 1-100
  {"type":"header","format":"scc-trace","version":1,"semantics":"3","model":"topple","digest":"md5:73d
  {"type":"state","time":"0/1","state":{"processes":[{"velocity":["0/1","0/1","0/1"],"spin":["0/1","0/
  {"type":"transition","step":1,"choice":0,"of":1,"label":{"kind":"time","text":"time(1/2)","duration"
  {"type":"transition","step":2,"choice":0,"of":1,"label":{"kind":"bounce","text":"bounce(far, away)",
  {"type":"transition","step":3,"choice":0,"of":1,"label":{"kind":"time","text":"time(3/2)","duration"
  {"type":"transition","step":4,"choice":0,"of":1,"label":{"kind":"bounce","text":"bounce(p, push)","b
  {"type":"end","steps":4,"time":"2/1","ending":"stuck","diagnostic":{"code":"SC0602","severity":"erro
  $ scc trace ../../specs/models/topple.sc --schedule topple.jsonl 2> /dev/null | cmp - topple.jsonl
  $ scc conform ../../specs/models/topple.sc topple.jsonl
  topple.jsonl: conforms: 2 events, a run of 4 transitions up to time 2
  $ tail -n 1 topple.jsonl | sed 's/"diag.*//'
  {"type":"end","steps":4,"time":"2/1","ending":"stuck",
  $ scc trace ../../specs/models/topple.sc --human 2>&1 | tail -n 8
      4.  p and push collide and bounce   {Bounce}
  time 2
          p at (0, 0, 0) [nil], velocity (8/11, 0, 0), spin (0, -6/11, 0)
          push at (-2, 0, -1) [nil], velocity (3/11, 0, 0), spin (0, -6/11, 0)
          as before: spike, far and away
  4 transitions, time 2: nothing can happen, not even the passing of time
  error[SC0602]: persistent contact: spike and p would interpenetrate at once, though they do not approach where they touch
  note: after step 4, at time 2
  $ scc trace ../../specs/models/topple.sc --itf 2> /dev/null | grep -o '"ending":"[a-z]*"'
  "ending":"stuck"
  $ scc trace ../../specs/models/topple.sc --steps 3 > /dev/null
  $ scc trace ../../specs/models/topple.sc --steps 4 --states=ends 2> /dev/null | tail -n 1 | cut -c 1-54
  {"type":"end","steps":4,"time":"2/1","ending":"stuck",
  $ scc trace ../../specs/models/topple.sc --schedule topple.jsonl --time 3 2> /dev/null | tail -n 1 | cut -c 1-54
  {"type":"end","steps":4,"time":"2/1","ending":"stuck",
  $ sed 's/stuck/quiescent/' topple.jsonl > claims.jsonl
  $ scc conform ../../specs/models/topple.sc claims.jsonl
  claims.jsonl: diverges at line 7, time 2: wrong-ending
    the trace: nothing will ever happen again
    the trace claims that nothing will ever happen, and time is stuck
    rules: Quiescent
    after: bounce(p, push) at time 2   {Bounce}
  [1]
