The main job: a verdict for every property, with a witness.

  $ scc check ../../specs/models/hexokinase.sc
  semantics 3: split step 1
  
  reaction: holds (exhaustive), at split step 1
    possibly reacted
    a run that shows it:
      1. time passes by 2, to time 2
      2. enzyme and atp collide and bind by <atp, {enzyme.floorA.top, atp.bottom}>, at time 2
      3. enzyme and glucose collide and bind by <glc, {enzyme.floorB.top, glucose.bottom}>, at time 2
      4. a reaction releases <atp, {enzyme.floorA.top, atp.bottom}>, <glc, {enzyme.floorB.top, glucose.bottom}>, at time 2
      behaviour(atp) = Adp holds
      behaviour(glucose) = G6p holds
      there:
        enzyme at (0, 0, 0) [Empty], fixed
        atp at (-9/4, 1, 0) [Adp], velocity (0, 0, 0)
        glucose at (9/4, 1, 0) [G6p], velocity (0, 0, 0)
  
  in_time: holds (exhaustive), at split step 1
    possibly reacted within 3
    a run that shows it:
      1. time passes by 2, to time 2
      2. enzyme and atp collide and bind by <atp, {enzyme.floorA.top, atp.bottom}>, at time 2
      3. enzyme and glucose collide and bind by <glc, {enzyme.floorB.top, glucose.bottom}>, at time 2
      4. a reaction releases <atp, {enzyme.floorA.top, atp.bottom}>, <glc, {enzyme.floorB.top, glucose.bottom}>, at time 2
      behaviour(atp) = Adp holds
      behaviour(glucose) = G6p holds
      there:
        enzyme at (0, 0, 0) [Empty], fixed
        atp at (-9/4, 1, 0) [Adp], velocity (0, 0, 0)
        glucose at (9/4, 1, 0) [G6p], velocity (0, 0, 0)
  
  together: holds (exhaustive), at split step 1
    always behaviour(atp) = Adp => behaviour(glucose) = G6p
  
  at_most: holds (exhaustive), at split step 1
    always bonds(atp) <= 1 and bonds(glc) <= 1
  
  full: holds (exhaustive), at split step 1
    possibly size(enzyme) = 7
    a run that shows it:
      1. time passes by 2, to time 2
      2. enzyme and atp collide and bind by <atp, {enzyme.floorA.top, atp.bottom}>, at time 2
      3. enzyme and glucose collide and bind by <glc, {enzyme.floorB.top, glucose.bottom}>, at time 2
      size(enzyme) = 7 holds: size(enzyme) = 7
      there:
        one process, fixed, <atp, {enzyme.floorA.top, atp.bottom}> <glc, {enzyme.floorB.top, glucose.bottom}>
          enzyme at (0, 0, 0) [Both]
          atp at (-9/4, 1, 0) [AtpBound]
          glucose at (9/4, 1, 0) [GlucoseBound]
  
  surely: violated, at split step 1
    eventually reacted
    a run that violates it:
      1. time passes by 2, to time 2
      2. enzyme and atp collide and bind by <atp, {enzyme.floorA.top, atp.bottom}>, at time 2
      3. enzyme and atp release <atp, {enzyme.floorA.top, atp.bottom}>, at time 2
      4. enzyme and glucose collide and bind by <glc, {enzyme.floorB.top, glucose.bottom}>, at time 2
      5. enzyme and glucose release <glc, {enzyme.floorB.top, glucose.bottom}>, at time 2
      then nothing happens any more, and time passes for ever
      behaviour(atp) = Adp fails
      behaviour(glucose) = G6p fails
      there:
        enzyme at (0, 0, 0) [Empty], fixed
        atp at (-9/4, 1, 0) [Atp], velocity (0, 0, 0)
        glucose at (9/4, 1, 0) [Glucose], velocity (0, 0, 0)
  
  releases: holds (exhaustive), at split step 1
    possibly behaviour(atp) = Atp and vy(atp) = 0
    a run that shows it:
      1. time passes by 2, to time 2
      2. enzyme and atp collide and bind by <atp, {enzyme.floorA.top, atp.bottom}>, at time 2
      3. enzyme and atp release <atp, {enzyme.floorA.top, atp.bottom}>, at time 2
      behaviour(atp) = Atp holds
      vy(atp) = 0 holds: vy(atp) = 0
      there:
        enzyme at (0, 0, 0) [Empty], fixed
        atp at (-9/4, 1, 0) [Atp], velocity (0, 0, 0)
        glucose at (9/4, 1, 0) [Glucose], velocity (0, -1, 0)
  
  in_pocket: holds (exhaustive), at split step 1
    always x(atp) = -9/4 and y(atp) >= 1
  
  explored: 11 states, 16 transitions, depth 5, model time 2; complete
  8 properties: 7 hold, 1 violated
  [1]
  $ scc check ../../specs/models/drift.sc
  ../../specs/models/drift.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  semantics 3
  
  near: violated
    always x(p) <= 3
    a run that violates it:
      then time passes: right after time 9, for example at time 10
      x(p) <= 3 fails: x(p) = 10/3
      there:
        p at (10/3, 0, 0) [nil], velocity (1/3, 0, 0)
  
  near_in: holds (exhaustive)
    always x(p) <= 3 within 9
  
  near_at: violated
    always x(p) < 3 within 9
    a run that violates it:
      then time passes, until time 9
      x(p) < 3 fails: x(p) = 3
      there:
        p at (3, 0, 0) [nil], velocity (1/3, 0, 0)
  
  passes: holds (exhaustive)
    possibly x(p) = 22/7
    a run that shows it:
      then time passes, until time 66/7
      x(p) = 22/7 holds: x(p) = 22/7
      there:
        p at (22/7, 0, 0) [nil], velocity (1/3, 0, 0)
  
  ahead: holds (exhaustive)
    always x(p) >= 0
  
  back: violated
    possibly x(p) < 0
    no run shows it: everything that counts was explored
  
  gone: holds (exhaustive)
    eventually x(p) > 100
  
  quiet: holds (exhaustive)
    always quiescent
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  8 properties: 5 hold, 3 violated
  [1]
  $ scc check ../../specs/models/slot.sc
  semantics 3
  
  rattles: holds (exhaustive)
    possibly vy(plate) = 1
    a run that shows it:
      1. floor and plate collide and bounce, at time 0
      vy(plate) = 1 holds: vy(plate) = 1
      there:
        plate at (0, 0, 0) [nil], velocity (1, 1, 0)
        fixed: floor and ceiling
  
  flat: holds (exhaustive)
    always y(plate) = 0
  
  slides: violated
    possibly x(plate) > 0
    no run shows it: everything that counts was explored
  
  leaves: violated by a run that goes round within one instant
    eventually x(plate) > 20
    a run that violates it:
      1. floor and plate collide and bounce, at time 0
      2. ceiling and plate collide and bounce, at time 0
      and the steps from 1 on again, for ever
      x(plate) > 20 fails: x(plate) = 0
      there:
        plate at (0, 0, 0) [nil], velocity (1, -1, 0)
        fixed: floor and ceiling
  
  endless: holds (exhaustive) by a run that goes round within one instant
    EG true
    a run that shows it:
      1. floor and plate collide and bounce, at time 0
      2. ceiling and plate collide and bounce, at time 0
      and the steps from 1 on again, for ever
      true holds
      there:
        plate at (0, 0, 0) [nil], velocity (1, -1, 0)
        fixed: floor and ceiling
  
  next: holds (exhaustive), of runs some of which go round within one instant
    AG EX true
  
  again: holds (exhaustive)
    AG AF event bounce(plate, floor)
  
  later: violated
    EF[1, 1] true
    no run shows it: everything that counts was explored
  
  stays: violated by a run that goes round within one instant
    A[y(plate) = 0 U x(plate) > 0]
    a run that violates it:
      1. floor and plate collide and bounce, at time 0
      2. ceiling and plate collide and bounce, at time 0
      and the steps from 1 on again, for ever
      x(plate) > 0 fails: x(plate) = 0
      there:
        plate at (0, 0, 0) [nil], velocity (1, -1, 0)
        fixed: floor and ceiling
  
  explored: 2 states, 2 transitions, depth 1, model time 0; complete
  9 properties: 5 hold, 4 violated
  [1]

Exit codes. All hold; a property is violated; a default bound cut the run short; the same bound given by the
user; the model is refused; the command line is wrong.

  $ cat > forever.sc <<'END'
  > timestep 1
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > param v = 1
  > process p = Cube mass 1 velocity (v,0,0) [nil]
  > motion p = (vx + dt, 0, 0)
  > check slow : always vx(p) >= 0
  > END
  $ scc check ../../specs/models/figure5.sc > /dev/null
  ../../specs/models/figure5.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  $ scc check ../../specs/models/drift.sc > /dev/null
  ../../specs/models/drift.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  [1]
Checks that see time differently are explored apart; that nothing happens is told all the same:

  $ cat > rest.sc <<'END'
  > shape Tetra { vertices a (0,0,0) b (1,0,0) c (0,1,0) d (0,0,1) faces f [a,c,b] g [a,b,d] h [a,d,c] i [b,c,d] }
  > process p = Tetra mass 1 [nil]
  > check still : always x(p) = 1/4
  > check now : possibly x(p) + time < 1
  > END
  $ scc check rest.sc 2>&1 | grep -E 'SC0703|explored'
  rest.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
  explored: 2 states, 0 transitions, depth 0, model time 0; not complete: every property was decided before

  $ scc check forever.sc --states 100
  semantics 3: timestep 1
  
  slow: holds up to the bound: the bound of 100 states
    always vx(p) >= 0
  
  explored: 100 states, 99 transitions, depth 99, model time 99; not complete: stopped by the bound of 100 states
  1 property: 1 holds up to the bound
  $ scc check forever.sc --depth 3
  semantics 3: timestep 1
  
  slow: holds up to the bound: the depth bound 3
    always vx(p) >= 0
  
  explored: 5 states, 4 transitions, depth 4, model time 4; not complete: stopped by the depth bound 3
  1 property: 1 holds up to the bound
  $ scc check forever.sc --time 3/2
  semantics 3: timestep 1
  
  slow: holds up to the bound: the time bound 3/2
    always vx(p) >= 0
  
  explored: 3 states, 2 transitions, depth 2, model time 2; not complete: stopped by the time bound 3/2
  1 property: 1 holds up to the bound
  $ scc check forever.sc -D v=-1 --depth 3
  semantics 3: timestep 1
  
  slow: violated
    always vx(p) >= 0
    a run that violates it:
      in the initial state
      vx(p) >= 0 fails: vx(p) = -1
      there:
        p at (0, 0, 0) [nil], velocity (-1, 0, 0)
  
  explored: 1 state, 0 transitions, depth 0, model time 0; not complete: every property was decided before
  1 property: 1 violated
  [1]
  $ scc check ../../specs/models/refused/figure5-misprint.sc
  ../../specs/models/refused/figure5-misprint.sc:16:26: error[SC0404]: the parts `s0` and `s1` of `S0` have the velocities (2, 1, 0) and (2, 1, 1), and glued parts move as one
      |
   16 |   part s1 : Plank mass 3 velocity (2,1,1) at translate (2,0,0)
      |                          ^^^^^^^^^^^^^^^^
  ../../specs/models/refused/figure5-misprint.sc:15:26: note: the velocity of `s0` is here
      |
   15 |   part s0 : Cube  mass 3 velocity (2,1,0) at translate (-1,0,0)
      |                          ^^^^^^^^^^^^^^^^
  [3]
  $ scc check forever.sc --depth many 2> /dev/null
  [64]
  $ scc check 2> /dev/null
  [64]
  $ scc nothing 2> /dev/null
  [64]

A default bound, and what cannot be decided.

  $ scc check forever.sc
  semantics 3: timestep 1
  
  slow: holds up to the bound: the bound of 200000 states (a default)
    always vx(p) >= 0
  
  explored: 200000 states, 199999 transitions, depth 199999, model time 199999; not complete: stopped by the bound of 200000 states (a default)
  1 property: 1 holds up to the bound
  [2]
  $ sed 's/always vx/eventually -vx/;s/>= 0/> 0/' forever.sc > never.sc
  $ scc check never.sc --states 100 | tail -n 2
  explored: 100 states, 99 transitions, depth 99, model time 99; not complete: stopped by the bound of 100 states
  1 property: 1 undecided
  $ scc check never.sc --states 100 > /dev/null
  [2]

A limit of the clock or of memory is no bound of the model.

  $ scc check forever.sc --seconds 0.05 | sed 's/[0-9]* states*.*;/N states;/'
  semantics 3: timestep 1
  
  slow: holds up to the bound: the limit of 0.05 seconds
    always vx(p) >= 0
  
  explored: N states; not complete: stopped by the limit of 0.05 seconds
  1 property: 1 holds up to the bound
  $ scc check forever.sc --seconds 0.05 > /dev/null
  [4]

Parameters.

  $ scc check forever.sc -D w=1
  command line: error[SC0209]: the model has no parameter `w`
    hint: did you mean `v`?
  [64]
  $ scc check forever.sc -D v 2> /dev/null
  [64]
  $ scc check forever.sc -D v=x 2> /dev/null
  [64]
  $ scc check forever.sc -D v=1/0 2> /dev/null
  [64]

Standard input.

  $ scc check --depth 1 - < forever.sc
  semantics 3: timestep 1
  
  slow: holds up to the bound: the depth bound 1
    always vx(p) >= 0
  
  explored: 3 states, 2 transitions, depth 2, model time 2; not complete: stopped by the depth bound 1
  1 property: 1 holds up to the bound

What is not known within the bounds: which unexplored state matters.

  $ (grep -v check forever.sc; echo 'check next : AX vx(p) > 0'; echo 'check back : always (possibly vx(p) > 0)') > later.sc
  $ scc check later.sc --depth 2
  semantics 3: timestep 1
  
  next: undecided: the exploration ended at the depth bound 2; one unexplored state matters
    AX vx(p) > 0
    to the nearest unexplored state that matters:
      1-3. time passes 3 times by 1, to time 3
  
  back: undecided: the exploration ended at the depth bound 2; one unexplored state matters
    always possibly vx(p) > 0
    to the nearest unexplored state that matters:
      1-3. time passes 3 times by 1, to time 3
  
  explored: 4 states, 3 transitions, depth 3, model time 3; not complete: stopped by the depth bound 2
  2 properties: 2 undecided
  [2]

An evaluation that takes too long leaves its own formula open, and no other.

  $ cat > far.sc <<'END'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > fixed west = Cube at translate (-5,0,0)
  > fixed east = Cube at translate (5,0,0)
  > process ball = Cube mass 1 velocity (1,0,0) [nil]
  > check near : AG EF x(ball) = 1
  > check far  : AG EF[1e12, 1e12] x(ball) = 0
  > END
  $ scc check far.sc --seconds 1 > ended
  [4]
  $ grep '^far' ended
  far: undecided: its evaluation on what was explored ended at the limit of 1 second
  $ python3 -B interrupt.py 0.3 scc check far.sc | grep ': '
  near: holds (exhaustive)
  far: undecided: its evaluation on what was explored ended at the interruption
  explored: 5 states, 5 transitions, depth 4, model time 9; complete
  2 properties: 1 holds, 1 undecided

A network of nobody.

  $ printf 'network nil\ncheck none : always processes = 0\ncheck rest : AF AG quiescent\n' > nobody.sc
  $ scc check nobody.sc 2> /dev/null | grep ': '
  none: holds (exhaustive)
  rest: holds (exhaustive)
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  2 properties: 2 hold
  $ scc explore nobody.sc -o - --format aut 2> /dev/null
  des (0, 2, 2)
  (0, "time(forever)", 1)
  (1, "time(forever)", 1)
  $ scc compare nobody.sc nobody.sc --modulo timed | head -1
  equivalent modulo timed

Schedules are replayed with jumps.

  $ scc check ../../specs/models/latch.sc --no-reduce jump --witness runs
  scc: --witness does not go with --no-reduce jump: schedules are replayed with jumps
  [64]

Hash compaction proves nothing by finding nothing.

  $ scc check ../../specs/models/dimers.sc -D n=2 --hash-compact | grep -v '^ '
  semantics 3: split step 1
  
  all_fall: holds (exhaustive), at split step 1
  
  none: violated, at split step 1
  
  pieces: holds up to the bound: hash compaction, by which some state was left out with a probability of at most 4e-09, at split step 1
  
  at_rest: holds up to the bound: hash compaction, by which some state was left out with a probability of at most 4e-09, at split step 1
  
  explored: 8 states, 14 transitions, depth 2, model time 0; not complete: stopped by hash compaction, by which some state was left out with a probability of at most 4e-09
  4 properties: 1 holds, 2 hold up to the bound, 1 violated

A model without properties is explored all the same.

  $ grep -v check ../../specs/models/dimer.sc > bare.sc
  $ scc check bare.sc
  semantics 3: split step 1/2
  
  explored: 11 states, 14 transitions, depth 6, model time 3; complete
  no properties to check

JSON: one document on standard output, nothing on standard error, whatever happens.

  $ scc check --json ../../specs/models/figure5.sc | sed 's/"md5:[^"]*"/"md5:…"/' | head -n 13
  {
    "format": "scc-check",
    "version": 1,
    "semantics": "3",
    "model": "figure5",
    "digest": "md5:…",
    "parameters": {},
    "settings": {},
    "exit": 0,
    "properties": [
      {
        "name": "one_body",
        "formula": "always size(S) = 2 and processes = 1",
  $ scc check --json nowhere.sc
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

Interruption: what is known so far is reported, and the exit code is 4.

  $ python3 -B interrupt.py 0.3 scc check forever.sc --states 100000000 > interrupted
  [4]
  $ sed -n 3p interrupted
  slow: holds up to the bound: the interruption

The model and the run that the README shows.

  $ awk '/^shape Cube/ { p = 1 } /^```/ { p = 0 } p' ../../README.md > readme.sc
  $ scc check readme.sc
  semantics 3
  
  meets: holds (exhaustive)
    eventually bound(p, q) within 3
  
  parts: holds (exhaustive)
    event bind(bond) leads_to event strong(bond) within 2
  
  once: holds (exhaustive)
    AG (event strong(bond) => AG not bound(p, q))
  
  close: holds (exhaustive)
    always x(q) - x(p) >= 2
  
  explored: 5 states, 4 transitions, depth 4, model time 9/2; complete
  4 properties: 4 hold
  $ scc check ../../specs/models/hexokinase.sc > run
  [1]
  $ scc check ../../specs/models/meeting.sc --where >> run
  [1]
  $ awk '/^\$ scc check/ { p = 1; next } /^```/ { p = 0 } p && !/…/' ../../README.md > shown
  $ grep -vxFf run shown
  [1]

Two values for one parameter.

  $ scc check forever.sc -D v=1 -D v=2
  command line: error[SC0212]: the parameter `v` is given two values by -D
  [64]

Where a bound ended an exploration in which event times grew ever slower, the verdict says so.

  $ (cat ../../specs/models/laws/closing.sc; echo 'check forever : always x(west) < x(ball)') > closing.sc
  $ scc check closing.sc --states 120 | grep -c 'grow ever slower'
  1
  $ scc check closing.sc --states 120 | grep -o 'forever: .*slower'
  forever: holds up to the bound: the bound of 120 states; event times grow ever slower
  $ scc check closing.sc --states 120 --json | grep -c '"slowing"'
  1

--check names what to decide; the others are not explored for. A store of other checks is refused:

  $ scc check ../../specs/models/hexokinase.sc --check together --check reaction --store named | grep -e : -e ^1
  semantics 3: split step 1
  reaction: holds (exhaustive), at split step 1
    a run that shows it:
      there:
  together: holds (exhaustive), at split step 1
  explored: 11 states, 16 transitions, depth 5, model time 2; complete
  2 properties: 2 hold
  $ scc check ../../specs/models/hexokinase.sc --check reaction --check together --store named | tail -1
  2 properties: 2 hold
  $ scc check ../../specs/models/hexokinase.sc --check together --store named
  named: error[SC0911]: it keeps something else: --check is reaction,together there, and together here
  [3]
  $ scc check ../../specs/models/hexokinase.sc --check togther
  command line: error[SC0201]: the model has no check `togther`
    hint: did you mean `together`?
  [64]
