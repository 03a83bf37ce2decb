The graph of a model, for other tools. The extension tells the format.

  $ scc explore ../../specs/models/figure7.sc -o figure7.aut
  scc: semantics 3
  scc: explored: 4 states, 3 transitions; complete
  $ cat figure7.aut
  des (0, 6, 5)
  (0, "time(2)", 1)
  (1, "bind(a, P0.s0.[v2,v3], s2.f4)", 2)
  (1, "bind(a, P0.s1.[v2,v3], s2.f4)", 3)
  (2, "time(forever)", 4)
  (3, "time(forever)", 4)
  (4, "time(forever)", 4)
  $ scc explore ../../specs/models/figure7.sc -o - --format aut --cadp --hide time --hide 'bind(a, P0.s1*'
  des (0, 6, 5)
  (0, i, 1)
  (1, i, 3)
  (1, "bind(a, P0.s0.[v2,v3], s2.f4)", 2)
  (2, i, 4)
  (3, i, 4)
  (4, i, 4)
  scc: semantics 3
  scc: explored: 4 states, 3 transitions; complete
  $ scc explore ../../specs/models/dimer.sc -o dimer.aut && head -4 dimer.aut
  scc: semantics 3: split step 1/2
  scc: explored: 11 states, 14 transitions; complete
  des (0, 14, 10)
  (0, "time(2)", 1)
  (1, "time(1/2)", 2)
  (1, "weak(bond, w1.right, w2.left)", 3)
  $ scc explore ../../specs/models/dimer.sc -o dimer-steps.aut --all-steps && head -4 dimer-steps.aut
  scc: semantics 3: split step 1/2
  scc: explored: 11 states, 14 transitions; complete
  des (0, 15, 11)
  (0, "time(1)", 1)
  (1, "time(1/2)", 2)
  (2, "time(1/2)", 3)
  $ scc compare dimer.aut dimer-steps.aut --modulo timed
  equivalent modulo timed
  dimer.aut: 10 states, 14 transitions, 9 classes; complete
  dimer-steps.aut: 11 states, 15 transitions, 9 classes; complete
  $ scc compare dimer-steps.aut ../../specs/models/dimer.sc --modulo strong
  equivalent modulo strong
  dimer-steps.aut: 11 states, 15 transitions, 8 classes; complete
  ../../specs/models/dimer.sc: 11 states, 14 transitions, 8 classes; complete, at split step 1/2
    semantics 3: split step 1/2

Without instants, labels tell of the states alone; with them, of the whole run.

  $ scc explore ../../specs/models/graze.sc -o graze.drn
  scc: semantics 3
  scc: explored: 1 states, 0 transitions; complete
  scc: labels that change while time passes, and tell of the states alone: touching_p_q, x_q_eq_2, y_q_eq_2, check_meets, check_where, check_apart, check_soon
  $ scc explore ../../specs/models/graze.sc -o graze.drn --instants
  scc: semantics 3
  scc: explored: 1 states, 0 transitions; complete
  $ cat graze.drn
  // model graze
  // semantics 3
  // explored: 1 states, 0 transitions; complete
  // label touching_p_q: touching(p, q)
  // label x_q_eq_2: x(q) = 2
  // label y_q_eq_2: y(q) = 2
  // label bonds_a_eq_0: bonds(a) = 0
  // label vx_q_eq_1: vx(q) = 1
  // label check_meets: touching(p, q)
  // label check_where: (touching(p, q) and x(q) = 2) and y(q) = 2
  // label check_only: not touching(p, q) or x(q) = 2
  // label check_apart: not touching(p, q)
  // label check_free: bonds(a) = 0 and vx(q) = 1
  // label check_soon: touching(p, q)
  // action time_2: time(2)
  // action time_0: time(0)
  // check meets: !(P<1 [F ("touching_p_q")])
  // check where: !(P<1 [F ("check_where")])
  // check only: P>=1 [G ("check_only")]
  // check apart: P>=1 [G ("check_apart")]
  // check free: P>=1 [G ("check_free")]
  // check soon: is not asked for by labels alone: it has a bound of time
  @type: MDP
  @value_type: rational
  @parameters
  
  @reward_models
  time
  @nr_states
  3
  @nr_choices
  3
  @model
  state 0 [0] init quiescent bonds_a_eq_0 vx_q_eq_1 check_only check_apart check_free
  	action time_2 [2]
  		1 : 1
  state 1 [0] quiescent touching_p_q x_q_eq_2 y_q_eq_2 bonds_a_eq_0 vx_q_eq_1 check_meets check_where check_only check_free check_soon
  	action time_0 [0]
  		2 : 1
  state 2 [0] quiescent right_after bonds_a_eq_0 vx_q_eq_1 check_only check_apart check_free
  	action rest [0]
  		2 : 1

Explicit files, in two dialects.

  $ scc explore ../../specs/models/dimer.sc -o dimer.tra
  scc: semantics 3: split step 1/2
  scc: explored: 11 states, 14 transitions; complete
  $ ls dimer.*
  dimer.aut
  dimer.lab
  dimer.names.json
  dimer.sta
  dimer.tra
  $ head -4 dimer.tra dimer.sta
  ==> dimer.tra <==
  11 15 15
  0 0 1 1 time_1
  1 0 2 1 time_1_over_2
  2 0 3 1 time_1_over_2
  
  ==> dimer.sta <==
  (state,behaviour_w1,process_w2,behaviour_w2,behaviour_s1,process_s2,behaviour_s2,bonds_bond)
  0:(0,0,0,0,0,2,0,2)
  1:(1,1,0,1,1,2,1,2)
  2:(2,2,0,2,2,2,2,2)
  $ head -c 60 dimer.lab
  0="init" 1="deadlock" 2="quiescent" 3="unexplored" 4="right_
  $ scc explore ../../specs/models/dimer.sc -o dimer.tra --dialect storm
  scc: semantics 3: split step 1/2
  scc: explored: 11 states, 14 transitions; complete
  $ ls dimer.*
  dimer.aut
  dimer.clab
  dimer.lab
  dimer.names.json
  dimer.sta
  dimer.tra
  $ head -4 dimer.tra dimer.clab
  ==> dimer.tra <==
  mdp
  0 0 1 1
  1 0 2 1
  2 0 3 1
  
  ==> dimer.clab <==
  #DECLARATION
  time_1 time_1_over_2 weak_bond_w1_right_w2_left strong_bond_s1_right_s2_left rest
  #END
  0 0 time_1

A picture.

  $ scc explore ../../specs/models/chain.sc -D n=2 -o -  --format dot
  digraph "chain" {
    node [shape=box, fontname="Helvetica", fontsize=10]
    edge [fontname="Helvetica", fontsize=9]
    start [shape=point]
    start -> s0
    s0 [label="0\nc[1]: Free\nc[2]: Free", style="rounded,filled", fillcolor="white"]
    s0 -> s1 [label="time(1)", color="gray50", fontcolor="gray50"]
    s1 [label="1\nc[1]: Free\nc[2]: Free", style="rounded,filled", fillcolor="white"]
    s1 -> s2 [label="bind(link, c[1].right,\nc[2].left)"]
    s2 [label="2\n<link, {c[1].right, c[2].left}>\nc[1]: Head\nc[2]: Tail\nreaches whole\nreaches bonded\nreaches slows\nviolates free", style="rounded,filled", fillcolor="#f6b8b0", peripheries=2]
    legend [shape=plain, label=<<table border="0" cellborder="0" cellspacing="2"><tr><td></td><td align="left">model chain, n = 2</td></tr><tr><td></td><td align="left">semantics 3</td></tr><tr><td></td><td align="left">explored: 3 states, 2 transitions; complete</td></tr><tr><td bgcolor="#bfe5b8" width="24"></td><td align="left">reaches whole: eventually size(c[1]) = n</td></tr><tr><td bgcolor="#bfe5b8" width="24"></td><td align="left">reaches bonded: eventually bonds(link) = n - 1</td></tr><tr><td bgcolor="#bfe5b8" width="24"></td><td align="left">reaches slows: eventually vx(c[n]) = 1/n</td></tr><tr><td bgcolor="#f6b8b0" width="24"></td><td align="left">violates free: always processes &gt;= 2</td></tr><tr><td></td><td align="left">double border: nothing will ever happen again</td></tr><tr><td></td><td align="left">gray: time passes; with a colour: it is so on the way</td></tr></table>>]
  }
  scc: semantics 3
  scc: explored: 3 states, 2 transitions; complete

What is cut short is told, by the exit code as well.

  $ scc explore ../../specs/models/billiard.sc --states 2 -o - --format aut
  des (0, 2, 2)
  (0, "time(5/4)", 1)
  (1, "unexplored", 1)
  scc: semantics 3
  scc: explored: 2 states, 1 transitions
  scc: TRUNCATED: 1 states unexplored, by the bound of 2 states
  $ scc explore ../../specs/models/gravity.sc --time 1 -o gravity.json
  scc: semantics 3: timestep 1/4
  scc: explored: 6 states, 5 transitions
  scc: TRUNCATED: 1 states unexplored, by the time bound 1
  $ grep -E '^"(complete|unexplored|bounds)"' gravity.json
  "complete": false,
  "unexplored": 1,
  "bounds": ["the time bound 1"],

The same bytes each time.

  $ for format in aut dot json tra drn; do
  >   for model in hexokinase figure1 drift; do
  >     scc explore ../../specs/models/$model.sc --time 4 -o one.$format 2> /dev/null
  >     scc explore ../../specs/models/$model.sc --time 4 -o two.$format 2> /dev/null
  >     cmp one.$format two.$format
  >   done
  > done

A file is there as a whole or not at all.

  $ echo before > full.aut
  $ scc explore nothing.sc -o full.aut
  nothing.sc: error[SC0101]: cannot read: No such file or directory
  [3]
  $ cat full.aut
  before
  $ mkdir folder.aut
  $ scc explore ../../specs/models/drift.sc -o folder.aut
  folder.aut: error[SC0103]: cannot write: Is a directory
  [74]
  $ scc explore ../../specs/models/drift.sc -o nowhere/drift.tra
  nowhere/drift.tra: error[SC0103]: cannot write: No such file or directory
  [74]
  $ mkdir part && echo before > part/x.tra && mkdir part/x.lab
  $ scc explore ../../specs/models/drift.sc -o part/x.tra
  part/x.lab: error[SC0103]: cannot write: Is a directory
  [74]
  $ cat part/x.tra && ls part
  before
  x.lab
  x.tra
  $ ln -s target.aut link.aut && scc explore ../../specs/models/drift.sc -o link.aut && cat target.aut
  scc: semantics 3
  scc: explored: 1 states, 0 transitions; complete
  des (0, 2, 2)
  (0, "time(forever)", 1)
  (1, "time(forever)", 1)
  $ scc explore ../../specs/models/drift.sc -o /dev/full --format aut
  /dev/full: error[SC0103]: cannot write: No space left on device
  [74]
  $ scc explore ../../specs/models/drift.sc -o - --format aut > /dev/full
  standard output: error[SC0103]: cannot write: No space left on device
  [74]
  $ ls | grep part$
  part

Formats that are not there.

  $ scc explore ../../specs/models/drift.sc -o drift.txt
  scc: `drift.txt' does not tell its format by its extension (.gv, .aut, .dot, .json, .tra, .drn): give one with --format
  [64]
  $ scc explore ../../specs/models/drift.sc -o -
  scc: what goes to standard output needs a --format
  [64]
  $ scc explore ../../specs/models/drift.sc -o - --format tra
  scc: the format tra makes several files, which do not go to standard output together
  [64]
  $ scc explore ../../specs/models/drift.sc
  scc: required option --output is missing
  Usage: scc explore [OPTION]… MODEL
  Try 'scc explore --help' or 'scc --help' for more information.
  [64]

A run for Apalache.

  $ scc trace ../../specs/models/drift.sc --time 3/2 --itf | sed 's/"md5:[^"]*"/"md5:…"/'
  {
  "#meta": {"format":"ITF","description":"a run of the Shape Calculus, made by scc","model":"drift","digest":"md5:…","semantics":"3","parameters":{},"settings":{}},
  "vars": ["action","time","position","velocity","behaviour","origin","process","bonds","clock","step"],
  "states": [
  {"#meta":{"index":0},"action":"init","time":{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},"position":{"#map":[["p",{"#tup":[{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]}]}]]},"velocity":{"#map":[["p",{"#tup":[{"#tup":[{"#bigint":"1"},{"#bigint":"3"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]}]}]]},"behaviour":{"#map":[["p","nil"]]},"origin":{"#map":[["p",""]]},"process":{"#map":[["p","p"]]},"bonds":{"#set":[]},"clock":{"#map":[]},"step":{"remaining":{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},"phase":"none"}},
  {"#meta":{"index":1,"ending":"quiescent"},"action":"pass","time":{"#tup":[{"#bigint":"3"},{"#bigint":"2"}]},"position":{"#map":[["p",{"#tup":[{"#tup":[{"#bigint":"1"},{"#bigint":"2"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]}]}]]},"velocity":{"#map":[["p",{"#tup":[{"#tup":[{"#bigint":"1"},{"#bigint":"3"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]}]}]]},"behaviour":{"#map":[["p","nil"]]},"origin":{"#map":[["p",""]]},"process":{"#map":[["p","p"]]},"bonds":{"#set":[]},"clock":{"#map":[]},"step":{"remaining":{"#tup":[{"#bigint":"0"},{"#bigint":"1"}]},"phase":"none"}}
  ]
  }
