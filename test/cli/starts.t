Probabilities and means over all starts (rule Starts): functions of the parameters, constant or affine on pieces.

  $ cat > cleft.sc << 'END'
  > model cleft
  > 
  > timestep 1 steady
  > param d in [0, 3]
  > param h in [0, 2]
  > 
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > 
  > behaviour Site   on Cube = <site, {top}>. nil
  > behaviour Ligand on Cube = <~site, {bottom}>. nil
  > 
  > fixed membrane = Cube scaled (12, 2, 1) at translate (0, 0, -5/2)
  > fixed receptor = Cube scaled (1, 1, 1/4) at translate (0, 0, -5/4) [Site]
  > 
  > process ligand = Cube mass 1 at translate (d, 0, 1/2 + h) [Ligand]
  > 
  > motion ligand = choose {
  >   (1, 0, 0) weight 1, (-1, 0, 0) weight 1, (0, 0, 1) weight 1, (0, 0, -1) weight 1
  > }
  > 
  > check binds  : P = ? [ eventually bound(ligand, receptor) within 2 ]
  > check likely : P >= 1/8 [ eventually bound(ligand, receptor) within 2 ]
  > check surely : eventually bound(ligand, receptor) within 2
  > check mean   : E = ? [ z(ligand) at 1 ]
  > END

  $ scc check cleft.sc --where
  semantics 3: timestep 1 steady
  
  binds: 0 to 3/8, for d in [0, 3], h in [0, 2]; mean 1/12, about 0.08333
    P = ? [ eventually bound(ligand, receptor) within 2 ]
    h > 3/2: 0
    d >= 2, 1/2 < h <= 3/2: 0
    d = 3, h <= 1/2 (no area): 0
    1/2 < h <= 3/2, d < 2: 1/16
    2 <= d < 3, h < 1/2: 1/16
    h = 1/2, 2 <= d < 3 (no area): 5/64
    1 <= d < 2, h <= 1/2: 5/16
    h <= 1/2, d < 1: 3/8
    mean 1/12, about 0.08333
  
  likely: violated for d = 1, h = 1
    P >= 1/8 [ eventually bound(ligand, receptor) within 2 ]
    no single run shows it: everything that counts was explored
    holds where
      h <= 1/2, d < 2
    fails elsewhere
    probability 1/6, about 0.1667
  
  surely: violated for d = 1, h = 1
    eventually bound(ligand, receptor) within 2
    there is a run that shows it, but none was found that is short enough to be shown
    fails everywhere
    probability 0
  
  mean: 1/2 to 5/2, for d in [0, 3], h in [0, 2]; mean 145/96, about 1.51
    E = ? [ z(ligand) at 1 ]
    h = 0, d >= 2 (no area): 1/2
    h > 1/2: h + 1/2
    d >= 2, 0 < h <= 1/2: h + 1/2
    h = 0, d < 2 (no area): 5/8
    0 < h <= 1/2, d < 2: 3/4 h + 5/8
    mean 145/96, about 1.51
  
  explored: 156 states, 259 transitions, depth 13; complete
  4 properties: 2 violated, 2 measured
  [1]

On the border of pieces, too, a single start has the value of the pieces:

  $ scc check cleft.sc -D d=0 -D h=1/2 | grep binds
  binds: 3/8
  $ scc check cleft.sc -D d=1 -D h=0 | grep binds
  binds: 5/16

The mean in JSON:

  $ scc check cleft.sc --json | grep -c '"mean"'
  5
  $ scc check cleft.sc --json --where --check mean | grep -c '"low_form"'
  4

Means. A run that never comes to it makes the mean infinite. Comparisons say for which starts they hold.

  $ cat > meet.sc << 'END'
  > model meet
  > import <solids>
  > param d in [3, 5]
  > process a = solids.Cube(2) mass 1 velocity (1, 0, 0) [nil]
  > process b = solids.Cube(2) mass 1 at translate (d, 0, 0) [nil]
  > check meets : E = ? [ time U event bounce ]
  > check far   : E = ? [ time U x(a) > 1 ]
  > check later : E = ? [ time U x(a) > 1 or time >= 9 ]
  > check early : E <= 5/2 [ time U event bounce ]
  > check many  : E = ? [ event bounce U time >= 2 ]
  > check push  : E = ? [ vx(b) at 2 ]
  > check apart : E = ? [ distance2(a, b) at 2 ]
  > check rest  : E = ? [ time U quiescent ]
  > END
  $ scc check meet.sc --where
  semantics 3
  
  meets: d - 2, for d in [3, 5]
    E = ? [ time U event bounce ]
    everywhere: d - 2
    mean 2
  
  far: 1 to infinite, for d in [3, 5]; mean 1
    E = ? [ time U x(a) > 1 ]
    d > 3: 1
    d = 3 (no length): infinite
    mean 1
  
  later: 1 to 9, for d in [3, 5]; mean 1
    E = ? [ time U x(a) > 1 or time >= 9 ]
    d > 3: 1
    d = 3 (no length): 9
    mean 1
  
  early: violated for d = 14/3
    E <= 5/2 [ time U event bounce ]
    no single run shows it: everything that counts was explored
    holds where
      d <= 9/2
    fails elsewhere
    probability 3/4 = 0.75
  
  many: 0 to 1, for d in [3, 5]; mean 1/2 = 0.5
    E = ? [ event bounce U time >= 2 ]
    d >= 4: 0
    d < 4: 1
    mean 1/2 = 0.5
  
  push: 0 to 1, for d in [3, 5]; mean 1/2 = 0.5
    E = ? [ vx(b) at 2 ]
    d > 4: 0
    d <= 4: 1
    mean 1/2 = 0.5
  
  apart: 4 where it is known, for d in [3, 5]; mean not known: nothing is known for a share of 1, as far as is known: a distance is not linear in what is not known
    E = ? [ distance2(a, b) at 2 ]
    d = 4 (no length): 4
    d < 4: not known
    d > 4: not known
    mean not known: nothing is known for a share of 1
  
  rest: undecided: over starts, `quiescent` is not known in an operator with a probability, or in a mean
    E = ? [ time U quiescent ]
    its value is not known for all starts
  
  explored: 17 states, 12 transitions, depth 2; not complete
  8 properties: 1 violated, 5 measured, 1 within an interval, 1 undecided
  [1]
  $ for d in 3 4 5; do scc check meet.sc -D d=$d --check push --check many --check far | grep '^[pmf]'; done
  far: infinite
  many: 1
  push: 1
  far: 1
  many: 0
  push: 1
  far: 1
  many: 0
  push: 0

Without an end the greatest value is infinite where the exploration stops:

  $ cat > until.sc << 'END'
  > model walk
  > timestep 1
  > param start in [0, 3]
  > import <solids>
  > process walker = solids.Cube(1) mass 1 at translate (start, 0, 0) [nil]
  > fixed ruin = solids.Cube(1) at translate (-2, 0, 0)
  > motion walker = choose { (1, 0, 0) weight 2, (-1, 0, 0) weight 3 }
  > check back   : E = ? [ time U x(walker) <= -1 ]
  > check steps  : E = ? [ event bounce or not event bounce U time >= 2 ]
  > check number : E = ? [ x(walker) at 3 ]
  > END
  $ scc check until.sc --where --depth 6
  semantics 3: timestep 1
  
  back: at least 7/5, for start in [0, 3]; mean at least 97/50 = 1.94, as far as is known: the exploration ended at the depth bound 6
    E = ? [ time U x(walker) <= -1 ]
    start = 0 (no length): at least 7/5, not known better
    0 < start < 1: at least 9/25 start + 41/25, not known better
    start >= 1: at least 2, not known better
    mean at least 97/50 = 1.94
  
  steps: at least 2, for start in [0, 3]; mean at least 56/25 = 2.24, as far as is known: the exploration ended at the depth bound 6
    E = ? [ event bounce or not event bounce U time >= 2 ]
    start >= 1: 2
    0 < start < 1: at least 68/25, not known better
    start = 0 (no length): 74/25
    mean at least 56/25 = 2.24
  
  number: undecided: the exploration ended at the depth bound 6
    E = ? [ x(walker) at 3 ]
    its value is not known for all starts
  
  explored: 33 states, 53 transitions, depth 6; not complete: stopped by the depth bound 6
  3 properties: 2 within an interval, 1 undecided
  [2]

Where bonds may break at any time, happenings are counted, and times have no least value that is attained:

  $ cat > any.sc << 'END'
  > model any
  > split_step any
  > param d in [3, 4]
  > import <solids>
  > behaviour Open on solids.Cube(2) = <a, {right}>. omega(a, {right}). nil
  > behaviour Shut on solids.Cube(2) = <~a, {left}>. omega(a, {left}). nil
  > process p = solids.Cube(2) mass 1 velocity (1, 0, 0) [Open]
  > process q = solids.Cube(2) mass 1 at translate (d, 0, 0) [Shut]
  > check breaks : Emax = ? [ event weak U time >= 3 ]
  > check when   : Emin = ? [ time U event weak ]
  > END
  $ scc check any.sc --where
  semantics 3: split step any
  
  breaks: 1, for d in [3, 4]
    Emax = ? [ event weak U time >= 3 ]
    everywhere: 1
    mean 1
  
  when: at least d - 2, not known better, for d in [3, 4], as far as is known: over starts, a mean of a time or of a number is not known where bonds may break at any time
    Emin = ? [ time U event weak ]
    everywhere: at least d - 2, not known better
    mean at least 3/2 = 1.5
  
  explored: 7 states, 5 transitions, depth 3; not complete
  2 properties: 1 measured, 1 within an interval
  [2]

A number at a time has no mean at starts at which a run may have lost it. All others have theirs. The mean over a uniform
start does not depend on starts without length, and nothing is known of it if there are more:

  $ cat > gone.sc << 'END'
  > model gone
  > timestep 1
  > param d in [0, 1]
  > import <solids>
  > process w = solids.Cube(1) mass 1 at translate (d, 0, 0) [nil]
  > fixed outlet = solids.Cube(1) absorb at translate (-2, 0, 0)
  > motion w = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight 1 }
  > check once  : E = ? [ x(w) at 1 ]
  > check test  : E <= 1/2 [ x(w) at 1 ]
  > check twice : E = ? [ x(w) at 3/2 ]
  > END
  $ scc check gone.sc --where
  semantics 3: timestep 1
  
  once: d where it is known, for d in [0, 1]; mean 1/2 = 0.5, as far as is known: `w` is gone, and nowhere: ask for `gone(w)` first
    E = ? [ x(w) at 1 ]
    d > 0: d
    d = 0 (no length): not known
    mean 1/2 = 0.5
  
  test: violated for d = 2/3
    E <= 1/2 [ x(w) at 1 ]
    no single run shows it: everything that counts was explored
    holds where
      0 < d <= 1/2
    fails where
      d > 1/2
    not known elsewhere
    probability 1/2 = 0.5
  
  twice: d where it is known, for d in [0, 1]; mean not known: nothing is known for a share of 1/2 = 0.5, as far as is known: `w` is gone, and nowhere: ask for `gone(w)` first
    E = ? [ x(w) at 3/2 ]
    d > 1/2: d
    d <= 1/2: not known
    mean not known: nothing is known for a share of 1/2 = 0.5
  
  explored: 24 states, 22 transitions, depth 5; not complete
  3 properties: 1 violated, 2 within an interval
  [1]
  $ scc check gone.sc --where --json --check once | grep -A3 -E '"(unknown|mean)"'
            "mean": {"low": "1/2", "high": "1/2"},
            "parts": [
              {
                "low": "0/1",
  --
            "unknown": {
              "pieces": [[{"coefficients": {"d": "1/1"}, "relation": "=", "bound": "0/1"}]],
              "measure": "0/1"
            }
  --
            "mean": {"low": "1/2", "high": "1/2"},
            "parts": [
              {
                "low": "0/1",
  --
            "unknown": {
              "pieces": [[{"coefficients": {"d": "1/1"}, "relation": "=", "bound": "0/1"}]],
              "measure": "0/1"
            }
  $ scc check gone.sc --where --json --check twice | grep -A3 -E '"(unknown|mean)"'
            "mean": null,
            "parts": [
              {
                "low": "1/2",
  --
            "unknown": {
              "pieces": [
                [
                  {"coefficients": {"d": "-1/1"}, "relation": "<=", "bound": "0/1"},
  --
            "mean": null,
            "parts": [
              {
                "low": "1/2",
  --
            "unknown": {
              "pieces": [
                [
                  {"coefficients": {"d": "-1/1"}, "relation": "<=", "bound": "0/1"},
  $ scc check gone.sc --check once --smt gone.smt > /dev/null; grep unknown gone.smt
  (define-fun once-unknown () Bool (= d 0.0))
  $ scc check gone.sc --check once --draw gone.svg > /dev/null; grep -c 'not known' gone.svg
  4

An event that leads to the last state at a time counts there, in a number, too:

  $ cat > last.sc << 'END'
  > model last
  > import <solids>
  > process a = solids.Cube(2) mass 1 velocity (1, 0, 0) [nil]
  > process b = solids.Cube(2) mass 1 at translate (3, 0, 0) [nil]
  > check now   : E = ? [ if event bounce then 1 else 0 at 1 ]
  > check later : E = ? [ if event bounce then 1 else 0 at 3/2 ]
  > END
  $ scc check last.sc | grep '^now\|^later'
  now: 1
  later: 0

A drawing has a region for each value. Where parameters are projected, the value may depend on them.

  $ scc check cleft.sc --check binds --draw values.svg > /dev/null
  $ grep '<title>binds' values.svg | sort -u
      <title>binds: 0
      <title>binds: 1/16
      <title>binds: 3/8
      <title>binds: 5/16
      <title>binds: 5/64
  $ scc check cleft.sc --check binds --check likely --draw line.svg --slice h=0 > /dev/null
  [1]
  $ grep -A2 '<title>likely' line.svg | sort -u
      <title>likely: fails
      <title>likely: holds
  --
  binds: 0
  binds: 1/16
  binds: 3/8
  binds: 5/16
  where 1 &lt;= d &lt; 2
  where 2 &lt;= d &lt; 3
  where d &lt; 1
  where d = 3
  $ scc check cleft.sc --check binds --draw shadow.svg --axes d > /dev/null
  $ grep '<title>binds' shadow.svg | sort -u
      <title>binds: 0
      <title>binds: depends on h

Without a bound of time the value is known between two bounds, piece by piece:

  $ cat > walk.sc << 'END'
  > model walk
  > timestep 1
  > param start in [0, 3]
  > import <solids>
  > process walker = solids.Cube(1) mass 1 at translate (start, 0, 0) [nil]
  > fixed ruin = solids.Cube(1) absorb at translate (-2, 0, 0)
  > fixed riches = solids.Cube(1) absorb at translate (5, 0, 0)
  > motion walker = choose { (1, 0, 0) weight 2, (-1, 0, 0) weight 3 }
  > check ruined : P = ? [ eventually event absorb(walker, ruin) ]
  > END

  $ scc check walk.sc --where --depth 12
  semantics 3: timestep 1
  
  ruined: 0 to 1, for start in [0, 3]; mean at least 24/125 = 0.192, and at most 347/375, about 0.9253, as far as is known: the exploration ended at the depth bound 12
    P = ? [ eventually event absorb(walker, ruin) ]
    start = 3 (no length): from 0 to 63/125, not known better
    2 < start < 3: from 0 to 21/25, not known better
    start = 2 (no length): from 27/125 to 21/25, not known better
    1 < start < 2: from 27/125 to 117/125, not known better
    start = 1 (no length): from 9/25 to 117/125, not known better
    0 < start < 1: from 9/25 to 1, not known better
    start = 0 (no length): from 93/125 to 1, not known better
    mean at least 24/125 = 0.192, and at most 347/375, about 0.9253
  
  explored: 27 states, 40 transitions, depth 12; not complete: stopped by the depth bound 12
  1 property: 1 within an interval
  [2]

A weight that is negative for some start, and one that is not constant:

  $ cat > negative.sc << 'END'
  > model walk
  > timestep 1
  > param start in [0, 3]
  > import <solids>
  > process walker = solids.Cube(1) mass 1 at translate (start, 0, 0) [nil]
  > fixed ruin = solids.Cube(1) absorb at translate (-2, 0, 0)
  > fixed riches = solids.Cube(1) absorb at translate (5, 0, 0)
  > motion walker = choose { (1, 0, 0) weight 2 - x, (-1, 0, 0) weight 3 }
  > check ruined : P = ? [ eventually event absorb(walker, ruin) ]
  > END
  $ scc check negative.sc
  negative.sc:8:1: error[SC0601]: the law of motion of walker cannot be evaluated: a weight is negative, for start = 5/2
     |
   8 | motion walker = choose { (1, 0, 0) weight 2 - x, (-1, 0, 0) weight 3 }
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  semantics 3: timestep 1
  
  ruined: undecided: the law of motion of walker cannot be evaluated: a weight is negative, for start = 5/2
    P = ? [ eventually event absorb(walker, ruin) ]
  
  explored: 0 states, 0 transitions, depth 0; not complete
  1 property: 1 undecided
  [2]
  $ cat > sloped.sc << 'END'
  > model walk
  > timestep 1
  > param start in [0, 3]
  > import <solids>
  > process walker = solids.Cube(1) mass 1 at translate (start, 0, 0) [nil]
  > fixed ruin = solids.Cube(1) absorb at translate (-2, 0, 0)
  > fixed riches = solids.Cube(1) absorb at translate (5, 0, 0)
  > motion walker = choose { (1, 0, 0) weight 20 - x, (-1, 0, 0) weight 3 }
  > check ruined : P = ? [ eventually event absorb(walker, ruin) ]
  > END
  $ scc check sloped.sc
  semantics 3: timestep 1
  
  ruined: undecided: a weight in the law of `walker` depends on the place or the time, and not by conditions alone
    P = ? [ eventually event absorb(walker, ruin) ]
  
  explored: 0 states, 0 transitions, depth 0; not complete
  1 property: 1 undecided
  [2]

What is not followed over zones:

  $ sed 's/^timestep 1/timestep 1 local/' walk.sc > local.sc; scc check local.sc
  error[SC0901]: what is not known of this model does not stay linear: processes have movement steps of their own (`timestep ... local`)
    hint: give every parameter a value, by `-D` or, for many starts, by `scc sweep -D x=0:3:1/2`
  [3]

  $ sed 's/^timestep 1/timestep 1\nblocked wait/' walk.sc > blocked.sc; scc check blocked.sc
  error[SC0901]: what is not known of this model does not stay linear: walkers stop where they are blocked (rule Blocked: a kick is taken or not by all that lies on its path)
    hint: give every parameter a value, by `-D` or, for many starts, by `scc sweep -D x=0:3:1/2`; or let walkers bounce, `blocked bounce`
  [3]

Numbers as functions of SMT-LIB:

  $ scc check meet.sc --check meets --check far --check early --smt numbers.smt2 > /dev/null; cat numbers.smt2
  (set-info :smt-lib-version 2.6)
  (set-logic QF_LRA)
  (declare-const d Real)
  (assert (and (<= (* (- 1.0) d) (- 3.0)) (<= d 5.0)))
  (define-fun early-holds () Bool (and (<= (* (- 1.0) d) (- 3.0)) (<= (* 2.0 d) 9.0)))
  (define-fun early-fails () Bool (and (< (* (- 2.0) d) (- 9.0)) (<= d 5.0)))
  (define-fun early-unknown () Bool false)
  (define-fun meets-low () Real (ite (and (<= (* (- 1.0) d) (- 3.0)) (<= d 5.0)) (+ d (- 2.0)) 0.0))
  (define-fun meets-low-infinite () Bool false)
  (define-fun meets-high () Real (ite (and (<= (* (- 1.0) d) (- 3.0)) (<= d 5.0)) (+ d (- 2.0)) 0.0))
  (define-fun meets-high-infinite () Bool false)
  (define-fun meets-unknown () Bool false)
  (define-fun far-low () Real (ite (and (< (* (- 1.0) d) (- 3.0)) (<= d 5.0)) 1.0 0.0))
  (define-fun far-low-infinite () Bool (= d 3.0))
  (define-fun far-high () Real (ite (and (< (* (- 1.0) d) (- 3.0)) (<= d 5.0)) 1.0 0.0))
  (define-fun far-high-infinite () Bool (= d 3.0))
  (define-fun far-unknown () Bool false)

Checks that ask about the same until share its exploration, whatever they ask about it. Each has the answer that it has
alone.

  $ cat > shared.sc <<EOF
  > timestep 1
  > param x in [-1, 1]
  > import <solids>
  > process w = solids.Cube(1) mass 1 at translate (x, 0, 0) [nil]
  > fixed e = solids.Cube(3) at translate (5, 0, 0)
  > motion w = choose { (1, 0, 0) weight 2, (-1, 0, 0), (0,1,0), (0,-1,0) }
  > check a : P = ? [ eventually event bounce(w, e) within 4 ]
  > check b : P >= 1/4 [ eventually event bounce(w, e) within 4 ]
  > check c : Pmax = ? [ always not event bounce(w, e) within 4 ]
  > check d : possibly event bounce(w, e) within 4
  > check e : P = ? [ eventually event bounce(w, e) within 3 ]
  > EOF
  $ scc check shared.sc --where > all
  [1]
  $ for c in a b c d e; do scc check shared.sc --where --check $c; done | grep -v '^explored\|^semantics\|^1 property' > alone
  $ grep -v '^explored\|^semantics\|^5 properties' all | diff -B - alone
  $ grep '^[a-e]:\|^explored' all
  a: 16/625 to 44/125, for x in [-1, 1]; mean 52/625 = 0.0832
  b: violated for x = 0
  c: 81/125 to 609/625, for x in [-1, 1]; mean 573/625 = 0.9168
  d: holds (exhaustive, all x in [-1, 1])
  e: 0 to 36/125, for x in [-1, 1]; mean 4/125 = 0.032
  explored: 221 states, 372 transitions, depth 15; complete
  $ for c in a e; do scc check shared.sc --check $c | grep '^explored'; done
  explored: 136 states, 228 transitions, depth 15; complete
  explored: 85 states, 144 transitions, depth 11; complete
