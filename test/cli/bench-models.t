The models that test/bench/check-compare measures have the states that it says they have. A chain of n bonds: 2^n, with
n 2^(n-1) + 2^n - 1 transitions.

  $ models=../bench/checker
  $ explored () { scc check $models/$1.sc -D n=$2 | grep -e explored -e '(exhaustive)'; }
  $ explored bonds 1
  conserved: holds (exhaustive), at split step 1
  explored: 2 states, 2 transitions, depth 1, model time 0; complete
  $ explored bonds 5
  conserved: holds (exhaustive), at split step 1
  explored: 32 states, 111 transitions, depth 5, model time 0; complete

A lattice, whose property is about one of n dimers:

  $ explored lattice 1
  near: holds (exhaustive), at split step 1
  explored: 2 states, 2 transitions, depth 1, model time 0; complete

Substrates that fly about in a closed box are finitely many states, and more with every one:

  $ explored hexokinase 2
  together: holds (exhaustive), at split step 1
  explored: 11 states, 16 transitions, depth 5, model time 2; complete
  $ explored hexokinase 3
  together: holds (exhaustive), at split step 1
  explored: 309 states, 449 transitions, depth 84, model time 97; complete
