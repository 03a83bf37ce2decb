Rare events by splitting. The exact number is 1048576/6275373061, about 1.671e-4.

  $ M=../../specs/models
  $ scc estimate $M/far.sc --levels 'x(walker) >= 3, 6..18, 19' --runs 10 --effort 30
  rich: estimated: 1.157e-4, from 5.252e-5 to 5.127e-1 with confidence 99/100, 10 repetitions
    at most 2.357e-4 if no repetition gives more than 3.462e-4, twice the greatest that was found: this is not proved
    share of runs that passed each level, and came to the goal: 0.186667, 0.243333, 0.636667, 0.693333, 0.703333, 0.633333, 0.646667, 0.646667, 0.673333, 0.65, 0.636667, 0.653333, 0.683333, 0.673333, 0.633333, 0.696667
  $ far() { scc estimate $M/far.sc -D n=4 --runs 10 --effort 20 "$@"; }
  $ far --levels 'x(walker) >= 1..3' --json > one.json
  $ far --levels 'x(walker) >= 1..3' --json --jobs 3 | cmp - one.json
  $ grep -A12 '"splitting"' one.json
        "splitting": {
          "mean": "6879/64000",
          "assumed": "5577/16000",
          "likely": "1162720083/5000000000",
          "left": 0,
          "shares": [
            {"passed": 107, "runs": 200},
            {"passed": 116, "runs": 200},
            {"passed": 112, "runs": 200},
            {"passed": 127, "runs": 200}
          ]
        }
      }
  $ far --levels 'x(walker) >= 1..2' --property 'P >= 1/100 [ eventually (not gone(walker) and x(walker) >= 3) ]'
  property1: estimated to hold: 1.676e-1, from 7.756e-2 to 5.951e-1 with confidence 99/100, 10 repetitions
    at most 3.298e-1 if no repetition gives more than 4.8e-1, twice the greatest that was found: this is not proved
    share of runs that passed each level, and came to the goal: 0.535, 0.58, 0.56

Runs that do not come on.

  $ far --levels 'x(walker) >= 1, 900' --property 'P = ? [ eventually (not gone(walker) and x(walker) >= 1000) ]'
  property1: estimated: 0, from 0 to 5.126e-1 with confidence 99/100, 10 repetitions
    share of runs that passed each level, and came to the goal: 0.535, 0, -
    no run passed level 2, of 200 from level 1
  $ far --levels 'x(walker) >= 3/2, 2'
  rich: estimated: 1.135e-1, from 4.937e-2 to 5.688e-1 with confidence 99/100, 10 repetitions
    at most 3.139e-1 if no repetition gives more than 5e-1, twice the greatest that was found: this is not proved
    share of runs that passed each level, and came to the goal: 0.31, 1, 0.375
    all runs passed level 2: it can be left out

A level that is not passed before the goal.

  $ far --levels 'x(walker) >= 1, 900' --property 'P = ? [ eventually (not gone(walker) and x(walker) >= 3) ]'
  property1: estimated: 1.667e-1, from 7.863e-2 to 5.944e-1 with confidence 99/100, 10 repetitions
    at most 3.287e-1 if no repetition gives more than 4.8e-1, twice the greatest that was found: this is not proved
    share of runs that passed each level, and came to the goal: 0.535, 0.315, 1
    all runs from level 2 came to the goal: the level can be left out, or be a lower one

What cannot be asked.

  $ far --levels 'x(walker) >= 2, 1'
  command line: error[SC0205]: levels are not in order: 2 comes before 1
    hint: as in `--levels 'x(p) >= 1, 2, 3'`
  [64]
  $ far --levels 'x(walker)'
  command line: error[SC0205]: levels are a number, a comparison, and the values that it passes one after the other
    hint: as in `--levels 'x(p) >= 1, 2, 3'`
  [64]
  $ far --levels 'x(walker) >= 1, far'
  <level 2>:1:14: error[SC0201]: unknown name `far` in a formula
     |
   1 | x(walker) >= far
     |              ^^^
  [3]
  $ far --levels 'x(walker) >= 0, 1'
  command line: error[SC0205]: level 1 is passed at the start
    hint: leave it out: levels are passed later, one after the other
  [64]
  $ far --levels 'x(walker) >= 1' --property 'P = ? [ always x(walker) >= 3 ]'
  <property 1>:1:1: error[SC0205]: `property1` cannot be estimated: levels are passed on the way to f, in `P = ? [ eventually f ]`
     |
   1 | P = ? [ always x(walker) >= 3 ]
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  [3]
  $ far --levels 'x(walker) >= 1' --until 3 2>&1 | head -1
  scc: --levels cannot be combined with --until or --free evenly: write `within` in the property

It is stopped with what it has.

  $ scc estimate $M/far.sc --levels 'x(walker) >= 1..19' --runs 1000000 --effort 5 --seconds 3 > stopped.txt
  scc: the limit of seconds has passed; what is said rests on the runs that were made
  [4]
  $ grep -c "^rich: estimated: " stopped.txt
  1
