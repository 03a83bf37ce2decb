What is done is kept in a folder, and gone on with from there.

  $ M=../../specs/models

Runs of estimate: as many as there were are not made again, and more may be asked for.

  $ scc estimate $M/ruin.sc --runs 20 > alone
  [2]
  $ scc estimate $M/ruin.sc --runs 20 --store runs > kept
  [2]
  $ scc estimate $M/ruin.sc --runs 20 --store runs --jobs 2 > again
  [2]
  $ cmp alone kept && cmp alone again
  $ scc estimate $M/ruin.sc --runs 30 > alone; scc estimate $M/ruin.sc --runs 30 --store runs | cmp - alone
  $ scc estimate $M/ruin.sc --runs 20 --store runs --seed 1
  runs: error[SC0911]: it keeps something else: --seed is 0 there, and 1 here
  [3]
  $ scc check $M/ruin.sc --store runs
  runs: error[SC0911]: it keeps something else: what is kept is runs of scc estimate there, and explorations of scc check here
  [3]

Runs of simulate, told in several ways.

  $ asked="--runs 20 --observe x(walker) --every 1 --until 4"
  $ scc simulate $M/ruin.sc $asked > alone; scc simulate $M/ruin.sc $asked --store walks | cmp - alone
  $ scc simulate $M/ruin.sc $asked --summary > alone; scc simulate $M/ruin.sc $asked --summary --store walks | cmp - alone
  $ scc simulate $M/ruin.sc $asked --store walks --format jsonl --resume alone 2>&1 | head -1
  scc: --resume does not go with --store

Points of sweep.

  $ scc sweep $M/chain.sc -D n=1..3 > alone; scc sweep $M/chain.sc -D n=1..3 --store points | cmp - alone
  $ scc sweep $M/chain.sc -D n=1..3 --store points --jobs 2 | cmp - alone
  $ scc sweep $M/chain.sc -D n=1..4 --store points
  points: error[SC0911]: it keeps something else: -D n is 1,2,3 there, and 1,2,3,4 here
  [3]

Searches with hash compaction.

  $ scc check $M/enzyme.sc --hash-compact > alone
  [1]
  $ scc check $M/enzyme.sc --hash-compact --store prints | cmp - alone
  $ scc check $M/enzyme.sc --hash-compact --store prints | cmp - alone
  $ scc check $M/enzyme.sc --store prints
  prints: error[SC0911]: it keeps something else: --hash-compact is given there, and not given here
  [3]

Files that cannot grow: it is told at once, and the work goes on.

  $ (trap '' XFSZ; ulimit -f 400; scc check ../bench/checker/hexokinase.sc -D n=4 --store full 2>&1 >report)
  full: warning[SC0103]: the store cannot be used: disk I/O error: what is found from now on is not kept
    hint: it goes on all the same; what was kept up to now stays
  full: error[SC0103]: the store cannot be used: disk I/O error; what was found from then on is not kept
    hint: the same command goes on from what was kept, once the store can be written again
  [74]
  $ scc check ../bench/checker/hexokinase.sc -D n=4 | cmp - report
  $ scc check ../bench/checker/hexokinase.sc -D n=4 --store full | cmp - report

The same from the beginning, with whatever is kept; the folder goes on to be a store.

  $ none() { (trap '' XFSZ; ulimit -f 0; scc "$@" --store none 2>&1 1>/dev/null; echo $?) | cat | grep -v SC0703; }
  $ none check $M/ruin.sc
  none: warning[SC0103]: the store cannot be used: disk I/O error: what is found from now on is not kept
    hint: it goes on all the same; what was kept up to now stays
  none: error[SC0103]: the store cannot be used: disk I/O error; what was found from then on is not kept
    hint: the same command goes on from what was kept, once the store can be written again
  74
  $ none check $M/enzyme.sc --hash-compact
  none: warning[SC0103]: the store cannot be used: disk I/O error: what is found from now on is not kept
    hint: it goes on all the same; what was kept up to now stays
  none: error[SC0103]: the store cannot be used: disk I/O error; what was found from then on is not kept
    hint: the same command goes on from what was kept, once the store can be written again
  74
  $ none estimate $M/ruin.sc --runs 20
  none: warning[SC0103]: the store cannot be used: disk I/O error: what is found from now on is not kept
    hint: it goes on all the same; what was kept up to now stays
  none: error[SC0103]: the store cannot be used: disk I/O error; what was found from then on is not kept
    hint: the same command goes on from what was kept, once the store can be written again
  74
  $ none simulate $M/ruin.sc $asked
  none: warning[SC0103]: the store cannot be used: disk I/O error: what is found from now on is not kept
    hint: it goes on all the same; what was kept up to now stays
  none: error[SC0103]: the store cannot be used: disk I/O error; what was found from then on is not kept
    hint: the same command goes on from what was kept, once the store can be written again
  74
  $ none sweep $M/chain.sc -D n=1..2
  none: warning[SC0103]: the store cannot be used: disk I/O error: what is found from now on is not kept
    hint: it goes on all the same; what was kept up to now stays
  none: error[SC0103]: the store cannot be used: disk I/O error; what was found from then on is not kept
    hint: the same command goes on from what was kept, once the store can be written again
  74
  $ scc check $M/ruin.sc > alone; scc check $M/ruin.sc --store none | cmp - alone

Too few descriptors are a limit of the system.

  $ (ulimit -n 6; scc check $M/ruin.sc --store few)
  scc: Too many open files (open the files of the store)
  [4]

A value that is empty on one side.

  $ scc check $M/ruin.sc --store plain > /dev/null; scc check $M/ruin.sc --store plain --no-reduce order
  plain: error[SC0911]: it keeps something else: --no-reduce is empty there, and order here
  [3]
