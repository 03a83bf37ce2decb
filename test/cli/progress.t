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
