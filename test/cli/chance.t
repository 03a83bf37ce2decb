Velocities that laws of motion leave to chance (rules Draw and Diffuse).

  $ M=../../specs/models
  $ scc check $M/brownian.sc | tail -2
  explored: 231 states, 610 transitions, depth 16, model time 7; complete
  6 properties: 4 hold, 2 violated
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
  semantics 2: timestep 1
  
  far: undecided: the law of motion of p cannot be evaluated: the weights of all its velocities are 0; one unexplored state matters
    always x(p) < 5
    to the nearest unexplored state that matters:
      1. p draws the velocity (1, 0, 0), with probability 1, at time 0
      2. time passes by 1, to time 1
      3. p draws the velocity (1, 0, 0), with probability 1, at time 1
  
  explored: 4 states, 3 transitions, depth 3, model time 1; not complete
  1 property: 1 undecided
  [2]
