Rigid models: bodies that spin. One that turns hits one at rest.

  $ cat > spin.sc <<'END'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
  > }
  > process p = Cube mass 1 velocity (1,0,0) spin (0,1/3,1/2) [nil]
  > process q = Cube mass 1 at translate (4,1/2,0) [nil]
  > timestep 1/2
  > resolution 2^-10
  > dynamics constant_spin
  > check meet : possibly touching(p, q) within 3
  > check kept : always energy = 67/108 and spin2(p) + spin2(q) > 1/4 within 2
  > check turn : always angular.z = 1/3 within 2
  > END

Verdicts say at which resolution they hold.

  $ scc check spin.sc
  semantics 3: timestep 1/2, dynamics constant_spin, resolution 1/1024
  
  meet: holds (exhaustive), at resolution 1/1024
    possibly touching(p, q) within 3
    a run that shows it:
      1-2. time passes 2 times by 1/2, to time 1
        3. time passes by 5/16, to time 21/16
      touching(p, q) holds
      there:
        p at (21/16, 0, 0) turned (104976, 0, 24062, 36093) [nil], velocity (1, 0, 0), spin (0, 1/3, 1/2)
        q at (4, 1/2, 0) [nil], velocity (0, 0, 0)
  
  kept: holds (exhaustive), at resolution 1/1024
    always energy = 67/108 and spin2(p) + spin2(q) > 1/4 within 2
  
  turn: holds (exhaustive), at resolution 1/1024
    always angular.z = 1/3 within 2
  
  explored: 7 states, 6 transitions, depth 6, model time 37/16; not complete: every property was decided before
  3 properties: 3 hold
  $ scc trace spin.sc --steps 5 --human
  time 0
          p at (0, 0, 0) [nil], velocity (1, 0, 0), spin (0, 1/3, 1/2)
          q at (4, 1/2, 0) [nil], velocity (0, 0, 0)
    1-2.  time passes 2 times by 1/2   {Time, TimeBehaviour, Turn}
  time 1
          p at (1, 0, 0) turned (563, 0, 96, 144) [nil], velocity (1, 0, 0), spin (0, 1/3, 1/2)
          q at (4, 1/2, 0) [nil], velocity (0, 0, 0)
      3.  time passes by 5/16   {Time, TimeBehaviour, Turn}
  time 21/16
          p at (21/16, 0, 0) turned (104976, 0, 24062, 36093) [nil], velocity (1, 0, 0), spin (0, 1/3, 1/2)
          q at (4, 1/2, 0) [nil], velocity (0, 0, 0)
      4.  p and q collide and bounce   {Bounce}
  time 21/16
          p at (21/16, 0, 0) turned (104976, 0, 24062, 36093) [nil], velocity (~0.209176, 0, 0), spin (0, ~-0.122241, ~0.409757)
          q at (4, 1/2, 0) [nil], velocity (~0.790824, 0, 0), spin (0, ~0.455575, ~0.683362)
      5.  time passes by 1/2   {Time, TimeBehaviour, Turn}
  time 29/16
          p at (~1.417088, 0, 0) turned ~(0.588715, -0.020590, 0.120346, 0.270348) [nil], velocity (~0.209176, 0, 0), spin (0, ~-0.122241, ~0.409757)
          q at (~4.395412, 1/2, 0) turned ~(0.778371, 0.000000, 0.088652, 0.132977) [nil], velocity (~0.790824, 0, 0), spin (0, ~0.455575, ~0.683362)
  5 transitions, time 29/16: more can happen

A trace tells orientations, spins and how long ago each turn began; it is its own schedule.

  $ scc trace spin.sc --steps 6 -o run.jsonl
  $ sed -n 4p run.jsonl
  {"type":"transition","step":2,"choice":0,"of":1,"label":{"kind":"time","text":"time(1/2)","duration":"1/2"},"rules":["Time","TimeBehaviour","Turn"],"time":"1/1","state":{"processes":[{"velocity":["1/1","0/1","0/1"],"spin":["0/1","1/3","1/2"],"since":"0/1","lasts":"1/2","clock":null,"leaves":[{"name":"p","position":["1/1","0/1","0/1"],"turned":["563","0","96","144"],"behaviour":"nil","origin":null}],"bonds":[]},{"velocity":["0/1","0/1","0/1"],"spin":["0/1","0/1","0/1"],"since":"0/1","lasts":"0/1","clock":null,"leaves":[{"name":"q","position":["4/1","1/2","0/1"],"turned":["1","0","0","0"],"behaviour":"nil","origin":null}],"bonds":[]}],"step":null}}
  $ scc trace spin.sc --schedule run.jsonl | cmp - run.jsonl
  $ scc trace spin.sc --steps 1 --itf | grep vars
  "vars": ["action","time","position","velocity","behaviour","origin","process","bonds","clock","step","turned","spin","since","lasts"],
  $ scc trace spin.sc --steps 1 --itf | tail -3 | head -1 | cut -d , -f 1-2
  {"#meta":{"index":1,"ending":"open"}

Graphs give the motion with the places.

  $ scc explore spin.sc --time 1 --format dot --positions -o - | grep velocity
  scc: semantics 3: timestep 1/2, dynamics constant_spin, resolution 1/1024
  scc: explored: 4 states, 3 transitions
  scc: TRUNCATED: 1 states unexplored, by the time bound 1
    s0 [label="0\np at (0, 0, 0), velocity (1, 0, 0), spin (0, 1/3, 1/2)\nq at (4, 1/2, 0), velocity (0, 0, 0)", style="rounded,filled", fillcolor="white"]
    s1 [label="1\np at (1/2, 0, 0) turned (24, 0, 2, 3), velocity (1, 0, 0), spin (0, 1/3, 1/2)\nq at (4, 1/2, 0), velocity (0, 0, 0)", style="rounded,filled", fillcolor="white"]
    s2 [label="2\np at (1, 0, 0) turned (563, 0, 96, 144), velocity (1, 0, 0), spin (0, 1/3, 1/2)\nq at (4, 1/2, 0), velocity (0, 0, 0)", style="rounded,filled", fillcolor="white"]
    s3 [label="3\np at (21/16, 0, 0) turned (104976, 0, 24062, 36093), velocity (1, 0, 0), spin (0, 1/3, 1/2)\nq at (4, 1/2, 0), velocity (0, 0, 0)", style="rounded,filled,dashed", fillcolor="white"]

The settings are printed in one form.

  $ cat > settings.sc <<'END'
  > dynamics   free_body resolution 1/1048576
  > round orientation 1/1024  round velocity 0.125 param round = 2
  > END
  $ scc fmt settings.sc
  dynamics free_body
  resolution 1/1048576
  round orientation 1/1024
  round velocity 2^-3
  param round = 2

Where nothing turns they have no effect.

  $ sed -e 's/spin (0,1\/3,1\/2)//; /dynamics/d' spin.sc > still.sc
  $ scc check still.sc
  still.sc:9:12: warning[SC0213]: `resolution` has no effect: nothing spins, and the model has no `dynamics`
     |
   9 | resolution 2^-10
     |            ^^^^^
  semantics 3
  
  meet: holds (exhaustive)
    possibly touching(p, q) within 3
    a run that shows it:
      1. time passes by 2, to time 2
      touching(p, q) holds
      there:
        p at (2, 0, 0) [nil], velocity (1, 0, 0)
        q at (4, 1/2, 0) [nil], velocity (0, 0, 0)
  
  kept: violated
    always energy = 67/108 and spin2(p) + spin2(q) > 1/4 within 2
    a run that violates it:
      in the initial state
      energy = 67/108 fails: energy = 1/2
      (spin2(p) + spin2(q)) > 1/4 fails: (spin2(p) + spin2(q)) = 0
      there:
        p at (0, 0, 0) [nil], velocity (1, 0, 0)
        q at (4, 1/2, 0) [nil], velocity (0, 0, 0)
  
  turn: violated
    always angular.z = 1/3 within 2
    a run that violates it:
      in the initial state
      angular.z = 1/3 fails: angular.z = 0
      there:
        p at (0, 0, 0) [nil], velocity (1, 0, 0)
        q at (4, 1/2, 0) [nil], velocity (0, 0, 0)
  
  explored: 2 states, 1 transition, depth 1, model time 2; not complete: every property was decided before
  3 properties: 1 holds, 2 violated
  [1]

What turns after turns change is not followed for ever: the spin of a free body that does not spin about a principal
axis, the energy of one whose orientation is rounded, and the place of a part off the centre.

  $ cat > free.sc <<'EOF'
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > dynamics free_body
  > process p = Cube scaled (1,2,3) mass 1 spin (1,1/10,1/5) [nil]
  > process q = Cube mass 1 spin (1,1/10,1/5) at translate (100,0,0) [nil]
  > check changes : always wx(p) < 2
  > check cube    : always wx(q) = 1
  > check place   : always x(p) = 0
  > EOF
  $ scc check free.sc
  free.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  semantics 3: timestep 1, dynamics free_body, resolution 1/524288
  
  changes: undecided: what turns with a body that spins for ever is not followed
    always wx(p) < 2
  
  cube: holds (exhaustive), at resolution 1/524288
    always wx(q) = 1
  
  place: holds (exhaustive), at resolution 1/524288
    always x(p) = 0
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  3 properties: 2 hold, 1 undecided
  [2]
  $ sed 's/dynamics free_body/dynamics constant_spin round orientation 2^-3/; s/always wx(p) < 2/always energy = energy + 0 * wx(p)/' free.sc > rounded.sc
  $ scc check rounded.sc
  rounded.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  semantics 3: timestep 1, dynamics constant_spin, resolution 1/524288, round orientation 2^-3
  
  changes: undecided: what turns with a body that spins for ever is not followed
    always energy = energy + 0*wx(p)
  
  cube: holds (exhaustive), at resolution 1/524288
    always wx(q) = 1
  
  place: holds (exhaustive), at resolution 1/524288
    always x(p) = 0
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  3 properties: 2 hold, 1 undecided
  [2]
