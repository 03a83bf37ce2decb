A model that holds because nothing happens is told so, without being asked:

  $ models=../../specs/models
  $ scc check $models/vacuous.sc > /dev/null
  ../../specs/models/vacuous.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  ../../specs/models/vacuous.sc:22:26: warning[SC0702]: no run ever meets `bound(ball, plate)`, so that what `no_loss` says of it is never asked
      |
   22 | check no_loss  : always (bound(ball, plate) => vx(ball) = 0)                            // expect: holds
      |                          ^^^^^^^^^^^^^^^^^^
  ../../specs/models/vacuous.sc:23:18: warning[SC0702]: no run ever meets `behaviour(ball) = Stuck`, so that what `released` says of it is never asked
      |
   23 | check released : behaviour(ball) = Stuck leads_to behaviour(ball) = Spent within 5      // expect: holds
      |                  ^^^^^^^^^^^^^^^^^^^^^^^

Coverage lists what never came to be.

  $ scc check $models/vacuous.sc --coverage 2> /dev/null | sed -n '/^coverage/,$p'
  coverage: 0 of 6 summands fired, 2 of 5 behaviours reached, 0 of 1 channels used, among 1 state
    never fired:
      Bare on Cube: <~stick, {top}>. Taken
      Free on Cube: <stick, {bottom}>. Stuck
      Taken on Cube: omega(stick, {top}). Bare
      Taken on Cube: rho({<stick, {top}>}). Bare
      Stuck on Cube: omega(stick, {bottom}). Free
      Stuck on Cube: rho({<stick, {bottom}>}). Spent
    never reached:
      Taken on Cube
      Stuck on Cube
      Spent on Cube
    channels never used:
      stick
    no rule was ever used
  3 properties: 3 hold

In a model where all of it does, there is nothing to list:

  $ scc check $models/hexokinase.sc --coverage | sed -n '/^coverage/,$p'
  coverage: 15 of 15 summands fired, 10 of 10 behaviours reached, 2 of 2 channels used, among 11 states
    rules: Pre 6, Weak 6, Strong 1, Sum 13, Def 13, TimeBehaviour 3, WeakSplit 6, StrongSplit 1, Bind 6, Time 3
    rules never used: Bounce, Steer
  8 properties: 7 hold, 1 violated

It is about all of the model, even where the properties are decided early, and it says when bounds hide a part:

  $ scc check $models/chain.sc -D n=3 --coverage --depth 2 | sed -n '/^coverage/,$p'
  coverage: 2 of 4 summands fired, 3 of 3 behaviours reached, 1 of 1 channels used, among the transitions of 3 of the 4 states found: more may fire beyond the bounds
    never fired:
      Tail on Cube: <link, {right}>. nil
      Head on Cube: <~link, {left}>. nil
    rules: Pre 1, Sum 1, Def 1, TimeBehaviour 2, Bind 1, Time 2
    rules never used: Weak, Strong, WeakSplit, StrongSplit, Bounce, Steer
  6 properties: 3 hold up to the bound, 3 undecided

As JSON:

  $ scc check $models/hexokinase.sc --coverage --json | grep -A 1 -e '"channels"' -e '"rules"'
      "channels": [
        {"name": "atp", "made": 3, "weak": 3, "strong": 1},
  --
      "rules": {
        "Pre": 6,

Warnings change no verdict and no exit code, and are diagnostics in JSON:

  $ scc check $models/vacuous.sc --json | grep -e '"exit"' -e '"code"' -e '"verdict"'
    "exit": 0,
        "verdict": "holds",
        "verdict": "holds",
        "verdict": "holds",
        "code": "SC0703",
        "code": "SC0702",
        "code": "SC0702",

Nothing is said of premises that some run meets, and nothing when the exploration is not complete:

  $ sed 's/velocity (1,0,0) at translate (-5,3,0)/velocity (0,-1,0) at translate (0,3,0)/' $models/vacuous.sc > meets.sc
  $ scc check meets.sc 2>&1 | grep -e warning -e '^[a-z_]*: '
  no_loss: holds (exhaustive), at split step 1
  released: violated, at split step 1
  at_most: holds (exhaustive), at split step 1
  explored: 5 states, 4 transitions, depth 3, model time 1; complete
  $ scc check meets.sc --depth 0 2>&1 | grep -e warning -e '^[a-z_]*: '
  no_loss: holds up to the bound: the depth bound 0
  released: undecided: the exploration ended at the depth bound 0; one unexplored state matters
  at_most: holds up to the bound: the depth bound 0
  explored: 2 states, 1 transition, depth 1, model time 1; not complete: stopped by the depth bound 0

Statistics vary, and are not part of the report:

  $ scc check $models/chain.sc --stats 2> stats > with
  [1]
  $ scc check $models/chain.sc > without
  [1]
  $ cmp with without
  $ sed 's/[0-9][0-9.]*/N/g' stats
  measured (varies from run to run):
    states N, transitions N, depth N
    rate: N states/s, N transitions/s
    memory, at most: heap N MiB, resident N MiB
    stores: states N MiB, labels N MiB, edges N MiB
    longest numbers, in bits: positions N, velocities N
    collections: N minor, N major
    seconds: read N, explore N, conclude N
  $ scc check $models/chain.sc --stats --json | grep -c '"varies": true'
  1

SARIF has the faults of a model, its warnings, and what is violated or undecided:

  $ results () { grep -e '"ruleId"' -e '"level"' -e '"startLine"' -e '"executionSuccessful"' $1 | sed 's/^ *//'; }
  $ scc check $models/vacuous.sc --sarif log.sarif > /dev/null 2>&1
  $ results log.sarif
  "invocations": [{"executionSuccessful": true, "exitCode": 0}],
  "ruleId": "SC0703",
  "level": "warning",
  "region": {"startLine": 1, "startColumn": 1, "endLine": 1, "endColumn": 1}
  "ruleId": "SC0702",
  "level": "warning",
  "region": {"startLine": 22, "startColumn": 26, "endLine": 22, "endColumn": 44}
  "ruleId": "SC0702",
  "level": "warning",
  "region": {"startLine": 23, "startColumn": 18, "endLine": 23, "endColumn": 41}
  $ scc check ../../specs/conformance/invalid/SC0201-template.sc --sarif log.sarif > /dev/null 2>&1
  [3]
  $ results log.sarif
  "invocations": [{"executionSuccessful": true, "exitCode": 3}],
  "ruleId": "SC0201",
  "level": "error",
  "region": {"startLine": 8, "startColumn": 13, "endLine": 8, "endColumn": 16}
  $ scc check $models/dimers.sc --sarif log.sarif > /dev/null
  [1]
  $ results log.sarif | uniq -c | sed 's/^ *//'
  1 "invocations": [{"executionSuccessful": true, "exitCode": 1}],
  1 "ruleId": "violated",
  1 "level": "error",
  1 "region": {"startLine": 24, "startColumn": 7, "endLine": 24, "endColumn": 11}
  4 "startLine": 24,
  $ scc check $models/dimers.sc --sarif nowhere/log.sarif > /dev/null
  nowhere/log.sarif: error[SC0103]: cannot write: No such file or directory
  [74]
