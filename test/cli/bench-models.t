The models that test/bench/check-compare measures have the states that it says they have. A chain of n bonds: 2^n, with
n 2^(n-1) + 2^n - 1 transitions.

  $ models=../bench/checker
  $ explored () { scc check $models/$1.sc -D n=$2 | grep -e explored -e '(exhaustive)'; }
  $ explored bonds 1
  $ explored bonds 5

A lattice, whose property is about one of n dimers:

  $ explored lattice 1

Substrates that fly about in a closed box are finitely many states, and more with every one:

  $ explored hexokinase 2
  $ explored hexokinase 3
