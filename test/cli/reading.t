What matters of a run is told first: who takes part, equal passings of time in one line, decimals beside long fractions.

  $ cat > steps.sc <<'END'
  > timestep 1/8
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > fixed west = Cube at translate (-4,0,0)
  > fixed east = Cube at translate (4,0,0)
  > process away = Cube mass 1 at translate (0,30,0) [nil]
  > process p = Cube mass 1 velocity (1234567/33333333,0,0) [nil]
  > process r = Cube mass 1 velocity (1,0,0) at translate (0,0,20) [nil]
  > process s = Cube mass 1 at translate (5/2,0,20) [nil]
  > motion p = (vx, vy, vz)
  > check stays : always x(p) < 1/20
  > check away  : always x(away) < 1 within 2
  > END
  $ scc check steps.sc --witness runs
  semantics 3: timestep 1/8
  
  stays: violated
    always x(p) < 1/20
    a run that violates it:
       1-4. time passes 4 times by 1/8, to time 1/2
         5. r and s collide and bounce, at time 1/2
      6-12. time passes 7 times by 1/8, to time 11/8
      x(p) < 1/20 fails: x(p) = 1234567/24242424 (~0.050926)
      there:
        p at (1234567/24242424 (~0.050926), 0, 0) [nil], velocity (1234567/33333333 (~0.037037), 0, 0)
        r at (1/2, 0, 20) [nil], velocity (0, 0, 0)
        s at (27/8, 0, 20) [nil], velocity (1, 0, 0)
        fixed: west and east
        no part in it: away
  
  away: holds (exhaustive)
    always x(away) < 1 within 2
  
  explored: 19 states, 18 transitions, depth 18, model time 17/8; not complete: every property was decided before
  2 properties: 1 holds, 1 violated
  [1]
  $ scc check steps.sc --full | head -30
  semantics 3: timestep 1/8
  
  stays: violated
    always x(p) < 1/20
    a run that violates it:
       1. time passes by 1/8, to time 1/8
       2. time passes by 1/8, to time 1/4
       3. time passes by 1/8, to time 3/8
       4. time passes by 1/8, to time 1/2
       5. r and s collide and bounce, at time 1/2
       6. time passes by 1/8, to time 5/8
       7. time passes by 1/8, to time 3/4
       8. time passes by 1/8, to time 7/8
       9. time passes by 1/8, to time 1
      10. time passes by 1/8, to time 9/8
      11. time passes by 1/8, to time 5/4
      12. time passes by 1/8, to time 11/8
      x(p) < 1/20 fails: x(p) = 1234567/24242424
      there:
        west at (-4, 0, 0) [nil], fixed
        east at (4, 0, 0) [nil], fixed
        away at (0, 30, 0) [nil], velocity (0, 0, 0)
        p at (1234567/24242424, 0, 0) [nil], velocity (1234567/33333333, 0, 0)
        r at (1/2, 0, 20) [nil], velocity (0, 0, 0)
        s at (27/8, 0, 20) [nil], velocity (1, 0, 0)
  
  away: holds (exhaustive)
    always x(away) < 1 within 2
  
  explored: 19 states, 18 transitions, depth 18, model time 17/8; not complete: every property was decided before
  $ scc explain runs/stays.json
  semantics 3: timestep 1/8
  
  stays: always x(p) < 1/20
  at time 11/8:
    x(p) < 1/20 fails: x(p) = 1234567/24242424 (~0.050926)
  because of how everything started
  
    1-12. one event that does not matter (of r and s), to time 11/8
  
  0 of 1 events matter
  checked: the same happens without west, east, away, r and s
  $ scc explain runs/stays.json --full | head -12
  semantics 3: timestep 1/8
  
  stays: always x(p) < 1/20
  at time 11/8:
    x(p) < 1/20 fails: x(p) = 1234567/24242424
  because of how everything started
  
       1. time passes by 1/8, at time 1/8
       2. time passes by 1/8, at time 1/4
       3. time passes by 1/8, at time 3/8
       4. time passes by 1/8, at time 1/2
       5. r and s collide and bounce, at time 1/2
  $ scc trace steps.sc --human --time 1
  time 0
          west at (-4, 0, 0) [nil], fixed
          east at (4, 0, 0) [nil], fixed
          away at (0, 30, 0) [nil], velocity (0, 0, 0)
          p at (0, 0, 0) [nil], velocity (1234567/33333333 (~0.037037), 0, 0)
          r at (0, 0, 20) [nil], velocity (1, 0, 0)
          s at (5/2, 0, 20) [nil], velocity (0, 0, 0)
    1-3.  time passes 3 times by 1/8   {Time, TimeBehaviour, Steer}
  time 3/8
          p at (1234567/88888888 (~0.013889), 0, 0) [nil], velocity (1234567/33333333 (~0.037037), 0, 0)
          r at (3/8, 0, 20) [nil], velocity (1, 0, 0)
          as before: west, east, away and s
      4.  time passes by 1/8   {Time, TimeBehaviour}
  time 1/2
          p at (1234567/66666666 (~0.018519), 0, 0) [nil], velocity (1234567/33333333 (~0.037037), 0, 0)
          r at (1/2, 0, 20) [nil], velocity (1, 0, 0)
          as before: west, east, away and s
      5.  r and s collide and bounce   {Bounce, Steer}
  time 1/2
          r at (1/2, 0, 20) [nil], velocity (0, 0, 0)
          s at (5/2, 0, 20) [nil], velocity (1, 0, 0)
          as before: west, east, away and p
    6-9.  time passes 4 times by 1/8   {Time, TimeBehaviour, Steer}
  time 1
          p at (1234567/33333333 (~0.037037), 0, 0) [nil], velocity (1234567/33333333 (~0.037037), 0, 0)
          s at (3, 0, 20) [nil], velocity (1, 0, 0)
          as before: west, east, away and r
  9 transitions, time 1: more can happen
  $ scc trace steps.sc --human --full --time 3/8
  time 0
          west at (-4, 0, 0) [nil], fixed
          east at (4, 0, 0) [nil], fixed
          away at (0, 30, 0) [nil], velocity (0, 0, 0)
          p at (0, 0, 0) [nil], velocity (1234567/33333333, 0, 0)
          r at (0, 0, 20) [nil], velocity (1, 0, 0)
          s at (5/2, 0, 20) [nil], velocity (0, 0, 0)
      1.  time passes by 1/8   {Time, TimeBehaviour, Steer}
  time 1/8
          west at (-4, 0, 0) [nil], fixed
          east at (4, 0, 0) [nil], fixed
          away at (0, 30, 0) [nil], velocity (0, 0, 0)
          p at (1234567/266666664, 0, 0) [nil], velocity (1234567/33333333, 0, 0)
          r at (1/8, 0, 20) [nil], velocity (1, 0, 0)
          s at (5/2, 0, 20) [nil], velocity (0, 0, 0)
      2.  time passes by 1/8   {Time, TimeBehaviour, Steer}
  time 1/4
          west at (-4, 0, 0) [nil], fixed
          east at (4, 0, 0) [nil], fixed
          away at (0, 30, 0) [nil], velocity (0, 0, 0)
          p at (1234567/133333332, 0, 0) [nil], velocity (1234567/33333333, 0, 0)
          r at (1/4, 0, 20) [nil], velocity (1, 0, 0)
          s at (5/2, 0, 20) [nil], velocity (0, 0, 0)
      3.  time passes by 1/8   {Time, TimeBehaviour, Steer}
  time 3/8
          west at (-4, 0, 0) [nil], fixed
          east at (4, 0, 0) [nil], fixed
          away at (0, 30, 0) [nil], velocity (0, 0, 0)
          p at (1234567/88888888, 0, 0) [nil], velocity (1234567/33333333, 0, 0)
          r at (3/8, 0, 20) [nil], velocity (1, 0, 0)
          s at (5/2, 0, 20) [nil], velocity (0, 0, 0)
  3 transitions, time 3/8: more can happen

Where an exploration ends, the way there is cut in JSON, and says so.

  $ cat > drift.sc <<'END'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > fixed west = Cube at translate (-4,0,0)
  > fixed east = Cube at translate (4,0,0)
  > process p = Cube mass 1 velocity (1,1/1000000,0) [nil]
  > check far : eventually y(p) > 1
  > END
  $ scc check drift.sc --states 2000 --json > cut.json
  [2]
  $ scc check drift.sc --states 2000 --json --full > full.json
  [2]
  $ cat > look.py <<'END'
  > import json, sys
  > for name in sys.argv[1:]:
  >     run = json.load(open(name))["properties"][0]["reasons"][-1]["witness"]
  >     print(name, len(run["steps"]), run.get("omitted"), run["instant"]["text"])
  > END
  $ python3 look.py cut.json full.json
  cut.json 200 {'after': 100, 'count': 1799} 3998
  full.json 1999 None 3998
