Formulas within formulas: what is so on the way of a run is told with its reason, and no reason is given by what
holds when it is a failure that is explained.

  $ cat > walls.sc <<'EOF'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > fixed west = Cube at translate (-4,0,0)
  > fixed east = Cube at translate (4,0,0)
  > process p = Cube mass 1 velocity (1,0,0) [nil]
  > check settles : AF AG x(p) > 0
  > check may     : EF EG x(p) > 0
  > check must    : AF EG x(p) > 0
  > check returns : EG EF x(p) > 0
  > check stays   : EF AG x(p) >= -2
  > check soon    : AG (x(p) > 1 => AF[1, 2] AG x(p) < 1)
  > check until   : E[EF x(p) = 2 U x(p) = -2]
  > EOF
  $ scc check walls.sc
  semantics 3
  
  settles: violated
    AF AG x(p) > 0
    a run that violates it:
      1. time passes by 2, to time 2
      2. east and p collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. west and p collide and bounce, at time 6
      5. time passes by 4, to time 10
      6. east and p collide and bounce, at time 10
      and the steps from 3 on again, for ever
      why:
        AF AG x(p) > 0 does not hold: bounce(east, p) after 2; bounce(west, p) after 6; bounce(east, p) after 10
          the run then repeats what happens after time 2 from here, for ever
          everywhere on this run, AG x(p) > 0 does not hold: as this run goes on, after time 4 of it, and each time round
            x(p) > 0 does not hold: x(p) = 0
      there:
        p at (2, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: west and east
  
  may: violated
    EF EG x(p) > 0
    no run shows it: everything that counts was explored
  
  must: violated
    AF EG x(p) > 0
    a run that violates it:
      1. time passes by 2, to time 2
      2. east and p collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. west and p collide and bounce, at time 6
      5. time passes by 4, to time 10
      6. east and p collide and bounce, at time 10
      and the steps from 3 on again, for ever
      why:
        AF EG x(p) > 0 does not hold: bounce(east, p) after 2; bounce(west, p) after 6; bounce(east, p) after 10
          the run then repeats what happens after time 2 from here, for ever
          everywhere on this run, EG x(p) > 0 does not hold: all runs from there were looked at
      there:
        p at (2, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: west and east
  
  returns: holds (exhaustive)
    EG EF x(p) > 0
    a run that shows it:
      1. time passes by 2, to time 2
      2. east and p collide and bounce, at time 2
      3. time passes by 4, to time 6
      4. west and p collide and bounce, at time 6
      5. time passes by 4, to time 10
      6. east and p collide and bounce, at time 10
      and the steps from 3 on again, for ever
      why:
        EG EF x(p) > 0 holds: bounce(east, p) after 2; bounce(west, p) after 6; bounce(east, p) after 10
          the run then repeats what happens after time 2 from here, for ever
          everywhere on this run, EF x(p) > 0 holds: as this run goes on, after time 2 of it, and each time round
            x(p) > 0 holds: x(p) = 2
      there:
        p at (2, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: west and east
  
  stays: holds (exhaustive)
    EF AG x(p) >= -2
    a run that shows it:
      in the initial state
      why:
        EF AG x(p) >= -2 holds: here
          AG x(p) >= -2 holds: all 5 states that count from here on were looked at
      there:
        p at (0, 0, 0) [nil], velocity (1, 0, 0)
        fixed: west and east
  
  soon: violated
    AG (x(p) > 1 => AF[1, 2] AG x(p) < 1)
    a run that violates it:
      1. time passes by 2, to time 2
      2. east and p collide and bounce, at time 2
      then time passes beyond the bound, which ends at time 7/2
      why:
        AG (x(p) > 1 => AF[1, 2] AG x(p) < 1) does not hold: right after time 1 from here, for example after 3/2
          x(p) > 1 => AF[1, 2] AG x(p) < 1 does not hold
            x(p) > 1 holds: x(p) = 3/2
            AF[1, 2] AG x(p) < 1 does not hold: bounce(east, p) after 1/2
              the run then passes the bound of time, which ends after time 2 from here
              everywhere on this run in that time, AG x(p) < 1 does not hold: each place has its reason, for example
                right after time 1/2 of this run, for example after 1, AG x(p) < 1 does not hold: as this run goes on, right after time 1/2 of it
                  x(p) < 1 does not hold: x(p) = 3/2
                after time 3/2 of this run, AG x(p) < 1 does not hold: as this run goes on, after time 3/2 of it
                  x(p) < 1 does not hold: x(p) = 1
                right after time 3/2 of this run, for example after 3, AG x(p) < 1 does not hold: bounce(west, p) after 3/2
                  after time 9/2 from here
                  x(p) < 1 does not hold: x(p) = 1
      there:
        p at (1/2, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: west and east
  
  until: holds (exhaustive)
    E[EF x(p) = 2 U x(p) = -2]
    a run that shows it:
      1. time passes by 2, to time 2
      2. east and p collide and bounce, at time 2
      3. time passes by 4, to time 6
      x(p) = -2 holds: x(p) = -2
      why:
        E[ EF x(p) = 2 U x(p) = -2 ] holds: bounce(east, p) after 2
          in the state after time 6 from here
          x(p) = -2 holds: x(p) = -2
          all the way, EF x(p) = 2 holds: each place has its reason, for example
            after time 0 of this run, EF x(p) = 2 holds: as this run goes on, after time 2 of it
              x(p) = 2 holds: x(p) = 2
            right after time 2 of this run, for example after 4, EF x(p) = 2 holds: bounce(west, p) after 2
              in the state after time 6 from here
              x(p) = 2 holds: x(p) = 2
      there:
        p at (-2, 0, 0) [nil], velocity (-1, 0, 0)
        fixed: west and east
  
  explored: 5 states, 5 transitions, depth 4, model time 6; complete
  7 properties: 3 hold, 4 violated
  [1]
