A loop over an empty range declares a family without members.

  $ cat > none.sc <<'MODEL'
  > model none
  > import <solids>
  > param n = 0
  > process p = solids.Cube(1) mass 1 [nil]
  > for k in 1..n { process inh[k] = solids.Cube(1) mass 1 at translate (3*k, 0, 0) [nil] }
  > for k in 1..n { check stays: always x(inh[k]) = 3*k }
  > motion inh = (0, 0, 0)
  > network p || inh
  > check few : always count(q in inh: x(q) > 10) = 0
  > check any : possibly exists q in inh: x(q) = 3
  > check all : always forall q in inh: x(q) < 0
  > check near : P = ? [ eventually exists q in inh: touching(p, q) ]
  > MODEL
  $ scc check none.sc --check few --check any --check all 2>/dev/null | grep -E '^(few|any|all):'
  few: holds (exhaustive)
  any: violated
  all: holds (exhaustive)
  $ scc check none.sc --check few --check any --check all -D n=1 2>/dev/null | grep -E '^(few|any|all):'
  few: holds (exhaustive)
  any: holds (exhaustive)
  all: violated
  $ scc sweep none.sc -D n=0..2 2>/dev/null | grep -E 'point|few|any' | cut -d, -f2-4
  n,check,verdict
  0,few,holds
  0,any,violated
  1,few,holds
  1,any,holds
  2,few,holds
  2,any,holds

The checks of a family may be none, too.

  $ scc check none.sc --check stays 2>/dev/null
  semantics 3
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  no properties to check
  $ scc check none.sc --check stays -D n=2 2>/dev/null | grep -E '^stays'
  stays[1]: holds (exhaustive)
  stays[2]: holds (exhaustive)
  $ scc estimate none.sc --check stays
  command line: error[SC0210]: the checks that are named have no members here
    hint: the loops that declare them are empty
  [64]
  $ scc check none.sc --check stay
  command line: error[SC0201]: the model has no check `stay`
  [64]

Numbers are read of one, and pictures leave out none.

  $ scc simulate none.sc --runs 1 --every 1 --until 1 --observe 'count(q in inh: x(q) > 0)'
  run,time,count(q in inh: x(q) > 0),ended
  0,0,0,
  0,1,0,
  $ scc view none.sc --svg 0 --without inh
  scc: wrote none.svg
  $ scc view none.sc --svg 0 --without ihn
  command line: error[SC0201]: no body, part or family of bodies is called `ihn`
    hint: parts of compounds are named with their body, as in --without room.south
  [64]

Where one body is expected, the family is none, and a name that no loop declares is unknown.

  $ refused() { (cat none.sc; echo "$1") > bad.sc; scc check bad.sc 2>&1 | grep -E 'error|hint'; }
  $ refused 'check one : always x(inh) = 0'
  bad.sc:13:22: error[SC0210]: `inh` is a family that has no members here, and one body is expected
  $ refused 'bond <a, {p.left, inh.right}>'
  bad.sc:13:19: error[SC0210]: `inh` is a family that has no members here; a bond joins two bodies
  $ refused 'check first : always x(inh[1]) = 0'
  bad.sc:13:24: error[SC0201]: unknown process `inh[1]`
    hint: `inh` is a family that has no members here
  $ refused 'motion hin = inertial'
  bad.sc:13:8: error[SC0201]: unknown process `hin`
  $ refused 'check some : always count(q in stays: x(q) > 0) = 0'
  bad.sc:13:32: error[SC0201]: unknown template `stays`
  $ refused 'process inh = solids.Cube(1) mass 1 at translate (0, 9, 0) [nil]'
  bad.sc:13:9: error[SC0202]: the name `inh` is taken by another process
