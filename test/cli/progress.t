Progress as lines on standard error, where it is no terminal and with --json.

  $ cat > walk.sc <<'M'
  > import <solids>
  > process p = solids.Cube(1) mass 1 [nil]
  > motion p = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight 1 }
  > check never : always x(p) < 100000000
  > M
  $ scc check walk.sc --states 100000 --jobs 1 --progress --json 2>lines >report.json; sort -u lines | grep -c '^progress: [0-9]* states' | sed 's/^[1-9][0-9]*$/some/'
  some
  $ grep -vc '^progress: ' lines
  0
  [1]
  $ head -1 lines
  progress: reading the model
  $ scc simulate walk.sc --observe time --every 1 --until 2 --runs 1 --progress 2>&1 >/dev/null | head -1
  progress: reading the model
  $ scc check walk.sc --states 100000 --jobs 1 --json 2>lines >report.json; wc -c < lines
  0

Over ranges the lines have the time, too, and go on while values are computed:

  $ cat > ranges.sc <<'M'
  > timestep 1
  > param s in [0, 3]
  > import <solids>
  > process w = solids.Cube(1) mass 1 at translate (s, 0, 0) [nil]
  > fixed a = solids.Cube(1) at translate (-2, 0, 0)
  > fixed b = solids.Cube(1) at translate (5, 0, 0)
  > motion w = choose { (1, 0, 0) weight 2, (-1, 0, 0) weight 3 }
  > check back : P = ? [ eventually x(w) <= -1 within 4000 ]
  > check mean : E = ? [ x(w) at 100 ]
  > M
  $ scc check ranges.sc --where --progress --json 2>lines >report.json
  [2]
  $ grep -c -E '^progress: [0-9]+ states \([0-9]+/s\), [0-9]+ to expand, depth [0-9]+, model time [0-9/.e]+, [0-9]+ MiB, after [0-9.]+ [a-z]+' lines | sed 's/^[1-9][0-9]*$/some/'
  some
  $ grep -v '^progress: [0-9]* states' lines | sed 's/[0-9]\+/N/g' | sort -u
  progress: beginning to explore
  progress: reading the model
  progress: values of N of N sets of states, N MiB, after N s
