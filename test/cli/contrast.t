A run that does otherwise comes with the run of a verdict, and parts from it as late as possible.

  $ M=../../specs/models
  $ scc check $M/ruin.sc --check ends --contrast
  semantics 3: timestep 1
  
  ends: violated
    eventually gone(walker)
    a run that violates it:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 2
      and the steps from 2 on again, for ever
      gone(walker) fails
      there:
        walker at (0, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: ruin and riches
    the nearest run that does otherwise, which parts from it after step 5:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 2
      6. time passes by 1, to time 3
      7. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 3
      8. time passes by 1, to time 4
      9. walker hits ruin and is gone, at time 4
      gone(walker) holds
      there:
        fixed: ruin and riches
        gone: walker
  
  explored: 16 states, 19 transitions, depth 5, model time 2; not complete: every property was decided before
  1 property: 1 violated
  [1]
  $ sed '/^check/d' $M/ruin.sc > within.sc; cat >> within.sc <<'END'
  > check soon  : eventually gone(walker) within 3
  > check stays : EG[0, 3] not gone(walker)
  > check never : EF[0, 1] gone(walker)
  > check right : eventually x(walker) > 1/2 and x(walker) < 1 within 5/2
  > END
  $ scc check within.sc --contrast
  semantics 3: timestep 1
  
  soon: violated
    eventually gone(walker) within 3
    a run that violates it:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 2
      and the steps from 2 on again, for ever
      gone(walker) fails
      there:
        walker at (0, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: ruin and riches
    the nearest run that does otherwise, which parts from it after step 2:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      gone(walker) holds
      there:
        fixed: ruin and riches
        gone: walker
  
  stays: holds (exhaustive)
    EG[0, 3] not gone(walker)
    a run that shows it:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 2
      and the steps from 2 on again, for ever
      gone(walker) fails
      there:
        walker at (0, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: ruin and riches
    the nearest run that does otherwise, which parts from it after step 2:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 1
      4. time passes by 1, to time 2
      5. walker hits ruin and is gone, at time 2
      gone(walker) holds
      there:
        fixed: ruin and riches
        gone: walker
  
  never: violated
    EF[0, 1] gone(walker)
    no run shows it: everything that counts was explored
  
  right: violated
    eventually x(walker) > 1/2 and x(walker) < 1 within 5/2
    a run that violates it:
      1. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 0
      2. time passes by 1, to time 1
      3. walker draws the velocity (1, 0, 0), with probability 2/5, at time 1
      4. time passes by 1, to time 2
      5. walker draws the velocity (-1, 0, 0), with probability 3/5, at time 2
      and the steps from 2 on again, for ever
      x(walker) > 1/2 fails: x(walker) = 0
      x(walker) < 1 holds: x(walker) = 0
      there:
        walker at (0, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: ruin and riches
    the nearest run that does otherwise, which parts from it at the start:
      1. walker draws the velocity (1, 0, 0), with probability 2/5, at time 0
      then time passes: right after time 1/2, for example at time 3/4
      x(walker) > 1/2 holds: x(walker) = 3/4
      x(walker) < 1 holds: x(walker) = 3/4
      there:
        walker at (3/4, 0, 0) [nil], velocity (1, 0, 0)
        fixed: ruin and riches
  
  explored: 16 states, 19 transitions, depth 5, model time 2; not complete: every property was decided before
  4 properties: 1 holds, 3 violated
  [1]
  $ scc check within.sc --contrast --json | grep -A1 '"otherwise"'
        "otherwise": {
          "shared": 2,
  --
        "otherwise": {
          "shared": 2,
  --
        "otherwise": {
          "shared": 0,
  $ scc check within.sc --json | grep -c '"otherwise"'
  0
  [1]
