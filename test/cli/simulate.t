Many runs of a model.

  $ M=../../specs/models
  $ scc simulate $M/ruin.sc --runs 3 --seed 7 --observe 'gone(walker)' --observe 'x(walker)' --every 3/2 --until 4
  run,time,gone(walker),x(walker),ended
  0,0,0,0,
  0,3/2,0,1/2,
  0,3,0,-1,
  0,4,0,0,
  1,0,0,0,
  1,3/2,0,1/2,
  1,3,0,-1,
  1,4,1,,
  2,0,0,0,
  2,3/2,0,1/2,
  2,3,0,1,
  2,4,0,0,
  $ scc simulate $M/ruin.sc --runs 3 --seed 7 --observe 'gone(walker)' --observe 'x(walker)' --every 3/2 --until 4 --format jsonl | tail -n +2
  {"run":0,"seed":"7191089600892374487","values":[["0/1","0/1"],["0/1","1/2"],["0/1","-1/1"],["0/1","0/1"]],"ended":null}
  {"run":1,"seed":"309689372594955804","values":[["0/1","0/1"],["0/1","1/2"],["0/1","-1/1"],["1/1",null]],"ended":null}
  {"run":2,"seed":"-1830642326893942270","values":[["0/1","0/1"],["0/1","1/2"],["0/1","1/1"],["0/1","0/1"]],"ended":null}

Each is the run that its seed makes.

  $ seed=$(scc simulate $M/ruin.sc --runs 3 --seed 7 --observe 'gone(walker)' --every 1 --until 4 --format jsonl | tail -1 | sed 's/.*"seed": *"\([-0-9]*\)".*/\1/')
  $ scc trace $M/ruin.sc --choose random:$seed --time 4 --human | grep -c draws
  5
  $ scc trace $M/ruin.sc --choose random:$seed --time 4 --human | grep 'gone'
  [1]

The same bytes, however many processes work at it, and each run is the same among more or less of them.

  $ sim() { scc simulate $M/brownian.sc --seed=-3 --observe 'x(ligand)' --observe 'bound(ligand, pocket)' --every 1 --until 12 "$@"; }
  $ sim --runs 40 > one.csv
  $ for j in 2 3 7; do sim --runs 40 --jobs $j | cmp - one.csv; done
  $ sim --runs 10 | cmp - one.csv
  cmp: EOF on - after byte 1764, line 131
  [1]

All together.

  $ sim --runs 200 --jobs 2 --summary --quantiles 0,0.5,1 | sed -n '1p;$p' | cut -d, -f 1-9
  time,observable,count,mean,variance,deviation,least,quantile 0,quantile 1/2
  12,"bound(ligand, pocket)",200,1/200,1/200,0.070711,0,0
  $ sim --runs 200 --summary --format jsonl | sed -n '2p'
  {"time":"0/1","observable":"x(ligand)","count":200,"mean":"-5/2","variance":"0/1","deviation":"0.000000","least":"-5/2","quantiles":[{"of":"1/20","value":"-5/2"},{"of":"1/2","value":"-5/2"},{"of":"19/20","value":"-5/2"}],"greatest":"-5/2"}

With a chart.

  $ sim --runs 30 --plot chart.svg > runs.csv
  $ sim --runs 30 | cmp - runs.csv
  $ sim --runs 30 --jobs 2 --summary --plot again.svg > summary.csv
  $ cmp chart.svg again.svg
  $ grep '<text' chart.svg | sed 's/.*">//; s/<.*//' | head -4
  brownian
  mean of 30 runs, and the range from the quantile 1/20 to 19/20; seed -3
  x(ligand)
  0
  $ sim --runs 30 --format jsonl --decimals 3 --resume no.jsonl --plot chart.svg 2>&1 | head -1
  scc: --resume with --decimals does not go with --plot, which takes exact numbers

An interrupted one goes on where it ended; a line that was not finished is made anew.

  $ sim --runs 40 --format jsonl > all.jsonl
  $ head -c 5000 all.jsonl > part.jsonl
  $ sim --runs 40 --jobs 2 --format jsonl --resume part.jsonl
  $ cmp part.jsonl all.jsonl
  $ sim --runs 20 --format jsonl -o less.jsonl
  $ sim --runs 40 --format jsonl --resume less.jsonl -o more.jsonl
  $ cmp more.jsonl all.jsonl
  $ scc simulate $M/brownian.sc --seed 4 --observe 'x(ligand)' --every 1 --until 12 --runs 40 --format jsonl --resume part.jsonl
  part.jsonl: error[SC0804]: this file is not of the same simulation: its first line would be `{"format":"scc-simulation","version":1,"semantics":"3","model":"brownian","digest":"md5:b2ca4903fb9120551d262c436336e209","parameters":{},"settings":{"timestep":"1 steady","kick":"1"},"seed":"4","observables":["x(ligand)"],"decimals":null,"times":["0/1","1/1","2/1","3/1","4/1","5/1","6/1","7/1","8/1","9/1","10/1","11/1","12/1"],"summary":null}`
  [3]
  $ sed '3d' all.jsonl > torn.jsonl
  $ sim --runs 40 --format jsonl --resume torn.jsonl
  torn.jsonl: error[SC0804]: line 3 is not that of run 1
  [3]
  $ sim --runs 40 --resume part.jsonl
  scc: --resume goes on with JSON Lines: --format jsonl
  Usage: scc simulate [OPTION]… MODEL
  Try 'scc simulate --help' or 'scc --help' for more information.
  [64]
  $ cmp part.jsonl all.jsonl

What is told of all runs counts those that were there, and leaves their file alone.

  $ sim --runs 40 --summary --decimals 3 --plot once.svg > once.csv
  $ sim --runs 40 --format jsonl --summary --decimals 3 > once.jsonl
  $ cp less.jsonl kept.jsonl
  $ sim --runs 40 --format jsonl --summary --decimals 3 --plot twice.svg --resume less.jsonl | cmp - once.jsonl
  $ sim --runs 40 --summary --decimals 3 --resume less.jsonl | cmp - once.csv
  $ cmp once.svg twice.svg
  $ cmp less.jsonl kept.jsonl
  $ sim --runs 40 --format jsonl --plot twice.svg --resume less.jsonl
  $ cmp once.svg twice.svg
  $ cmp less.jsonl all.jsonl
  $ sim --runs 20 --format jsonl --summary --resume all.jsonl > of20.jsonl
  $ sim --runs 20 --format jsonl --summary | cmp - of20.jsonl
  $ sed '3s/"values":\[\[/"values":[["x",/' all.jsonl > odd.jsonl
  $ sim --runs 40 --format jsonl --summary --resume odd.jsonl
  odd.jsonl: error[SC0804]: line 3 is no run
  [3]

Parts, one after the other, are the whole.

  $ parts() { n=$1; shift; for k in $(seq $n); do "$@" --part $k/$n | if [ $k = 1 ]; then cat; else tail -n +2; fi; done; }
  $ parts 7 sim --runs 40 --jobs 2 --format jsonl | cmp - all.jsonl
  $ parts 50 sim --runs 40 --format jsonl | cmp - all.jsonl
  $ sim --runs 40 | cksum > all.cksum
  $ parts 3 sim --runs 40 | cksum | cmp - all.cksum
  $ sim --runs 40 --format jsonl --part 1/1000000000000000 | cmp - all.jsonl
  cmp: EOF on - after byte 371, line 1
  [1]
  $ sim --runs 40 --part 9/8 2>&1 | head -1
  scc: option '--part': `9/8' is no part: the third of eight is 3/8
  $ sim --runs 40 --part 2 2>&1 | head -1
  scc: option '--part': `2' is no part: the third of eight is 3/8
  $ sim --runs 40 --part 1/2 --format jsonl --resume part.jsonl 2>&1 | head -1
  scc: --resume does not go with --part

Runs that are over early.

  $ cat > never.sc <<'END'
  > import <solids>
  > process p = solids.Cube(1) mass 1 [nil]
  > motion p = choose { (1,0,0) weight 2 - x }
  > END
  $ scc simulate never.sc --runs 1 --observe 'x(p)' --every 1 --until 4
  run,time,x(p),ended
  0,0,0,over at time 1: the law of motion of p cannot be evaluated: the weights of all its velocities are 0
  0,1,,over at time 1: the law of motion of p cannot be evaluated: the weights of all its velocities are 0
  0,2,,over at time 1: the law of motion of p cannot be evaluated: the weights of all its velocities are 0
  0,3,,over at time 1: the law of motion of p cannot be evaluated: the weights of all its velocities are 0
  0,4,,over at time 1: the law of motion of p cannot be evaluated: the weights of all its velocities are 0
  scc: 1 run did not come to the last time; what was not observed is empty
  [2]

Numbers that are rounded.

  $ scc simulate $M/ruin.sc --runs 1 --observe 'x(walker) / 7' --every 1/3 --until 1 --decimals 4
  run,time,x(walker) / 7,ended
  0,0.0000,0.0000,
  0,0.3333,0.0476,
  0,0.6667,0.0952,
  0,1.0000,0.1429,

What cannot be asked.

  $ scc simulate $M/ruin.sc --runs 0 --observe 'x(walker)' --every 1 --until 4 2>&1 | head -1
  scc: option '--runs': `0' is no positive number of runs
  $ scc simulate $M/ruin.sc --runs 1 --seed x --observe 'x(walker)' --every 1 --until 4 2>&1 | head -1
  scc: option '--seed': `x' is no integer of 64 bits
  $ scc simulate $M/ruin.sc --runs 1 --observe 'x(walker)' --every 0 --until 4 2>&1 | head -1
  scc: option '--every': `0' is not positive, and no step
  $ scc simulate $M/ruin.sc --runs 1 --observe 'x(walker)' --every 1/1000000 --until 4 2>&1 | head -1
  scc: --every and --until make more than 1000000 times
  $ scc simulate $M/ruin.sc --runs 1 --observe 'x(nobody)' --every 1 --until 4
  <observable 1>:1:3: error[SC0201]: unknown process `nobody`
     |
   1 | x(nobody)
     |   ^^^^^^
  [3]
  $ scc simulate $M/ruin.sc --runs 1 --observe 'eventually gone(walker)' --every 1 --until 4
  <observable 1>:1:1: error[SC0205]: eventually gone(walker) is a formula about runs: a number or a predicate of a state is needed here
     |
   1 | eventually gone(walker)
     | ^^^^^^^^^^^^^^^^^^^^^^^
    hint: `scc check` decides it
  [3]
  $ scc simulate $M/ruin.sc --runs 1 --observe 'x(walker)' --every 1 --until 4 --quantiles 2 --summary 2>&1 | head -1
  scc: a quantile is not above 1
  $ scc simulate $M/meeting.sc --runs 1 --observe 'time' --every 1 --until 4
  error[SC0903]: this needs the values of all parameters, and of `y`, `z` a range is known
    hint: `scc check` answers for all values; `-D y=VALUE` gives one; `scc trace --start simple` chooses them
  [3]
  $ scc simulate $M/ruin.sc --runs 1 --observe 'x(walker)' --every 1 --until 4 -o /dev/full
  /dev/full: error[SC0103]: cannot write: No space left on device
  [74]

What is whole stays when the disk is full. (Here no file may be larger than 8 KiB; 512 bytes are a unit.)

  $ limited() { (trap '' XFSZ; ulimit -f 16; "$@"); }
  $ limited scc simulate $M/ruin.sc --runs 500 --seed 1 --observe 'x(walker)' --every 1 --until 4 -o long.csv
  long.csv: error[SC0103]: cannot write: File too large
    hint: what was complete before that is in the file
  [74]
  $ scc simulate $M/ruin.sc --runs 500 --seed 1 --observe 'x(walker)' --every 1 --until 4 > whole.csv
  $ head -c $(wc -c < long.csv) whole.csv | cmp - long.csv && tail -c 1 long.csv | od -An -c
    \n
  $ test $(wc -l < long.csv) -gt 300 && echo a good many
  a good many
  $ limited scc simulate $M/ruin.sc --runs 500 --seed 1 --observe 'x(walker)' --every 1 --until 4 --format jsonl -o long.jsonl
  long.jsonl: error[SC0103]: cannot write: File too large
    hint: what was complete before that is in the file
  [74]
  $ scc simulate $M/ruin.sc --runs 500 --seed 1 --observe 'x(walker)' --every 1 --until 4 --format jsonl --resume long.jsonl
  $ scc simulate $M/ruin.sc --runs 500 --seed 1 --observe 'x(walker)' --every 1 --until 4 --format jsonl | cmp - long.jsonl
  $ limited scc simulate $M/ruin.sc --runs 4 --observe 'x(walker)' --every 1/200 --until 4 -o early.csv
  early.csv: error[SC0103]: cannot write: File too large
  [74]
  $ ls early.csv
  ls: cannot access 'early.csv': No such file or directory
  [2]

The draws and lots of one instant are one of the transitions of --steps: here a draw of all, and the time.

  $ scc simulate $M/crowds/dimers.sc -D n=4 --runs 1 --observe 'bonds(d)' --every 1 --until 3 --steps 5
  run,time,bonds(d),ended
  0,0,0,"ended by `--steps 5`, at time 2"
  0,1,0,"ended by `--steps 5`, at time 2"
  0,2,0,"ended by `--steps 5`, at time 2"
  0,3,,"ended by `--steps 5`, at time 2"
  scc: 1 run did not come to the last time; what was not observed is empty; without `--steps` a run goes on to that time, if it can
  [2]

An observable with the name of a column has its own column in round brackets, as a parameter of a sweep has:

  $ printf 'import <solids>\nparam run = 7\nparam ended = 8\nprocess p = solids.Cube(1) mass 1 [nil]\n' > names.sc
  $ scc simulate names.sc --observe time --observe run --observe ended --every 1/2 --until 1 --runs 1 2> /dev/null
  run,time,(time),(run),(ended),ended
  0,0,0,7,8,
  0,1/2,1/2,7,8,
  0,1,1,7,8,

A page of runs. What it does not go with is said before any run.

  $ view() { scc simulate $M/ruin.sc --runs 3 --observe 'x(walker)' --every 1 --until 4 --view page.html "$@"; }
  $ view -o table.csv && grep -c '"spread":' page.html
  1
  $ view --jobs 2 -o other.csv && cmp table.csv other.csv
  $ view --resume one.jsonl --format jsonl 2>&1 | head -1
  scc: --view and --resume do not go together: with --store, the same command resumes and writes the page
  $ scc simulate $M/ruin.sc --runs 3 --observe 'x(walker)' --every 1 --until 200000 --view far.html 2>&1 | head -2; ls far.html 2>&1 | wc -l
  scc: a page of --view has room for 10000 values of a run, and these are 200001 (1 observable at 200001 times): take a greater --every, or fewer observables
  Usage: scc simulate [OPTION]… MODEL
  1
  $ view -o page.html 2>&1 | head -1
  scc: -o and --view name the same file
  $ view -o ./page.html 2>&1 | head -1
  scc: -o and --view name the same file
  $ view --store kept --summary -o summary.csv && cp page.html first.html && view --store kept --format jsonl -o runs.jsonl && cmp page.html first.html
