Probabilities and means from many runs.

  $ M=../../specs/models
  $ scc estimate $M/ruin.sc --check how_often --check by_four --runs 500
  how_often: estimated: 0.8, from 0.750133 to 0.844019 with confidence 99/100, 500 runs
  
  by_four: estimated: 0.614, from 0.55603 to 0.669758 with confidence 99/100, 500 runs

A mean has an interval where its number is in a range, and one end where that has one end. Of others nothing is known,
however little the sample varies.

  $ scc estimate $M/crosslink.sc --check at_6 --free evenly --runs 500
  at_6: estimated: 0.058, from 0.03439 to 0.090387 with confidence 99/100, 500 runs
    choices that nothing draws were taken evenly
  $ scc estimate $M/association.sc --check mean_at_3 --runs 500
  mean_at_3: estimated: from 0.726419 to 2.155386 with confidence 99/100, 500 runs
    the mean of the 317 runs with a number is 1.394322; 183 runs are open, and may differ
    183 of 500 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  [2]
  $ scc estimate $M/association.sc --property 'E >= 1/2 [ bonds() at 3 ]' --property 'E > 2 [ count(i in 1..n: bound(m[i], s[i])) at 3 ]'
  property1: estimated to hold: from 0.596771 to 3.397017 with confidence 99/100, 128 runs
  
  property2: undecided whether it is > 2: from 0.596771 to 2.339053 with confidence 99/100, 128 runs
    the mean of the 81 runs with a number is 1.432099; 47 runs are open, and may differ
    47 of 128 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  [2]
  $ scc estimate $M/ruin.sc --check drift --check how_long --runs 500 --seed 7
  how_long: estimated: 5.372, at least 4.709917 with confidence 99/100, 500 runs
    no greatest value of this number is known, and so no upper end: a value too rare to be among the runs may raise the mean by any amount
  
  drift: estimated: -0.254, from -0.444034 to -0.055967 with confidence 99/100, 500 runs
  [2]
  $ cat > rare.sc <<'END'
  > // The mean is 1 (1000 with 1/1000): a sample without the rare draw has variance 0.
  > timestep 1 steady
  > process p = box(1/4, 1/4, 1/4) mass 1 [nil]
  > motion p = choose { (1000, 0, 0) weight 1, (0, 0, 0) weight 999 }
  > check mean : E = ? [ x(p) at 1 ]
  > check below : E <= 1/2 [ x(p) at 1 ]
  > check often : E <= 1/2 [ if x(p) > 0 then 1 else 0 at 1 ]
  > check never : E <= 1/100000 [ if x(p) > 0 then 1 else 0 at 1 ]
  > END
  $ scc estimate rare.sc
  mean: estimated: 0.9, from -0.096175 to 2.708808 with confidence 99/100, 10000 runs
    more than 10000 runs are needed: --most
  
  below: undecided whether it is <= 1/2: 0.9, from -0.096175 to 2.708808 with confidence 99/100, 10000 runs
    more than 10000 runs are needed: --most
  
  often: estimated to hold: 0, from 0 to 0.04573 with confidence 99/100, 128 runs
  
  never: estimated to be violated: 0.001524, from 0.000119 to 0.006186 with confidence 99/100, 3280 runs
  [1]
  $ scc estimate rare.sc --check below --runs 1
  below: undecided whether it is <= 1/2: 0, from -998.763141 to 998.763141 with confidence 99/100, 1 run
    more runs would tell more
  [2]

Under a law that depends on places no speed is known, and so no range: nothing is said, though the sample has no variance.

  $ sed 's/(1000, 0, 0)/(1000 + x, 0, 0)/' rare.sc > far.sc
  $ scc estimate far.sc --check mean --check below
  mean: sampled: the mean of these runs alone is 0, with the standard deviation 0, 128 runs
    no range of this number is known, and so no interval: a value too rare to be among the runs may move the mean by any amount. `scc check` tells the mean where it gets to the end
    `E = ? [ max(-a, min(f, a)) at T ]` has an interval by `scc estimate`, for its number f and a bound a that you choose
  
  below: undecided whether it is <= 1/2: the mean of these runs alone is 0, with the standard deviation 0, 128 runs
    no range of this number is known, and so no interval: a value too rare to be among the runs may move the mean by any amount. `scc check` tells the mean where it gets to the end
    `E = ? [ max(-a, min(f, a)) at T ]` has an interval by `scc estimate`, for its number f and a bound a that you choose
  [2]
  $ scc estimate far.sc --check below --runs 1
  below: undecided whether it is <= 1/2: the mean of these runs alone is 0, 1 run
    no range of this number is known, and so no interval: a value too rare to be among the runs may move the mean by any amount. `scc check` tells the mean where it gets to the end
    `E = ? [ max(-a, min(f, a)) at T ]` has an interval by `scc estimate`, for its number f and a bound a that you choose
  [2]
  $ scc estimate far.sc --property 'E <= 1/2 [ max(-1000, min(x(p), 1000)) at 1 ]' --property 'E >= 1 [ speed2(p) at 1/2 ]'
  property1: undecided whether it is <= 1/2: 0.9, from -0.096175 to 2.708808 with confidence 99/100, 10000 runs
    more than 10000 runs are needed: --most
  
  property2: undecided whether it is >= 1: 0, at least 0 with confidence 99/100, 128 runs
    no greatest value of this number is known, and so no upper end: a value too rare to be among the runs may raise the mean by any amount
  [2]

The same, however many processes work at it; the exact numbers are 171/211 and 373/625, about 0.810427 and 0.5968.

  $ scc estimate $M/ruin.sc --check how_often --check by_four --json > one.json
  $ scc estimate $M/ruin.sc --check how_often --check by_four --json --jobs 5 | cmp - one.json
  $ scc estimate $M/ruin.sc --check how_often --check by_four
  how_often: estimated: 0.80813, from 0.785406 to 0.828771 with confidence 99/100, 4920 runs
  
  by_four: estimated: 0.594851, from 0.572041 to 0.617383 with confidence 99/100, 7380 runs

Comparisons end as soon as they are decided.

  $ scc estimate $M/ruin.sc --property 'P >= 1/2 [ eventually event absorb(walker, ruin) ]' --property 'P < 1/2 [ eventually event absorb(walker, ruin) ]' --property 'E <= 20 [ time U gone(walker) ]'
  property1: estimated to hold: 0.75, from 0.629163 to 0.848442 with confidence 99/100, 128 runs
  
  property2: estimated to be violated: 0.75, from 0.629163 to 0.848442 with confidence 99/100, 128 runs
  
  property3: undecided whether it is <= 20: 5.2183, at least 5.060784 with confidence 99/100, 10000 runs
    no greatest value of this number is known, and so no upper end: a value too rare to be among the runs may raise the mean by any amount
    more than 10000 runs are needed: --most
  [1]
  $ scc estimate $M/ruin.sc --check surely --most 200
  surely: undecided whether it is >= 1: 1, from 0.95427 to 1 with confidence 99/100, 128 runs
    runs can refute this bound, and never confirm it: no probability is beyond it
  [2]

What nobody draws is left open, or taken evenly, and then it is said.

  $ ask() { scc estimate $M/dimer.sc --property 'P = ? [ eventually bonds() = 0 ]' --property 'P >= 1/10 [ always bonds() > 0 ]' --property 'E = ? [ bonds() at 3 ]' "$@"; }
  $ ask
  property1: undecided: not known, 128 runs
    128 of 128 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; where these are weak splits, a `rate` or a `chance` of the split draws them; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  
  property2: undecided whether it is >= 1/10: not known, 128 runs
    128 of 128 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; where these are weak splits, a `rate` or a `chance` of the split draws them; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  
  property3: undecided: not known, 128 runs
    128 of 128 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; where these are weak splits, a `rate` or a `chance` of the split draws them; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  [2]
  $ ask --free evenly --runs 200
  property1: estimated: 1, from 0.973856 to 1 with confidence 99/100, 200 runs
    choices that nothing draws were taken evenly
  
  property2: estimated to be violated: 0, from 0 to 0.026144 with confidence 99/100, 200 runs
    choices that nothing draws were taken evenly
  
  property3: estimated: 0.105, from 0.04095 to 0.226771 with confidence 99/100, 200 runs
    choices that nothing draws were taken evenly
  [1]

Runs that do not end.

  $ scc estimate $M/brownian.sc --property 'P = ? [ eventually bound(ligand, pocket) ]' --runs 40 --steps 50
  kick 1
  
  property1: estimated: from 0.002616 to 1 with confidence 99/100, 40 runs
    it is so in 2 of the 2 runs that tell; 38 runs are open, and may differ
    38 of 40 runs were left before it was known: --steps
  [2]
  $ scc estimate $M/brownian.sc --property 'P = ? [ eventually bound(ligand, pocket) ]' --runs 40 --until 5
  kick 1
  
  property1: undecided: not known, 40 runs
    40 of 40 runs were left before it was known: --until
  [2]
  $ scc estimate $M/ruin.sc --property 'P = ? [ eventually x(walker) >= 0 ]' --property 'P = ? [ eventually vx(walker) > 0 ]' --runs 40 --until 0 --seed -5
  property1: estimated: 1, from 0.875939 to 1 with confidence 99/100, 40 runs
  
  property2: estimated: from 0.316818 to 1 with confidence 99/100, 40 runs
    it is so in 21 of the 21 runs that tell; 19 runs are open, and may differ
    19 of 40 runs were left before it was known: --until
  [2]
  $ scc estimate $M/ruin.sc --property 'E = ? [ x(walker) at 99 ]' --property 'E = ? [ time U x(walker) >= 2 ]' --runs 40
  property1: undecided: not known, 40 runs
    40 of 40 runs do not tell: `walker` is gone, and nowhere: ask for `gone(walker)` first
  
  property2: undecided: not known, 40 runs
    the mean of the 14 runs with a number is 3.714286; 26 runs are open, and may differ
    26 of 40 runs do not tell: something that it asks for has no value there
  [2]

It is stopped with what it has.

  $ python3 -B interrupt.py 0.3 scc estimate $M/brownian.sc --check by_ten --width 1/10000 --most 100000000 > stopped.txt
  scc: interrupted; what is said rests on the runs that were made
  [4]
  $ grep -o "^by_ten: estimated:" stopped.txt
  by_ten: estimated:
  $ scc estimate $M/brownian.sc --check by_ten --width 1/10000 --most 100000000 --seconds 1 > stopped.txt
  scc: the limit of seconds has passed; what is said rests on the runs that were made
  [4]
  $ grep -o "^by_ten: estimated:" stopped.txt
  by_ten: estimated:

What cannot be asked.

  $ scc estimate $M/dimer.sc
  ../../specs/models/dimer.sc:1:1: error[SC0205]: no check of the model asks for a probability or a mean
     |
   1 | // Two dimers born bound. For two time units nothing can happen; then the
     | ^
    hint: `--property 'P = ? [ eventually f ]'` asks
  [3]
  $ scc estimate $M/ruin.sc --check ruined
  ../../specs/models/ruin.sc:18:7: error[SC0205]: `ruined` cannot be estimated: no probability or mean is asked for: `scc check` decides it
      |
   18 | check ruined    : possibly event absorb(walker, ruin)                          // expect: holds
      |       ^^^^^^
  [3]
  $ scc estimate $M/ruin.sc --check howoften
  command line: error[SC0201]: the model has no check `howoften`
    hint: did you mean `how_often`?
  [64]
  $ scc estimate $M/ruin.sc --property 'x(walker)'
  <property 1>:1:1: error[SC0205]: this is about states, and asks for no probability and no mean
     |
   1 | x(walker)
     | ^^^^^^^^^
    hint: as in `P = ? [ eventually f ]`, `E = ? [ x(p) at 10 ]`
  [3]
  $ scc estimate $M/ruin.sc --property 'P = ? [ eventually AG gone(walker) ]'
  <property 1>:1:1: error[SC0205]: `property1` cannot be estimated: what is in its brackets is about other runs: single ones do not tell
     |
   1 | P = ? [ eventually AG gone(walker) ]
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  [3]
  $ scc estimate $M/ruin.sc --confidence 1 2>&1 | head -1
  scc: a confidence is below 1
  $ scc estimate $M/ruin.sc --width 0 2>&1 | head -1
  scc: option '--width': `0' is not positive, and no width
  $ scc estimate $M/ruin.sc --seed 1/2 2>&1 | head -1
  scc: option '--seed': `1/2' is no integer of 64 bits
  $ scc estimate $M/meeting.sc
  error[SC0903]: this needs the values of all parameters, and of `y`, `z` a range is known
    hint: `scc check` answers for all values; `-D y=VALUE` gives one; `scc trace --start simple` chooses them
  [3]

Where a bound keeps a probability or a mean from being known, `scc check` names the command that tells it, if it has an interval for it.

  $ cat > walk.sc <<'END'
  > timestep 1 steady
  > process w = box(1/4, 1/4, 1/4) mass 1 [nil]
  > motion w = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight 1 }
  > check far  : P = ? [ eventually x(w) > 10 within 100 ]
  > check ever : P >= 1/10 [ eventually x(w) > 3 ]
  > check half : E = ? [ if x(w) > 0 then 1 else 0 at 100 ]
  > check mean : E = ? [ x(w) at 100 ]
  > check near : P = ? [ eventually x(w) > 3 within 4 ]
  > END
  $ scc check walk.sc --states 30 | sed -n '/^[a-z]*: /p; /cure: .scc/p' | cut -c 1-140
  far: in [0, 1], as far as is known: the exploration ended at the bound of 30 states; 4 unexplored states matter
    likely cure: `scc estimate --check far` tells it from many runs, by an interval with a confidence
  ever: holds (exhaustive)
  half: undecided: the exploration ended at the bound of 30 states; 4 unexplored states matter
    likely cure: `scc estimate --check half` tells it from many runs, by an interval with a confidence
  mean: undecided: the exploration ended at the bound of 30 states; 4 unexplored states matter
    likely cure: `scc estimate --check mean` tells it from many runs, by an interval with a confidence
  near: in [0.0625, 0.25], as far as is known: the exploration ended at the bound of 30 states; 3 unexplored states matter
    likely cure: `scc estimate --check near` tells it from many runs, by an interval with a confidence
  explored: 29 states, 36 transitions, depth 8, model time 4; not complete: stopped by the bound of 30 states
  $ scc check walk.sc --states 30 --json | grep likely_cure
        "likely_cure": "`scc estimate --check far` tells it from many runs, by an interval with a confidence"
        "likely_cure": "`scc estimate --check half` tells it from many runs, by an interval with a confidence"
        "likely_cure": "`scc estimate --check mean` tells it from many runs, by an interval with a confidence"
        "likely_cure": "`scc estimate --check near` tells it from many runs, by an interval with a confidence"
  $ scc check walk.sc --states 30 | sed -n 's/.*cure: `scc estimate --check \([a-z]*\)`.*/\1/p' > named; cat named
  far
  half
  mean
  near
  $ for name in $(cat named); do scc estimate walk.sc --check $name --runs 200 | grep -c ' with confidence 99/100, 200 runs'; done
  1
  1
  1
  1
  $ scc check walk.sc --depth 30 | grep -c 'cure: .scc'
  0
  [1]

Where walkers bounce nothing draws which does so first. No interval is given if no run tells anything.

  $ cat > crowd.sc <<'END'
  > timestep 1 steady
  > import <solids>
  > fixed room = solids.Room(6, 6, 1, 1)
  > for i in 0..2, j in 0..1 { process c[i,j] = solids.Cube(1) mass 1 at translate (2*i - 5/2, 2*j - 1/2, 0) [nil] }
  > motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
  > check right : P = ? [ eventually x(c[0,0]) > 0 within 12 ]
  > check half : P >= 1/2 [ eventually x(c[0,0]) > 0 within 12 ]
  > check mean : E = ? [ x(c[0,0]) at 12 ]
  > check share : E = ? [ if x(c[0,0]) > 0 then 1 else 0 at 12 ]
  > END
  $ scc estimate crowd.sc --runs 50
  right: undecided: not known, 50 runs
    50 of 50 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; `blocked wait` leaves none where walkers bounce; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  
  half: undecided whether it is >= 1/2: not known, 50 runs
    50 of 50 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; `blocked wait` leaves none where walkers bounce; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  
  mean: undecided: not known, 50 runs
    50 of 50 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; `blocked wait` leaves none where walkers bounce; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  
  share: undecided: not known, 50 runs
    50 of 50 runs depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in the model draws them; `blocked wait` leaves none where walkers bounce; `--free evenly` takes each choice as often; and `scc check` tells the least and the greatest
  [2]
  $ scc estimate crowd.sc --runs 50 --free evenly --json | grep -E 'verdict|kind'
        "verdict": "estimated",
        "value": {"kind": "probability", "low": "5137/31250", "high": "255387/500000"},
        "verdict": "undecided",
        "value": {"kind": "probability", "low": "5137/31250", "high": "255387/500000"},
        "verdict": "estimated",
          "kind": "mean",
        "verdict": "estimated",
        "value": {"kind": "mean", "mean": "11/50", "low": "45929/500000", "high": "40321/100000"},
  $ sed -i 's/^import/blocked wait\nimport/' crowd.sc
  $ scc estimate crowd.sc --runs 50
  right: estimated: 0.1, from 0.022217 to 0.25805 with confidence 99/100, 50 runs
  
  half: estimated to be violated: 0.1, from 0.022217 to 0.25805 with confidence 99/100, 50 runs
  
  mean: estimated: -1.6, from -3.375847 to -0.054731 with confidence 99/100, 50 runs
  
  share: estimated: 0.1, from 0.022217 to 0.25805 with confidence 99/100, 50 runs
  [1]

Without an end time a run is left after 10 000 transitions. The draws of one instant are one of them, be it of 50 walkers:

  $ cat > many.sc <<'END'
  > import <solids>
  > for i in 1..50 { process w[i] = solids.Cube(1) mass 1 at translate (2*i, 0, 0) [nil] }
  > motion w = choose { (0,0,1), (0,0,2) }
  > check far : P = ? [ eventually z(w[1]) > 400 ]
  > END
  $ scc estimate many.sc --runs 5
  far: estimated: 1, from 0.346572 to 1 with confidence 99/100, 5 runs
  $ scc estimate many.sc --runs 5 --steps 100
  far: undecided: not known, 5 runs
    5 of 5 runs were left before it was known: --steps
  [2]

A check that is decided by a model time has runs of its own, which no other check and no number of transitions ends:

  $ cat > two.sc <<'END'
  > timestep 1/1000 steady
  > import <solids>
  > process w = solids.Cube(1) mass 1 [nil]
  > motion w = choose { (0,0,1), (0,0,2) }
  > check late : P = ? [ eventually z(w) > 1000 ]
  > check soon : P = ? [ always z(w) < 12 within 6 ]
  > END
  $ scc estimate two.sc --runs 2
  late: undecided: not known, 2 runs
    2 of 2 runs were left before it was known: --steps
  
  soon: estimated: 1, from 0.07071 to 1 with confidence 99/100, 2 runs
  [2]

An approximate interval of a mean, where it is asked for, and the spread of the runs is known well enough:

  $ scc estimate $M/ruin.sc --check how_long --runs 500 --seed 7 --normal
  how_long: estimated: 5.372, about from 4.905634 to 5.838366: with confidence 99/100 if the mean of the runs is normal, 500 runs
  $ scc estimate $M/ruin.sc --check how_long --runs 40 --seed 7 --normal
  how_long: estimated: 5.525, at least 3.637215 with confidence 99/100, 40 runs
    25 runs have another value than the most frequent one: --normal needs 30 of them
  [2]
  $ scc estimate two.sc --property 'E = ? [ 1 / (1 + z(w)) at 0 ]' --normal
  property1: estimated: 1, from 1 to 1 with confidence 99/100, 128 runs
  $ scc estimate two.sc --normal --confidence 9999999999999/10000000000000
  scc: --normal takes a confidence of at most 1 - 10^-12
  Usage: scc estimate [OPTION]… MODEL
  Try 'scc estimate --help' or 'scc --help' for more information.
  [64]
  $ scc estimate $M/far.sc --levels 'x(walker) >= 1..19' --normal
  scc: --normal is about means, and --levels about probabilities
  Usage: scc estimate [OPTION]… MODEL
  Try 'scc estimate --help' or 'scc --help' for more information.
  [64]
