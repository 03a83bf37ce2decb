What is done is kept in a folder, and gone on with from there.

  $ M=../../specs/models

Runs of estimate: as many as there were are not made again, and more may be asked for.

  $ scc estimate $M/ruin.sc --runs 20 > alone
  $ scc estimate $M/ruin.sc --runs 20 --store runs > kept
  $ scc estimate $M/ruin.sc --runs 20 --store runs --jobs 2 > again
  $ cmp alone kept && cmp alone again
  $ scc estimate $M/ruin.sc --runs 30 > alone; scc estimate $M/ruin.sc --runs 30 --store runs | cmp - alone
  $ scc estimate $M/ruin.sc --runs 20 --store runs --seed 1
  $ scc check $M/ruin.sc --store runs

Runs of simulate, told in several ways.

  $ asked="--runs 20 --observe x(walker) --every 1 --until 4"
  $ scc simulate $M/ruin.sc $asked > alone; scc simulate $M/ruin.sc $asked --store walks | cmp - alone
  $ scc simulate $M/ruin.sc $asked --summary > alone; scc simulate $M/ruin.sc $asked --summary --store walks | cmp - alone
  $ scc simulate $M/ruin.sc $asked --store walks --format jsonl --resume alone 2>&1 | head -1

Points of sweep.

  $ scc sweep $M/chain.sc -D n=1..3 > alone; scc sweep $M/chain.sc -D n=1..3 --store points | cmp - alone
  $ scc sweep $M/chain.sc -D n=1..3 --store points --jobs 2 | cmp - alone
  $ scc sweep $M/chain.sc -D n=1..4 --store points

Searches with hash compaction.

  $ scc check $M/enzyme.sc --hash-compact > alone
  [1]
  $ scc check $M/enzyme.sc --hash-compact --store prints | cmp - alone
  $ scc check $M/enzyme.sc --hash-compact --store prints | cmp - alone
  $ scc check $M/enzyme.sc --store prints

Files that cannot grow: it is told at once, and the work goes on.

  $ (trap '' XFSZ; ulimit -f 60; scc check ../bench/checker/hexokinase.sc -D n=3 --store full 2>&1 >report)
  $ scc check ../bench/checker/hexokinase.sc -D n=3 | cmp - report
  $ scc check ../bench/checker/hexokinase.sc -D n=3 --store full | cmp - report
