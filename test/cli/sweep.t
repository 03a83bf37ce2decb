Checks over a grid of parameters.

  $ M=../../specs/models
  $ scc sweep $M/chain.sc -D n=0..3
  point,n,check,verdict,least from,least to,greatest from,greatest to,why
  0,0,,invalid,,,,,SC0201: unknown process `c[0]`
  1,1,whole,holds,,,,,
  1,1,bonded,holds,,,,,
  1,1,slows,holds,,,,,
  1,1,momentum,holds,,,,,
  1,1,heat,holds,,,,,
  1,1,free,violated,,,,,
  2,2,whole,holds,,,,,
  2,2,bonded,holds,,,,,
  2,2,slows,holds,,,,,
  2,2,momentum,holds,,,,,
  2,2,heat,holds,,,,,
  2,2,free,violated,,,,,
  3,3,whole,holds,,,,,
  3,3,bonded,holds,,,,,
  3,3,slows,holds,,,,,
  3,3,momentum,holds,,,,,
  3,3,heat,holds,,,,,
  3,3,free,violated,,,,,
  scc: the model is invalid at 1 of 4 points
  [2]
  $ cat > walk.sc <<'END'
  > model walk
  > param p = 1/2
  > param n = 3
  > import <solids>
  > process walker = solids.Cube(1) mass 1 [nil]
  > fixed left  = solids.Cube(1) absorb at translate (-3, 0, 0)
  > fixed right = solids.Cube(1) absorb at translate (n + 1, 0, 0)
  > motion walker = choose { (1, 0, 0) weight p, (-1, 0, 0) weight 1 - p }
  > check ruin   : P = ? [ eventually event absorb(walker, left) ]
  > check never  : E = ? [ time U event absorb(walker, left) ]
  > check likely : P >= 1/2 [ eventually event absorb(walker, left) ]
  > END
  $ scc sweep walk.sc -D p=1/3,0.4,2/3 -D n=2 | cut -d, -f 1-7
  point,p,n,check,verdict,least from,least to
  0,1/3,2,ruin,measured,4/5,4/5
  0,1/3,2,never,measured,infinite,infinite
  0,1/3,2,likely,holds,,
  1,2/5,2,ruin,measured,9/13,9/13
  1,2/5,2,never,measured,infinite,infinite
  1,2/5,2,likely,holds,,
  2,2/3,2,ruin,measured,1/5,1/5
  2,2/3,2,never,measured,infinite,infinite
  2,2/3,2,likely,violated,,

The same as by single checks, and the same bytes however many processes work at it.

  $ scc check walk.sc -D p=0.4 -D n=2 | grep '^ruin'
  ruin: 9/13
  $ sweep() { scc sweep walk.sc -D p=1/4:3/4:1/8 -D n=1..4 --format jsonl "$@"; }
  $ sweep > one.jsonl
  $ for j in 2 5; do sweep --jobs $j | cmp - one.jsonl; done
  $ wc -l < one.jsonl
  21
  $ sed -n 2p one.jsonl
  {"point":0,"parameters":{"p":"1/4","n":"1/1"},"refused":null,"checks":[{"name":"ruin","verdict":"measured","values":[{"over":"least","low":"9/13","high":"9/13"},{"over":"greatest","low":"9/13","high":"9/13"}],"reasons":[]},{"name":"never","verdict":"measured","values":[{"over":"least","low":"infinite","high":"infinite"},{"over":"greatest","low":"infinite","high":"infinite"}],"reasons":[]},{"name":"likely","verdict":"holds","values":[],"reasons":[]}]}

Some of the checks alone; and numbers that are rounded outwards, as the names of their columns say.

  $ scc sweep walk.sc -D p=1/3,2/3 -D n=2 --check ruin --check likely | cut -d, -f 1-7
  point,p,n,check,verdict,least from,least to
  0,1/3,2,ruin,measured,4/5,4/5
  0,1/3,2,likely,holds,,
  1,2/3,2,ruin,measured,1/5,1/5
  1,2/3,2,likely,violated,,
  $ scc sweep walk.sc -D p=2/5 -D n=2,3 --decimals 4
  point,p,n,check,verdict,least from (rounded down to 4 decimals),least to (rounded up to 4 decimals),greatest from (rounded down to 4 decimals),greatest to (rounded up to 4 decimals),why
  0,2/5,2,ruin,measured,0.6923,0.6924,0.6923,0.6924,
  0,2/5,2,never,measured,infinite,infinite,infinite,infinite,
  0,2/5,2,likely,holds,,,,,
  1,2/5,3,ruin,measured,0.8104,0.8105,0.8104,0.8105,
  1,2/5,3,never,measured,infinite,infinite,infinite,infinite,
  1,2/5,3,likely,holds,,,,,
  $ scc sweep walk.sc -D p=2/5 -D n=2 --check ruin --format jsonl | head -1 | grep -o '"checks":.*'
  "checks":["ruin"],"grid":[{"name":"p","values":["2/5"]},{"name":"n","values":["2/1"]}]}
  $ scc sweep walk.sc -D p=2/5 -D n=2 --check ruins --check likely
  command line: error[SC0201]: the model has no check `ruins`
    hint: did you mean `ruin`?
  [64]
  $ scc sweep walk.sc -D p=2/5 --decimals 4 --format jsonl 2>&1 | head -1
  scc: --decimals is for csv: the numbers of jsonl are exact
  $ scc sweep walk.sc -D p=1/4:3/4:1/8 -D n=1..4 --check ruin --format jsonl --resume one.jsonl 2>&1 | cut -c 1-60
  one.jsonl: error[SC0804]: this file is not of the same sweep
  $ scc sweep walk.sc
  scc: required option --define is missing
  Usage: scc sweep [OPTION]… MODEL
  Try 'scc sweep --help' or 'scc --help' for more information.
  [64]
  $ for m in '--check ruin' '--check never' '--check ruin'; do
  >   scc sweep walk.sc -D p=1/4:3/4:1/8 -D n=1..4 --store kept $m > /dev/null; echo $?
  > done
  0
  kept: error[SC0911]: it keeps something else: --check is ruin there, and never here
  3
  0

An interrupted one goes on where it ended.

  $ head -c 3000 one.jsonl > part.jsonl
  $ sweep --jobs 2 --resume part.jsonl
  $ cmp part.jsonl one.jsonl
  $ scc sweep walk.sc -D p=1/4:3/4:1/8 -D n=1..5 --format jsonl --resume part.jsonl 2>&1 | cut -c 1-60
  part.jsonl: error[SC0804]: this file is not of the same swee

Parts, one after the other, are the whole.

  $ for k in 1 2 3; do sweep --jobs 2 --part $k/3 | if [ $k = 1 ]; then cat; else tail -n +2; fi; done | cmp - one.jsonl
  $ sweep --part 1/1000000 | wc -l
  1
  $ sweep --part 3/2 2>&1 | head -1
  scc: option '--part': `3/2' is no part: the third of eight is 3/8
  $ sweep --part 1/2 --resume part.jsonl 2>&1 | head -1
  scc: --resume does not go with --part
  $ sweep --part 1/2 --plot part.svg 2>&1 | head -1
  scc: --plot does not go with --part

Of bodies that diffuse the table has the kick. A chosen one that changes is a warning; a given one does not change.

  $ cat > drift.sc <<'END'
  > model drift
  > timestep 1 steady
  > import <solids>
  > param d = 1/2
  > process p = solids.Cube(1) mass 1 [nil]
  > fixed w = solids.Cube(1) absorb at translate (4, 0, 0)
  > motion p = diffuse((d, 0, 0))
  > check near : P = ? [ eventually gone(p) within 3 ]
  > END
  $ scc sweep drift.sc -D d=1/2,1/4,1 | cut -d, -f 1-6
  drift.sc:7:1: warning[SC0604]: the lattice changes over the sweep: the kick is 2 at point 2, and was 1 at the first point
     |
   7 | motion p = diffuse((d, 0, 0))
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    hint: what bodies reach depends on the lattice, too, and not on the constant alone: fix the kick, as in `diffuse(d, h = 2)`, to compare points
  scc: the kicks chosen for diffuse are from 1 to 2: h = 2 is long enough at all points
  point,d,kick,check,verdict,least from
  0,1/2,1,near,measured,1/8
  1,1/4,1,near,measured,1/64
  2,1,2,near,measured,1/8
  $ scc sweep drift.sc -D d=1/2,1 --format jsonl 2>/dev/null | tail -1 | cut -d '[' -f 1-3
  {"point":1,"parameters":{"d":"1/1"},"refused":null,"lattices":[{"bodies":["p"],"kick":"2/1","chosen":true}],"checks":
  $ scc simulate drift.sc --runs 1 --observe 'x(p)' --every 1 --until 1
  run,time,x(p),ended
  0,0,0,
  0,1,1,
  $ scc simulate drift.sc --runs 1 --observe 'x(p)' --every 1 --until 1 --progress
  scc: kick 1, kick chosen as the least power of two whose square is no less than 1
  progress: 1 of 1 runs
  run,time,x(p),ended
  0,0,0,
  0,1,1,
  $ scc estimate drift.sc --runs 100 2>&1 | head -1
  kick 1, kick chosen as the least power of two whose square is no less than 1
  $ sed -i 's/0))/0), h = 2)/' drift.sc
  $ scc sweep drift.sc -D d=1/2,1/4,1 | cut -d, -f 1-6
  point,d,kick,check,verdict,least from
  0,1/2,2,near,measured,5/128
  1,1/4,2,near,measured,11/1024
  2,1,2,near,measured,1/8
  $ scc check drift.sc | head -1
  semantics 3: timestep 1 steady, kick 2

Pictures: curves over one parameter, cells of colours over two.

  $ scc sweep walk.sc -D p=0:1:1/4 --plot curves.svg -o curves.csv
  $ grep '<text' curves.svg | sed 's/.*">//; s/<.*//' | head -3
  walk
  5 points
  ruin
  $ grep -c '<circle' curves.svg
  6
  $ scc sweep walk.sc -D p=0:1:1/4 -D n=1..3 --plot cells.svg -o cells.csv

The parameter that is named first is across, the other one upwards: the lowest row of cells has the least n.

  $ grep -o 'upwards [a-z]*' cells.svg
  upwards n
  $ grep -o '<title>[^<]*' cells.svg | head -5
  <title>walk
  <title>1
  <title>9/13
  <title>1/3
  <title>1/13
  $ grep -c '<title' cells.svg
  46
  $ scc sweep walk.sc -D p=1/2 --plot none.svg 2>&1 | head -1
  scc: --plot: a chart is drawn over one or two parameters that have several values, and none has

Bounds are those of each point.

  $ scc sweep $M/gas.sc -D n=1..2 --states 20 | cut -d, -f 1-4,9
  point,n,check,verdict,why
  0,1,energy,holds,
  0,1,drift,holds,
  1,2,energy,holds-up-to-bound,the exploration ended at the bound of 20 states
  1,2,drift,holds-up-to-bound,the exploration ended at the bound of 20 states

What cannot be asked.

  $ scc sweep walk.sc 2>&1 | head -1
  scc: required option --define is missing
  $ scc sweep walk.sc -D p=1..1000000000 2>&1 | head -1
  scc: option '-D': `1..1000000000' has 1000000000 values: at most 1000000
  $ scc sweep walk.sc -D p=1..1000000 -D n=1..1000 2>&1 | head -1
  scc: the grid has 1000000000 points: at most 1000000
  $ scc sweep walk.sc -D p=1 -D p=2 2>&1 | head -1
  scc: -D p is there twice
  $ scc sweep walk.sc -D p=2:1:1 2>&1 | head -1
  scc: option '-D': `2:1:1' ends before it begins
  $ scc sweep walk.sc -D q=1
  command line: error[SC0209]: the model has no parameter `q`
    hint: did you mean `p`?
  [64]
  $ scc sweep walk.sc -D p=2,3 --format jsonl | tail -n +2
  scc: the model is invalid at 2 of 2 points
  {"point":0,"parameters":{"p":"2/1"},"refused":{"code":"SC0601","message":"a weight of -1, which is negative"},"checks":[]}
  {"point":1,"parameters":{"p":"3/1"},"refused":{"code":"SC0601","message":"a weight of -2, which is negative"},"checks":[]}
  $ scc sweep walk.sc -D p=0.5 --format csv --resume part.jsonl 2>&1 | head -1
  scc: --resume goes on with JSON Lines: --format jsonl
  $ scc sweep nothing.sc -D p=1
  nothing.sc: error[SC0101]: cannot read: No such file or directory
  [3]
  $ scc sweep walk.sc -D p=1/2 -o /dev/full
  /dev/full: error[SC0103]: cannot write: No space left on device
  [74]
