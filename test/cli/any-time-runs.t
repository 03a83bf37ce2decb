Runs that decide formulas where bonds may be released at any time. A ball goes to and fro for ever, and p and q need not part:

  $ cat > ball.sc <<'END'
  > model ball
  > split_step any
  > shape Cube = box(2,2,2)
  > behaviour L on Cube = omega(b, {right}). nil
  > behaviour R on Cube = omega(b, {left}). nil
  > process p = Cube mass 1 at translate (0,20,0) [L]
  > process q = Cube mass 1 at translate (2,20,0) [R]
  > bond <b, {p.right, q.left}>
  > process ball = Cube mass 1 velocity (1,0,0) [nil]
  > fixed west = Cube at translate (-4,0,0) [nil]
  > fixed east = Cube at translate (4,0,0) [nil]
  > check parts : eventually not bound(p, q)
  > check after : event bounce(ball, west) leads_to not bound(p, q)
  > check until : A[x(ball) < 1 U x(ball) > 1 and not bound(p, q)]
  > check soon  : eventually not bound(p, q) within 5
  > check may   : EF EG x(ball) > -3
  > check never : AG (event bounce(ball, west) => EF (bound(p, q) and x(ball) = 0))
  > END
  $ scc check ball.sc --witness runs | sed '/there:/,/^$/{/there:/d;/^    /d}'
  semantics 3: split step any
  
  parts: violated
    eventually not bound(p, q)
    a run that violates it:
      1. time passes by 2, to time 2
      2. ball and east collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. ball and west collide and bounce, at time 6
      5. time passes by 4, to time 10
      and the steps from 2 on again, for ever
      it puts off weak(b, p.right, q.left) for ever: no fairness is assumed
      bound(p, q) holds
  
  after: violated
    event bounce(ball, west) leads_to not bound(p, q)
    a run that violates it:
      1. time passes by 2, to time 2
      2. ball and east collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. ball and west collide and bounce, at time 6
      5. time passes by 4, to time 10
      6. ball and east collide and bounce, at time 10
      7. time passes by 4, to time 14
      8. ball and west collide and bounce, at time 14
      and the steps from 5 on again, for ever
      it puts off weak(b, p.right, q.left) for ever: no fairness is assumed
      bound(p, q) holds
      why:
        AG (event bounce(ball, west) => AF not bound(p, q)) does not hold: bounce(ball, east) after 2; bounce(ball, west) after 6
          in the state after time 6 from here
          event bounce(ball, west) => AF not bound(p, q) does not hold
            event bounce(ball, west) holds
            AF not bound(p, q) does not hold: bounce(ball, east) after 4; bounce(ball, west) after 8
              the run then repeats all of this, for ever
  
  until: violated
    A[x(ball) < 1 U x(ball) > 1 and not bound(p, q)]
    a run that violates it:
      then time passes, until time 3/2
      x(ball) < 1 fails: x(ball) = 3/2
      x(ball) > 1 holds: x(ball) = 3/2
      bound(p, q) holds
  
  soon: violated
    eventually not bound(p, q) within 5
    a run that violates it:
      1. time passes by 2, to time 2
      2. ball and east collide and bounce, at time 2
      then time passes beyond the bound, which ends at time 5
      bound(p, q) holds
  
  may: holds (exhaustive, all instants)
    EF EG x(ball) > -3
    a run that shows it:
      1. time passes by 2, to time 2
      2. ball and east collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. ball and west collide and bounce, at time 6
      5. time passes by 4, to time 10
      and the steps from 2 on again, for ever
      it puts off weak(b, p.right, q.left) for ever: no fairness is assumed
      x(ball) > -3 holds: x(ball) = 2
      why:
        EF EG x(ball) > -3 holds: here
          EG x(ball) > -3 holds: bounce(ball, east) after 2; bounce(ball, west) after 6
            the run then repeats what happens after time 2 from here, for ever
  
  never: violated
    AG (event bounce(ball, west) => EF (bound(p, q) and x(ball) = 0))
    a run that violates it:
      1. time passes by 2, to time 2
      2. ball and east collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. p and q release <b, {p.right, q.left}>, at time 6
      5. ball and west collide and bounce, at time 6
      event bounce(ball, west) holds
      why:
        AG (event bounce(ball, west) => EF (bound(p, q) and x(ball) = 0)) does not hold: bounce(ball, east) after 2; weak(b, p.right, q.left) after 6; bounce(ball, west) after 6
          in the state after time 6 from here
          event bounce(ball, west) => EF (bound(p, q) and x(ball) = 0) does not hold
            event bounce(ball, west) holds
            EF (bound(p, q) and x(ball) = 0) does not hold: all runs from there were looked at
  
  explored: 24 states, 29 transitions, depth 6; complete
  6 properties: 1 holds, 5 violated

The run is replayed by its schedule, as any other, and explained:

  $ scc trace ball.sc --schedule runs/parts.json --human --states=ends | tail -3
          ball at (2, 0, 0) [nil], velocity (1, 0, 0)
          as before: p+q, west and east
  5 transitions, time 10: more can happen
  $ scc explain runs/after.json ball.sc | tail -3
  
  4 of 4 events matter
  every body takes part: none could be left out to try
  $ scc check ball.sc --json | grep '"finish"\|"cycle"'
          "finish": "repeats",
          "cycle": 1,
          "finish": "repeats",
          "cycle": 4,
          "finish": "instant",
          "cycle": null,
          "finish": "passes",
          "cycle": null,
          "finish": "repeats",
          "cycle": 1,
          "finish": "state",
          "cycle": null,

Two bodies that were thrown apart bounce between walls; two others, thrown apart at some other time, fly ever farther. Everything is
as before but for where these are: no state comes back.

  $ cat > drift.sc <<'END'
  > split_step any
  > shape Cube = box(2,2,2)
  > behaviour L on Cube = omega(b, {right}) push(1). nil
  > behaviour R on Cube = omega(b, {left}). nil
  > process p = Cube mass 1 at translate (0,20,0) [L]
  > process q = Cube mass 1 at translate (2,20,0) [R]
  > process r = Cube mass 1 at translate (0,0,0) [L]
  > process s = Cube mass 1 at translate (2,0,0) [R]
  > bond <b, {p.right, q.left}>
  > bond <b, {r.right, s.left}>
  > fixed west = Cube at translate (-4,0,0) [nil]
  > fixed east = Cube at translate (6,0,0) [nil]
  > check goes : not EF EG (not bound(p, q) and AF event bounce(s, east))
  > END
  $ scc check drift.sc | sed '/there:/,/^$/{/there:/d;/^    /d}'
  semantics 3: split step any
  
  goes: violated
    not EF EG (not bound(p, q) and AF event bounce(s, east))
    a run that violates it:
      1. p and q release <b, {p.right, q.left}> with a push of 1, at time 0
      2. r and s release <b, {r.right, s.left}> with a push of 1, at time 0
      3. time passes by 2, to time 2
      4. r and west collide and bounce, at time 2
      5. s and east collide and bounce, at time 2
      6. time passes by 2, to time 4
      7. r and s collide and bounce, at time 4
      then it goes on for ever, which is known of sets of states: this one is like that before step 3, but for numbers, and no run was found that comes back to a state
      why:
        not EF EG (not bound(p, q) and AF event bounce(s, east)) does not hold
          EF EG (not bound(p, q) and AF event bounce(s, east)) holds: weak(b, p.right, q.left) push(1) after 0; weak(b, r.right, s.left) push(1) after 0
            in the state after time 0 from here
            EG (not bound(p, q) and AF event bounce(s, east)) holds: bounce(r, west) after 2; bounce(s, east) after 2; bounce(r, s) after 4
              the run then goes on for ever
              everywhere on this run, not bound(p, q) and AF event bounce(s, east) holds: that is known of all states that it goes through
  
  explored: 30 states, 41 transitions, depth 8; complete
  1 property: 1 violated
  $ scc check drift.sc --json | grep '"finish"\|"cycle"'
          "finish": "goes_on",
          "cycle": 2,

Values of a parameter, and instants of splits, are chosen together: q has to be free by the time at which s comes.

  $ cat > both.sc <<'END'
  > split_step any
  > param d in [0, 2]
  > shape Cube = box(2,2,2)
  > behaviour P on Cube = omega(b, {right}). nil
  > behaviour Q on Cube = omega(b, {left}). eps(d). <a, {right}>. Caught
  > behaviour S on Cube = <~a, {left}>. Caught
  > behaviour Caught on Cube = nil
  > process p = Cube mass 1 at translate (0,0,0) [P]
  > process q = Cube mass 1 at translate (2,0,0) [Q]
  > bond <b, {p.right, q.left}>
  > process s = Cube mass 1 velocity (-1,0,0) at translate (5,0,0) [S]
  > check misses : eventually event bounce(q, s)
  > check caught : A[not event bind(a) U event bounce(q, s)]
  > END
  $ scc check both.sc --where | sed '/there:/,/^$/{/there:/d;/^    /d}'
  semantics 3: split step any
  
  misses: violated for d = 1/2
    eventually event bounce(q, s)
    holds where
      d > 1
    fails elsewhere
    probability 1/2 = 0.5
    a run that violates it:
      1. time passes by 1/2, to time 1/2
      2. p and q release <b, {p.right, q.left}>, at time 1/2
      3. time passes by 1/2, to time 1
      4. q and s collide and bind by <a, {q.right, s.left}>, at time 1
      5. p and q collide and bounce, at time 1
      then nothing happens any more, and time passes for ever
      event bounce(q, s) fails
  
  caught: violated for d = 1/2
    A[not event bind(a) U event bounce(q, s)]
    holds where
      d > 1
    fails elsewhere
    probability 1/2 = 0.5
    a run that violates it:
      1. time passes by 1/2, to time 1/2
      2. p and q release <b, {p.right, q.left}>, at time 1/2
      3. time passes by 1/2, to time 1
      4. q and s collide and bind by <a, {q.right, s.left}>, at time 1
      event bind(a) holds
      event bounce(q, s) fails
  
  explored: 25 states, 26 transitions, depth 6; complete
  2 properties: 2 violated

Where a bound leaves a check undecided, the way to the nearest set of states that was not explored is shown:

  $ sed '/^  *check/d; s/^process \([pq]\) = Cube mass 1 at/process \1 = Cube mass 1 velocity (0,1,0) at/; /^check/d' ball.sc > rise.sc
  $ echo 'check parts : eventually (not bound(p, q) or y(p) < 0)' >> rise.sc
  $ scc check rise.sc --states 30 | sed '/there:/,/^$/{/there:/d;/^    /d}'
  semantics 3: split step any
  
  parts: undecided: the exploration ended at the bound of 30 states; 4 unexplored states matter
    eventually not bound(p, q) or y(p) < 0
    to the nearest unexplored state that matters:
      1. time passes by 2, to time 2
      2. ball and east collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. ball and west collide and bounce, at time 6
      5. time passes by 4, to time 10
      6. ball and east collide and bounce, at time 10
      7. time passes by 4, to time 14
      8. p and q release <b, {p.right, q.left}>, at time 14
      9. ball and west collide and bounce, at time 14
  
  explored: 30 states, 36 transitions, depth 10; not complete: stopped by the bound of 30 states
  1 property: 1 undecided
