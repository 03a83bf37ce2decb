Several processes say what one says, byte for byte; also where the system gives them less than they would take: few
addresses, few descriptors, no standard error.

  $ M=../../specs/models
  $ crowd() { scc check $M/gas.sc -D n=3 --states 20000 "$@"; }
  $ crowd --jobs 1 > one.txt
  $ for n in 2 4 16; do crowd --jobs $n | cmp - one.txt; done
  $ (ulimit -v 2000000; crowd --jobs 2) | cmp - one.txt
  $ (ulimit -n 12; crowd --jobs 4) | cmp - one.txt
  $ crowd --jobs 2 2>&- | cmp - one.txt
  $ crowd --jobs 2 --store kept | cmp - one.txt
  $ crowd --jobs 2 --store kept | cmp - one.txt
  $ grep '^explored' one.txt
  explored: 19999 states, 107274 transitions, depth 59, model time 4; not complete: stopped by the bound of 20000 states
