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
  progress: reading the model
  scc: kick 1, kick chosen as the least power of two whose square is no less than 1
  progress: 0 of 1 runs
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

Estimates at each point: those of `scc estimate` there, for any number of processes.

  $ cat > ruin.sc <<EOF
  > timestep 1
  > param n = 3
  > import <solids>
  > process w = solids.Cube(1) mass 1 [nil]
  > fixed low = solids.Cube(1) absorb at translate (-3, 0, 0)
  > fixed high = solids.Cube(1) absorb at translate (n + 1, 0, 0)
  > motion w = choose { (1, 0, 0) weight 2, (-1, 0, 0) weight 3 }
  > check rich : P = ? [ eventually event absorb(w, high) ]
  > check soon : P >= 1/2 [ eventually gone(w) within 4 ]
  > check long : E = ? [ time U gone(w) ]
  > check place : E = ? [ x(w) at 3/2 ]
  > check met : possibly gone(w)
  > EOF
  $ estimates() { scc sweep ruin.sc -D n=1..3 --estimate --runs 50 "$@"; }
  $ estimates --check rich --check soon --check long
  point,n,check,verdict,estimate,from,to,runs,why
  0,1,rich,estimated,13/25,333699/1000000,702409/1000000,50,
  0,1,soon,estimated_holds,23/25,768949/1000000,123279/125000,50,
  0,1,long,estimated,11/5,800893949/500000000,,50,"no greatest value of this number is known, and so no upper end: a value too rare to be among the runs may raise the mean by any amount"
  1,2,rich,estimated,8/25,5137/31250,255387/500000,50,
  1,2,soon,estimated_holds,19/25,574507/1000000,17889/20000,50,
  1,2,long,estimated,96/25,1360025539/500000000,,50,"no greatest value of this number is known, and so no upper end: a value too rare to be among the runs may raise the mean by any amount"
  2,3,rich,estimated,6/25,2111/20000,425493/1000000,50,
  2,3,soon,undecided,31/50,53593/125000,787869/1000000,50,more runs would tell more
  2,3,long,estimated,24/5,3274693657/1000000000,,50,"no greatest value of this number is known, and so no upper end: a value too rare to be among the runs may raise the mean by any amount"
  [2]
  $ estimates > one
  scc: left out: met: no probability or mean is asked for: `scc check` decides it
  [2]
  $ estimates --jobs 2 | diff one -
  scc: left out: met: no probability or mean is asked for: `scc check` decides it
  $ estimates --store kept-runs > two; estimates --store kept-runs | diff two -; diff one two
  scc: left out: met: no probability or mean is asked for: `scc check` decides it
  scc: left out: met: no probability or mean is asked for: `scc check` decides it
  $ scc sweep ruin.sc -D n=1,2,3 --store kept-runs
  kept-runs: error[SC0911]: it keeps something else: --estimate is given there, and not here
  [3]
  $ estimates --check rich --decimals 6 --seed 7 | tail -n +2 | tr -d '\r' | sed 's/^[0-9]*,[^,]*,rich,estimated,\([^,]*\),\([^,]*\),\([^,]*\),\([0-9]*\),/\1, from \2 to \3, \4 runs/' > rows
  $ for n in 1 2 3; do scc estimate ruin.sc -D n=$n --runs 50 --check rich --seed 7; done | sed 's/rich: estimated: //; s/ with confidence .*, / , /; s/ ,/,/' | diff rows -
  $ estimates --format jsonl --check soon | head -2
  {"format":"scc-sweep","version":1,"semantics":"3","model":null,"digest":"md5:ed2803775cdd06ee1ece532576ded741","bounds":{},"checks":["soon"],"estimated":{"runs":"50","confidence":"99/100","seed":"0","free":"apart"},"grid":[{"name":"n","values":["1/1","2/1","3/1"]}]}
  {"point":0,"parameters":{"n":"1/1"},"refused":null,"checks":[{"name":"soon","verdict":"estimated_holds","values":[],"estimate":{"value":"23/25","low":"768949/1000000","high":"123279/125000","infinite":false,"runs":50},"reasons":[]}]}
  $ scc sweep ruin.sc -D n=2 --estimate --width 1/4 --decimals 3 --check rich
  point,n,check,verdict,estimate (rounded to 3 decimals),from (rounded down to 3 decimals),to (rounded up to 3 decimals),runs,why
  0,2,rich,estimated,0.352,0.237,0.479,128,
  $ scc sweep ruin.sc -D n=2 --estimate --runs 200 --normal --decimals 3 --check long
  point,n,check,verdict,estimate (rounded to 3 decimals),from (rounded down to 3 decimals),to (rounded up to 3 decimals),runs,why
  0,2,long,estimated,3.73,3.236,4.224,200,the interval is approximate: right if the mean of the runs is normal
  $ scc sweep ruin.sc -D n=2 --estimate --runs 200 --normal --format jsonl --check long | grep -o '"infinite".*'
  "infinite":false,"approximate":true,"runs":200},"reasons":[]}]}
  $ scc sweep ruin.sc -D n=1,2 --estimate --check met
  ruin.sc:12:7: error[SC0205]: `met` cannot be estimated: no probability or mean is asked for: `scc check` decides it
      |
   12 | check met : possibly gone(w)
      |       ^^^
  [3]
  $ scc sweep ruin.sc -D n=2 --runs 5 2>&1 | head -1
  scc: --runs is about estimates: it needs --estimate
  $ scc sweep ruin.sc -D n=2 --estimate --depth 3 2>&1 | head -1
  scc: --depth does not go with --estimate
  $ scc sweep ruin.sc -D n=2 --estimate --plot p.svg 2>&1 | head -1
  scc: --plot does not go with --estimate
  $ scc sweep ruin.sc -D n=2 --estimate --runs 5 --most 5 2>&1 | head -1
  scc: --runs cannot be combined with --most or --width: it makes so many runs, whatever they tell

A column of a parameter with the name of another column is in round brackets.

  $ cat > named.sc <<'END'
  > param why = 1
  > param kick = 1
  > param point = 1
  > param runs = 1
  > import <solids>
  > process w = solids.Cube(1) mass why [nil]
  > check stays : always x(w) = 0
  > END
  $ scc sweep named.sc -D why=1,2 -D kick=3 -D point=4 -D runs=5
  named.sc:2:7: warning[SC0211]: the parameter `kick` is not used
     |
   2 | param kick = 1
     |       ^^^^
  named.sc:3:7: warning[SC0211]: the parameter `point` is not used
     |
   3 | param point = 1
     |       ^^^^^
  named.sc:4:7: warning[SC0211]: the parameter `runs` is not used
     |
   4 | param runs = 1
     |       ^^^^
  point,(why),kick,(point),runs,check,verdict,least from,least to,greatest from,greatest to,why
  0,1,3,4,5,stays,holds,,,,,
  1,2,3,4,5,stays,holds,,,,,

A number of more digits than a literal has room for is refused by the name of the limit.

  $ scc sweep named.sc -D why=1e4000 2>&1 | head -2
  scc: option '-D': a number is too large: at most 4000 digits each above and
       below the line
  $ scc sweep named.sc -D why=1,2/1e5000 2>&1 | head -2
  scc: option '-D': a number is too large: at most 4000 digits each above and
       below the line
  $ scc sweep named.sc -D why=1/0 2>&1 | head -1
  scc: option '-D': `1/0' is no number
