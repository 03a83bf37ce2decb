Velocities that laws of motion leave to chance (rules Draw and Diffuse).

  $ M=../../specs/models
  $ scc check $M/brownian.sc | tail -2
  explored: 250 states, 629 transitions, depth 16, model time 7; complete
  10 properties: 6 hold, 2 violated, 2 measured
  $ scc trace $M/ruin.sc --choose random:1 --human
  time 0
          walker at (0, 0, 0) [nil], velocity (0, 0, 0)
          ruin at (-3, 0, 0) [nil], fixed, and absorbs what hits it
          riches at (4, 0, 0) [nil], fixed, and absorbs what hits it
      1.  walker draws the velocity (1, 0, 0), with probability 2/5 (choice 1 of 2)   {Draw, Steer}
  time 0
          walker at (0, 0, 0) [nil], velocity (1, 0, 0)
          as before: ruin and riches
      2.  time passes by 1   {Time, TimeBehaviour}
  time 1
          walker at (1, 0, 0) [nil], velocity (1, 0, 0)
          as before: ruin and riches
      3.  walker draws the velocity (1, 0, 0), with probability 2/5 (choice 1 of 2)   {Draw, Steer}
  time 1
          walker at (1, 0, 0) [nil], velocity (1, 0, 0)
          as before: ruin and riches
      4.  time passes by 1   {Time, TimeBehaviour}
  time 2
          walker at (2, 0, 0) [nil], velocity (1, 0, 0)
          as before: ruin and riches
      5.  walker draws the velocity (1, 0, 0), with probability 2/5 (choice 1 of 2)   {Draw, Steer}
  time 2
          walker at (2, 0, 0) [nil], velocity (1, 0, 0)
          as before: ruin and riches
      6.  time passes by 1   {Time, TimeBehaviour}
  time 3
          walker at (3, 0, 0) [nil], velocity (1, 0, 0)
          as before: ruin and riches
      7.  walker hits riches and is gone   {Absorb}
  time 3
          as before: ruin and riches
          gone: walker
  7 transitions, time 3: nothing will ever happen again

The same seed, the same run; what scc records conforms, with its draws and without.

  $ scc trace $M/ruin.sc --choose random:1 > one.jsonl
  $ scc trace $M/ruin.sc --choose random:1 | cmp - one.jsonl
  $ scc conform $M/ruin.sc one.jsonl
  one.jsonl: conforms: 4 events, a run of 7 transitions up to time 3
  $ grep -v '"draw(' one.jsonl | scc conform $M/ruin.sc -
  <standard input>: conforms: 1 event, a run of 7 transitions up to time 3
  $ sed 's/"velocity":\["1\/1","0\/1","0\/1"\],"chance"/"velocity":["2\/1","0\/1","0\/1"],"chance"/' one.jsonl > other.jsonl
  $ scc conform $M/ruin.sc other.jsonl
  other.jsonl: diverges at line 3, time 0: wrong-velocity
    the trace: draw(walker, (2, 0, 0))
    draw(walker, (1, 0, 0)) chance(2/5) is allowed there, of another velocity
    rules: Draw
    allowed there:
      draw(walker, (1, 0, 0)) chance(2/5) at time 0   {Draw, Steer}
      draw(walker, (-1, 0, 0)) chance(3/5) at time 0   {Draw, Steer}
  [1]

A table may tell draws, or only what came of them.

  $ cat > told.csv <<EOF
  > time,event,bodies,vx,vy,vz
  > 0,draw,walker,-1,0,0
  > 1,draw,walker,1,0,0
  > 2,draw,walker,-1,0,0
  > EOF
  $ scc conform $M/ruin.sc told.csv
  told.csv: conforms: 3 events, a run of 5 transitions up to time 2
  $ cat > places.csv <<EOF
  > time,event,bodies,x
  > 1,state,walker,-1
  > 2,state,walker,0
  > EOF
  $ scc conform $M/ruin.sc places.csv
  places.csv: conforms: 0 events, a run of 4 transitions up to time 2
    it could be in 3 states at once
  $ sed 's/2,state,walker,0/2,state,walker,1/' places.csv | scc conform $M/ruin.sc -
  <standard input>: diverges at line 3, time 2: wrong-position
    the trace: a state
    of walker, x is 1 in the trace, and 0, off by 1
    rules: Time
    what differs:
      walker: x: 1 in the trace, 0 expected
    allowed there:
      absorb(walker, ruin) at time 2   {Absorb}
    after: time(1) at time 1   {Time, TimeBehaviour}
  [1]

Of 2000 draws with the probability 2/5, 800 are expected, and within three deviations of 22.

  $ cat > first.sc <<EOF
  > import <solids>
  > process p = solids.Cube(1) mass 1 [nil]
  > motion p = choose { (1,0,0) weight 2, (-1,0,0) weight 3, (0,0,0) weight 0 }
  > EOF
  $ scc trace first.sc --choose random:7 --steps 4000 | grep -c '"velocity":\["1/1","0/1","0/1"\],"chance"'
  809

Graphs tell probabilities.

  $ scc explore $M/ruin.sc --format drn -o - 2> /dev/null | grep -A3 'action draw' | head -8
  // action draw_walker: draw(walker)
  // action time_1: time(1)
  // action absorb_walker_ruin: absorb(walker, ruin)
  // action absorb_walker_riches: absorb(walker, riches)
  --
  	action draw_walker [0]
  		1 : 3/5
  		2 : 2/5
  $ scc explore $M/ruin.sc --format tra -o ruin 2> /dev/null
  $ head -3 ruin.tra
  18 18 25
  0 0 1 0.6 draw_walker
  0 0 2 0.4 draw_walker
  $ scc explore $M/ruin.sc --format aut -o - 2> /dev/null | grep -c 'draw(walker, (1, 0, 0)) chance(2/5)'
  7

Lots are never asked for (rule Lot): a trace conforms with them and without, if bonds are released at split instants of the network.

  $ cat > lets.sc <<EOF
  > import <solids>
  > split_step 1/2
  > process p = solids.Cube(2) mass 1 [omega(dock, {right}) chance 1/2. nil]
  > process q = solids.Cube(2) mass 1 at translate (2,0,0) [omega(dock, {left}). nil]
  > bond <dock, {p.right, q.left}>
  > EOF
  $ scc trace lets.sc --choose random:3 > lets.jsonl
  $ grep -o '"text":"[^"]*"' lets.jsonl
  "text":"time(1/2)"
  "text":"keep(dock, p.right, q.left) chance(1/2)"
  "text":"time(1/2)"
  "text":"release(dock, p.right, q.left) chance(1/2)"
  "text":"weak(dock, p.right, q.left)"
  $ scc conform lets.sc lets.jsonl
  lets.jsonl: conforms: 1 event, a run of 5 transitions up to time 1
    it could be in 3 states at once
  $ grep -v '"kind":"lot"' lets.jsonl | scc conform lets.sc -
  <standard input>: conforms: 1 event, a run of 5 transitions up to time 1
    it could be in 3 states at once
  $ release () { printf 'time,event,bodies\n%s,weak,p;q\n' $1 | scc conform lets.sc -; }
  $ release 3/2
  <standard input>: conforms: 1 event, a run of 7 transitions up to time 3/2
  $ release 3/4
  <standard input>: diverges at line 2, time 3/4: wrong-time
    the trace: weak(p, q)
    weak(dock, p.right, q.left) is allowed at time 1/2: the trace is 1/4 too late
    rules: WeakSplit, I-9
    allowed there:
      weak(dock, p.right, q.left) at time 1/2   {WeakSplit, Weak}
      weak(dock, p.right, q.left) at time 1   {WeakSplit, Weak}
  [1]
  $ release 0
  <standard input>: diverges at line 2, time 0: wrong-time
    the trace: weak(p, q)
    weak(dock, p.right, q.left) is allowed at time 1/2: the trace is 1/2 too early
    rules: WeakSplit, I-9
    allowed there:
      weak(dock, p.right, q.left) at time 1/2   {WeakSplit, Weak}
  [1]
  $ scc trace lets.sc --choose random:3 --itf | grep -o '"lots":{"#set":\[[^]]*\]' | grep -o 'undecided\|release\|first'
  undecided
  undecided
  release
  $ scc trace lets.sc --choose random:3 --itf | grep -o '"split_clock":{"#map":\[\[[^]]*\]' | sort | uniq -c | sed 's/^ *//'
  6 "split_clock":{"#map":[["p",{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]

What cannot be drawn.

  $ cat > never.sc <<EOF
  > import <solids>
  > process p = solids.Cube(1) mass 1 [nil]
  > motion p = choose { (1,0,0) weight 2 - x }
  > check far : always x(p) < 5
  > EOF
  $ scc check never.sc
  never.sc:3:1: error[SC0601]: the law of motion of p cannot be evaluated: the weights of all its velocities are 0
     |
   3 | motion p = choose { (1,0,0) weight 2 - x }
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  semantics 3: timestep 1
  
  far: undecided: the law of motion of p cannot be evaluated: the weights of all its velocities are 0; one unexplored state matters
    always x(p) < 5
    to the nearest unexplored state that matters:
      1. p draws the velocity (1, 0, 0), with probability 1, at time 0
      2. time passes by 1, to time 1
      3. p draws the velocity (1, 0, 0), with probability 1, at time 1
  
  explored: 4 states, 3 transitions, depth 3, model time 1; not complete
  1 property: 1 undecided
  [2]

How likely something is, and what it is on the average.

  $ cat > ruin.sc <<'END'
  > timestep 1
  > import <solids>
  > process walker = solids.Cube(1) mass 1 [nil]
  > fixed ruin   = solids.Cube(1) absorb at translate (-3, 0, 0)
  > fixed riches = solids.Cube(1) absorb at translate (4, 0, 0)
  > motion walker = choose { (1, 0, 0) weight 2, (-1, 0, 0) weight 3 }
  > check lost  : P = ? [ eventually event absorb(walker, ruin) ]
  > check won   : Pmax = ? [ eventually event absorb(walker, riches) ]
  > check likely: P >= 8/10 [ eventually event absorb(walker, ruin) ]
  > check sure  : P >= 9/10 [ eventually event absorb(walker, ruin) ]
  > check stays : P = ? [ always not gone(walker) within 4 ]
  > check time  : E = ? [ time U gone(walker) ]
  > check never : E = ? [ time U event absorb(walker, ruin) ]
  > check where : E = ? [ x(walker) at 3/2 ]
  > check gone  : E = ? [ x(walker) at 2 ]
  > check quick : E <= 5 [ time U gone(walker) ]
  > END
  $ scc check ruin.sc
  semantics 3: timestep 1
  
  lost: 171/211
    P = ? [ eventually event absorb(walker, ruin) ]
    a run that counts, of probability 9/25:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      event absorb(walker, ruin) holds
      there:
        ruin at (-3, 0, 0) [nil], fixed, and absorbs what hits it
        riches at (4, 0, 0) [nil], fixed, and absorbs what hits it
        gone: walker
  
  won: greatest 40/211
    Pmax = ? [ eventually event absorb(walker, riches) ]
    a run that counts, of probability 8/125:
      1. walker draws the velocity (1, 0, 0), with probability 2/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (1, 0, 0), with probability 2/5, at time 2
      6. time passes by 1, to time 3
      7. walker hits riches and is gone, at time 3
      event absorb(walker, riches) holds
      there:
        ruin at (-3, 0, 0) [nil], fixed, and absorbs what hits it
        riches at (4, 0, 0) [nil], fixed, and absorbs what hits it
        gone: walker
  
  likely: holds (exhaustive)
    P >= 8/10 [ eventually event absorb(walker, ruin) ]
    a run that counts, of probability 9/25:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      event absorb(walker, ruin) holds
      why:
        Pmin >= 4/5 [ eventually event absorb(walker, ruin) ] holds: the least probability is 171/211
          event absorb(walker, ruin) holds
      there:
        ruin at (-3, 0, 0) [nil], fixed, and absorbs what hits it
        riches at (4, 0, 0) [nil], fixed, and absorbs what hits it
        gone: walker
  
  sure: violated
    P >= 9/10 [ eventually event absorb(walker, ruin) ]
    a run that counts, of probability 9/25:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      event absorb(walker, ruin) holds
      why:
        Pmin >= 9/10 [ eventually event absorb(walker, ruin) ] does not hold: the least probability is 171/211
          event absorb(walker, ruin) holds
      there:
        ruin at (-3, 0, 0) [nil], fixed, and absorbs what hits it
        riches at (4, 0, 0) [nil], fixed, and absorbs what hits it
        gone: walker
  
  stays: 252/625
    P = ? [ always not gone(walker) within 4 ]
    a run that does not count, of probability 9/25:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      gone(walker) holds
      there:
        fixed: ruin and riches
        gone: walker
  
  time: 1110/211
    E = ? [ time U gone(walker) ]
  
  never: infinite
    E = ? [ time U event absorb(walker, ruin) ]
  
  where: -3/10
    E = ? [ x(walker) at 3/2 ]
  
  gone: undecided: `walker` is gone, and nowhere: ask for `gone(walker)` first
    E = ? [ x(walker) at 2 ]
  
  quick: violated
    E <= 5 [ time U gone(walker) ]
    no run shows it: everything that counts was explored
  
  explored: 19 states, 24 transitions, depth 7, model time 3; complete
  10 properties: 1 holds, 2 violated, 6 measured, 1 undecided
  [1]
  $ scc check ruin.sc --json | grep -A 14 '"values"' | head -16
        "values": [
          {"over": "least", "low": "171/211", "high": "171/211"},
          {"over": "greatest", "low": "171/211", "high": "171/211"}
        ]
      },
      {
        "name": "won",
        "formula": "Pmax = ? [ eventually event absorb(walker, riches) ]",
        "verdict": "measured",
        "text": "greatest 40/211",
        "bounds": [],
        "reasons": [],
        "witness": {
          "initial": {
            "processes": [
  --
  $ scc check ruin.sc --depth 6
  semantics 3: timestep 1
  
  lost: in [0.810426, 1], as far as is known: the exploration ended at the depth bound 6; one unexplored state matters
    P = ? [ eventually event absorb(walker, ruin) ]
    to the nearest unexplored state that matters:
      1. walker draws the velocity (1, 0, 0), with probability 2/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (1, 0, 0), with probability 2/5, at time 2
      6. time passes by 1, to time 3
      7. walker hits riches and is gone, at time 3
  
  won: greatest 40/211
    Pmax = ? [ eventually event absorb(walker, riches) ]
    a run that counts, of probability 8/125:
      1. walker draws the velocity (1, 0, 0), with probability 2/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (1, 0, 0), with probability 2/5, at time 2
      6. time passes by 1, to time 3
      7. walker hits riches and is gone, at time 3
      event absorb(walker, riches) holds
      there:
        ruin at (-3, 0, 0) [nil], fixed, and absorbs what hits it
        riches at (4, 0, 0) [nil], fixed, and absorbs what hits it
        gone: walker
  
  likely: holds (exhaustive)
    P >= 8/10 [ eventually event absorb(walker, ruin) ]
    a run that counts, of probability 9/25:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      event absorb(walker, ruin) holds
      why:
        Pmin >= 4/5 [ eventually event absorb(walker, ruin) ] holds: the least probability is in [0.810426, 1]
          event absorb(walker, ruin) holds
      there:
        ruin at (-3, 0, 0) [nil], fixed, and absorbs what hits it
        riches at (4, 0, 0) [nil], fixed, and absorbs what hits it
        gone: walker
  
  sure: undecided: the exploration ended at the depth bound 6; one unexplored state matters
    P >= 9/10 [ eventually event absorb(walker, ruin) ]
    to the nearest unexplored state that matters:
      1. walker draws the velocity (1, 0, 0), with probability 2/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (1, 0, 0), with probability 2/5, at time 2
      6. time passes by 1, to time 3
      7. walker hits riches and is gone, at time 3
  
  stays: 252/625
    P = ? [ always not gone(walker) within 4 ]
    a run that does not count, of probability 9/25:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      gone(walker) holds
      there:
        fixed: ruin and riches
        gone: walker
  
  time: 1110/211
    E = ? [ time U gone(walker) ]
  
  never: at least 5.260663, as far as is known: the exploration ended at the depth bound 6; one unexplored state matters
    E = ? [ time U event absorb(walker, ruin) ]
    to the nearest unexplored state that matters:
      1. walker draws the velocity (1, 0, 0), with probability 2/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (1, 0, 0), with probability 2/5, at time 2
      6. time passes by 1, to time 3
      7. walker hits riches and is gone, at time 3
  
  where: -3/10
    E = ? [ x(walker) at 3/2 ]
  
  gone: undecided: `walker` is gone, and nowhere: ask for `gone(walker)` first
    E = ? [ x(walker) at 2 ]
  
  quick: violated
    E <= 5 [ time U gone(walker) ]
    no run shows it: everything that counts was explored
  
  explored: 19 states, 24 transitions, depth 7, model time 3; not complete: stopped by the depth bound 6
  10 properties: 1 holds, 1 violated, 4 measured, 2 within an interval, 2 undecided
  [1]

What cannot be asked.

  $ ask() { { head -6 ruin.sc; echo "$1"; } > asked.sc; scc check asked.sc; }
  $ ask 'check c : P >= 3/2 [ eventually gone(walker) ]'
  asked.sc:7:16: error[SC0208]: a probability is from 0 to 1, and this is 3/2
     |
   7 | check c : P >= 3/2 [ eventually gone(walker) ]
     |                ^^^
  [3]
  $ ask 'check c : Q >= 1/2 [ eventually gone(walker) ]'
  asked.sc:7:11: error[SC0701]: `Q` stands before what runs do, and a probability or a mean is expected
     |
   7 | check c : Q >= 1/2 [ eventually gone(walker) ]
     |           ^
    hint: these are `P`, `Pmin`, `Pmax`, `E`, `Emin` and `Emax`
  [3]
  $ ask 'check c : P = ? [ gone(walker) ]'
  asked.sc:7:19: error[SC0701]: what a run does is expected here, and this is none
     |
   7 | check c : P = ? [ gone(walker) ]
     |                   ^^^^^^^^^^^^
    hint: write `eventually …`, `always …` or `f U g`
  [3]
  $ ask 'check c : AG (P = ? [ eventually gone(walker) ])'
  asked.sc:7:15: error[SC0701]: this asks about a number, and a formula is expected here
     |
   7 | check c : AG (P = ? [ eventually gone(walker) ])
     |               ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    hint: a check may ask for it, if nothing stands around
  [3]
  $ ask 'check c : AG (E <= 5 [ time U gone(walker) ])'
  asked.sc:7:15: error[SC0701]: this asks about a number, and a formula is expected here
     |
   7 | check c : AG (E <= 5 [ time U gone(walker) ])
     |               ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    hint: a check may ask for it, if nothing stands around
  [3]
  $ ask 'check c : P = ? [ x(walker) at 10 ]'
  asked.sc:7:19: error[SC0701]: a probability is one of what a run does, and not of a value at a time
     |
   7 | check c : P = ? [ x(walker) at 10 ]
     |                   ^^^^^^^^^
    hint: write `eventually[t, t] …` for what is so at the time t
  [3]
  $ ask 'check c : E = ? [ x(walker) U gone(walker) ]'
  asked.sc:7:19: error[SC0701]: before the `U` of a mean stands `time`, or events that are counted
     |
   7 | check c : E = ? [ x(walker) U gone(walker) ]
     |                   ^^^^^^^^^
  [3]
  $ ask 'check c : E = ? [ time U[<= 5] gone(walker) ]'
  asked.sc:7:29: error[SC0701]: a mean until something holds takes no bound of time
     |
   7 | check c : E = ? [ time U[<= 5] gone(walker) ]
     |                             ^
  [3]
  $ ask 'check c : E = ? [ x(walker) at 0 - 1 ]'
  asked.sc:7:32: error[SC0208]: a time is not negative, and this is -1
     |
   7 | check c : E = ? [ x(walker) at 0 - 1 ]
     |                                ^^^^^
  [3]
  $ ask 'check c : E = ? [ gone(walker) at 1 ]'
  asked.sc:7:19: error[SC0701]: a mean is one of a number, and this is none
     |
   7 | check c : E = ? [ gone(walker) at 1 ]
     |                   ^^^^^^^^^^^^
    hint: write `time U f`, `event … U f`, or a number and `at` a time
  [3]
  $ ask 'check c : P = ? eventually gone(walker)'
  asked.sc:7:17: error[SC0110]: `eventually` does not fit here: expected `[` and what is asked for, as in `P = ? [ eventually f ]`
     |
   7 | check c : P = ? eventually gone(walker)
     |                 ^^^^^^^^^^
  [3]

Splits that are left to chance.

  $ scc check $M/dissociation.sc 2>&1 | grep '^[a-z_]*: '
  dimer_breaks: holds (exhaustive), at split step 1/2
  dimer_lasts: violated, at split step 1/2
  dimer_by_two: 175/256, at split step 1/2
  dimer_life: 2, at split step 1/2
  not_sooner: holds (exhaustive), at split step 1/2
  left_first: 5/12, at split step 1/2
  right_first: 1/4, at split step 1/2
  one_only: holds (exhaustive), at split step 1/2
  left_at_all: 5/8, at split step 1/2
  reacts: 1/3, at split step 1/2
  is_left: holds (exhaustive), at split step 1/2
  is_left_most: holds (exhaustive), at split step 1/2
  explored: 119 states, 202 transitions, depth 11, model time 1; complete
  $ cat > lots.sc <<END
  > import <solids>
  > param q = 1/4
  > behaviour L on solids.Cube(1) = omega(b, {right}) push(1) chance (q) . nil
  > process p = solids.Cube(1) mass 1 [L]
  > process q = solids.Cube(1) mass 1 at translate (1, 0, 0) [omega(b, {left}) . nil]
  > bond <b, {p.right, q.left}>
  > END
  $ scc trace lots.sc --choose first --human
  time 0
          one process, velocity (0, 0, 0), <b, {p.right, q.left}>
            p at (0, 0, 0) [L]
            q at (1, 0, 0) [omega(b, {left}). nil]
      1.  time passes by 1   {Time, TimeBehaviour}
  time 1
          one process, velocity (0, 0, 0), <b, {p.right, q.left}>
            p at (0, 0, 0) [L]
            q at (1, 0, 0) [omega(b, {left}). nil]
      2.  p and q are to release <b, {p.right, q.left}>, with probability 1/4 (choice 0 of 2)   {Lot}
  time 1
          one process, velocity (0, 0, 0), <b, {p.right, q.left}>
            p at (0, 0, 0) [L]
            q at (1, 0, 0) [omega(b, {left}). nil]
      3.  p and q release <b, {p.right, q.left}> with a push of 1   {WeakSplit, Weak, Def}
  time 1
          p at (0, 0, 0) [nil], velocity (-1, 0, 0)
          q at (1, 0, 0) [nil], velocity (1, 0, 0)
  3 transitions, time 1: nothing will ever happen again

What is hardly more than 0, or hardly less than 1, is not rounded to it.

  $ for chance in 1/10000000000000000000000000000000 9999999999999999999999999999999/10000000000000000000000000000000; do
  >   sed "s|^param q = .*|param q = $chance|; s|push(1) ||" lots.sc > hardly.sc
  >   echo 'check two : P = ? [ eventually not bound(p, q) within 2 ]' >> hardly.sc
  >   scc check hardly.sc | grep '^two: '
  > done
  two: about 2e-31, at split step 1
  two: more than 0.999999, at split step 1

The probability within each time, up to the bound: a table, JSON and a picture.

  $ scc check $M/ruin.sc --curve by_four --curve-plot curve.svg | sed -n '/^by_four/,/a run/p'
  by_four: 373/625
    P = ? [ eventually gone(walker) within 4 ]
    within T, for T
      from 0: 0
      from 2: 9/25
      from 3: 53/125
      from 4: 373/625
    a run that counts, of probability 9/25:
  $ scc check $M/ruin.sc --curve by_four --json | sed -n '/"curve"/,/^      ]/p' | tail -9
          },
          {
            "time": {"low": "4/1", "high": "4/1", "text": "4"},
            "values": [
              {"over": "least", "low": "373/625", "high": "373/625"},
              {"over": "greatest", "low": "373/625", "high": "373/625"}
            ]
          }
        ]
  $ grep -c '<svg' curve.svg
  1
  $ scc check $M/ruin.sc --curve ends
  command line: error[SC0208]: --curve: `ends' does not ask for a probability within a time, as `P = ? [ eventually f within t ]' does
  [64]
  $ scc check $M/ruin.sc --curve-plot curve.svg
  command line: error[SC0208]: --curve-plot: of which check? Give `--curve NAME` as well
  [64]
  $ scc check $M/ruin.sc --curve by_five
  command line: error[SC0201]: the model has no check `by_five`
  [64]
  $ scc check $M/ruin.sc --check ends --curve by_four
  command line: error[SC0208]: --curve: `by_four' is not among the checks of --check: add `--check by_four'
  [64]

A curve is that of one start. A hint for ranges can be followed.

  $ printf 'shape C = box(1,1,1)\nparam d in [0, 3]\nprocess p = C mass 1 at translate (d,0,0) [nil]\n' > starts.sc
  $ printf 'motion p = choose { (1,0,0), (-1,0,0) }\ncheck c : P = ? [ eventually x(p) > 2 within 2 ]\n' >> starts.sc
  $ scc check starts.sc --curve c --curve-plot curve.svg
  command line: error[SC0901]: --curve: this model is explored by sets of states, as it leaves values or instants open, and a curve is that of one start
    hint: leave out --curve; or give all parameters values with `-D NAME=VALUE`, and a `split_step`
  [64]
  $ scc check starts.sc -D d=1 --curve c | grep -A9 '^c:'
  c: 1/4
    P = ? [ eventually x(p) > 2 within 2 ]
    within T, for T
      from 0: 0
      after 1: 1/4
    a run that counts, of probability 1/4:
      1. p draws the velocity (1, 0, 0), with probability 1/2, at time 0
      2. time passes by 1, to time 1
      3. p draws the velocity (1, 0, 0), with probability 1/2, at time 1
      then time passes: right after time 1, for example at time 3/2
  $ scc check starts.sc -D d=1 --where
  error[SC0208]: no parameter of this model has a range
    hint: `param x in [0, 6]` declares one, `-D 'x=[1,3]'` narrows it, and `-D x=2` leaves a value alone
  [3]
  $ scc check starts.sc -D 'd=[1,2]' | grep '^c:'
  c: 1/4 to 1/2, for d in [1, 2]; mean 1/2 = 0.5
  $ scc check starts.sc -D 'd=[0,1' 2>&1 | head -1
  scc: option '-D': `[0,1' is no range such as [1, 3) or [0, 1/2]

A claim beside a question for the same probability is decided as soon as the question is answered.

  $ printf 'shape C = box(1,1,1)\nprocess w = C mass 1 at translate (3,0,0) [nil]\n' > long.sc
  $ printf 'fixed l = C absorb at translate (-1,0,0)\nfixed r = C absorb at translate (601,0,0)\n' >> long.sc
  $ printf 'motion w = choose { (1,0,0), (-1,0,0) }\ncheck much : P = ? [ eventually event absorb(w, r) ]\n' >> long.sc
  $ printf 'check claim : P >= 1/3 [ eventually event absorb(w, r) ]\n' >> long.sc
  $ scc check long.sc | grep -E '^(much|claim)'
  much: 1/200
  claim: violated

Collisions that chance puts in order (rule Ties): one number, also without reductions and from a kept exploration. Random
runs have nothing free, and other tools get the tie as one action.

  $ scc check $M/ties.sc | grep -E '^[a-z_]+: |^explored|of probability'
  near_binds: 5/8
    a run that counts, of probability 1/4:
  one_binds: 1
    a run that counts, of probability 1/4:
  no_choice: holds (exhaustive)
    a run that counts, of probability 1/4:
  takes: 5/6
  explored: 25 states, 36 transitions, depth 7, model time 2; complete
  $ scc check $M/ties.sc --no-reduce all | grep -E '^[a-z_]+: '
  near_binds: 5/8
  one_binds: 1
  no_choice: holds (exhaustive)
  takes: 5/6
  explored: 29 states, 40 transitions, depth 7, model time 2; complete
  $ scc check $M/ties.sc --store kept | grep binds
  near_binds: 5/8
  one_binds: 1
  $ scc check $M/ties.sc --store kept | grep binds
  near_binds: 5/8
  one_binds: 1
  $ echo 'check race : P = ? [ bonds(a) = 0 U bound(near, site) ]' | cat $M/ties.sc - > tied.sc
  $ sed 's/^collisions drawn//' tied.sc > free.sc
  $ scc check free.sc --check race | grep race
  race: least 7/12, greatest 2/3
  $ scc estimate tied.sc --check race --runs 300
  race: estimated: 0.616667, from 0.541272 to 0.688275 with confidence 99/100, 300 runs
  $ scc estimate free.sc --check race --runs 300 | head -3
  race: estimated: from 0.484029 to 0.716585 with confidence 99/100, 300 runs
    it is so in 168 of the 274 runs that tell; 26 runs are open, and may differ
    26 of 300 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  $ scc explore tied.sc --format drn -o tied.drn 2> log && grep -A2 'action tie \[' tied.drn
  	action tie [0]
  		14 : 1/2
  		24 : 1/2
  $ scc explore tied.sc --format json -o tied.json 2> log && grep -o '"target":[0-9]*,"chance":"[0-9/]*"' tied.json
  "target":14,"chance":"1/2"
  "target":24,"chance":"1/2"
