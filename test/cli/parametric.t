Probabilities as functions of a parameter (rule Parametric). A walker steps to the right with probability k, to the left
otherwise, between two walls.

  $ sed -e 's/^motion walker = .*/param k in (0, 1)\nmotion walker = choose { (1, 0, 0) weight k, (-1, 0, 0) weight 1 - k }/' \
  >   ../../specs/models/ruin.sc > ruin.sc
  $ cat >> ruin.sc <<'END'
  > check half : P >= 1/2 [ eventually event absorb(walker, ruin) ]
  > check two  : P >= 1/4 [ eventually event absorb(walker, ruin) ] and P < 3/4 [ eventually gone(walker) within 4 ]
  > check long : E <= 5 [ time U gone(walker) ]
  > check deep : AG P > 1/8 [ eventually event absorb(walker, ruin) ]
  > END
  $ scc check ruin.sc --parametric k
  semantics 3: timestep 1
  
  ruined: holds (exhaustive)
    possibly event absorb(walker, ruin)
  
  rich: holds (exhaustive)
    possibly event absorb(walker, riches)
  
  ends: violated
    eventually gone(walker)
  
  surely: holds (exhaustive, all k in (0, 1))
    P >= 1 [ eventually gone(walker) ]
    holds where
      k in (0, 1)
    as a function of k
      1
      is constant for k in (0, 1)
  
  how_often: (k^4 - 3k^3 + 4k^2 - 3k + 1)/(k^4 - 2k^3 + 4k^2 - 3k + 1), for k in (0, 1)
    P = ? [ eventually event absorb(walker, ruin) ]
    as a function of k
      (k^4 - 3k^3 + 4k^2 - 3k + 1)/(k^4 - 2k^3 + 4k^2 - 3k + 1)
      derivative: (k^6 - 4k^4 + 6k^3 - 3k^2)/(k^8 - 4k^7 + 12k^6 - 22k^5 + 30k^4 - 28k^3 + 17k^2 - 6k + 1)
      falls for k in (0, 1)
      least over k: towards 0, as k goes to 1
      greatest over k: towards 1, as k goes to 0
  
  by_four: -2k^4 + 7k^3 - 5k^2 + 1, for k in (0, 1)
    P = ? [ eventually gone(walker) within 4 ]
    as a function of k
      -2k^4 + 7k^3 - 5k^2 + 1
      derivative: -8k^3 + 21k^2 - 10k
      falls for k in (0, 5/8)
      rises for k in (5/8, 1)
      least over k: 923/2048 at k = 5/8
      greatest over k: towards 1, as k goes to 0 or 1
  
  how_long: (-k^3 + 4k^2 - 2k + 2)/(k^4 - 2k^3 + 4k^2 - 3k + 1), for k in (0, 1)
    E = ? [ time U gone(walker) ]
    as a function of k
      (-k^3 + 4k^2 - 2k + 2)/(k^4 - 2k^3 + 4k^2 - 3k + 1)
      derivative: (k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4)/(k^8 - 4k^7 + 12k^6 - 22k^5 + 30k^4 - 28k^3 + 17k^2 - 6k + 1)
      rises for k in (0, root of k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4 in (1/2, 3/5), about 0.548654)
      falls for k in (root of k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4 in (1/2, 3/5), about 0.548654, 1)
      least over k: towards 2, as k goes to 0
      greatest over k: about 6.097601289 at k = root of k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4 in (1/2, 3/5), about 0.548654
  
  drift: 3k - 3/2, for k in (0, 1)
    E = ? [ x(walker) at 3/2 ]
    as a function of k
      3k - 3/2
      derivative: 3
      rises for k in (0, 1)
      least over k: towards -3/2, as k goes to 0
      greatest over k: towards 3/2, as k goes to 1
  
  may_end: holds (exhaustive)
    AG EF gone(walker)
  
  not_soon: violated
    always not gone(walker) within 2
  
  not_sooner: holds (exhaustive)
    always not gone(walker) within 3/2
  
  by_steps: holds (exhaustive)
    always gone(walker) or speed2(walker) <= 1
  
  half: violated for some k in (0, 1)
    P >= 1/2 [ eventually event absorb(walker, ruin) ]
    holds where
      k in (0, root of k^4 - 4k^3 + 4k^2 - 3k + 1 in (1/2, 3/5), about 0.541016]
    as a function of k
      (k^4 - 3k^3 + 4k^2 - 3k + 1)/(k^4 - 2k^3 + 4k^2 - 3k + 1)
      derivative: (k^6 - 4k^4 + 6k^3 - 3k^2)/(k^8 - 4k^7 + 12k^6 - 22k^5 + 30k^4 - 28k^3 + 17k^2 - 6k + 1)
      falls for k in (0, 1)
      least over k: towards 0, as k goes to 1
      greatest over k: towards 1, as k goes to 0
  
  two: violated for some k in (0, 1)
    P >= 1/4 [ eventually event absorb(walker, ruin) ] and P < 3/4 [ eventually gone(walker) within 4 ]
    holds where
      k in (root of 8k^4 - 28k^3 + 20k^2 - 1 in (1/5, 3/10), about 0.279527, root of 3k^4 - 10k^3 + 12k^2 - 9k + 3 in (3/5, 7/10), about 0.653335]
  
  long: violated for some k in (0, 1)
    E <= 5 [ time U gone(walker) ]
    holds where
      k in (0, root of 5k^4 - 9k^3 + 16k^2 - 13k + 3 in (3/10, 2/5), about 0.374804]
      k in [root of 5k^4 - 9k^3 + 16k^2 - 13k + 3 in (7/10, 4/5), about 0.741515, 1)
    as a function of k
      (-k^3 + 4k^2 - 2k + 2)/(k^4 - 2k^3 + 4k^2 - 3k + 1)
      derivative: (k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4)/(k^8 - 4k^7 + 12k^6 - 22k^5 + 30k^4 - 28k^3 + 17k^2 - 6k + 1)
      rises for k in (0, root of k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4 in (1/2, 3/5), about 0.548654)
      falls for k in (root of k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4 in (1/2, 3/5), about 0.548654, 1)
      least over k: towards 2, as k goes to 0
      greatest over k: about 6.097601289 at k = root of k^6 - 8k^5 + 10k^4 - 10k^3 + 5k^2 - 8k + 4 in (1/2, 3/5), about 0.548654
  
  deep: undecided: a probability within another operator may hold for some values alone
    AG P > 1/8 [ eventually event absorb(walker, ruin) ]
  
  explored: 19 states, 24 transitions, depth 7, model time 3; complete
  16 properties: 6 hold, 5 violated, 4 measured, 1 undecided
  [1]
  $ scc check ruin.sc --parametric k --check half --json
  {
    "format": "scc-check",
    "version": 1,
    "semantics": "3",
    "model": "ruin",
    "digest": "md5:b1287b7200433a2468d28bba480c4d79",
    "parameters": {},
    "settings": {"timestep": "1"},
    "exit": 1,
    "properties": [
      {
        "name": "half",
        "formula": "P >= 1/2 [ eventually event absorb(walker, ruin) ]",
        "verdict": "violated",
        "text": "violated for some k in (0, 1)",
        "bounds": [],
        "reasons": [],
        "witness": null,
        "dependence": {
          "parameter": "k",
          "low": "0/1",
          "high": "1/1",
          "holds": [
            {
              "low": "0/1",
              "low_included": false,
              "high": {
                "root_of": ["1/1", "-3/1", "4/1", "-4/1", "1/1"],
                "low": "0/1",
                "high": "1/1"
              },
              "high_included": true
            }
          ],
          "functions": [
            {
              "side": "least",
              "pieces": [
                {
                  "low": "0/1",
                  "high": "1/1",
                  "function": {
                    "numerator": ["1/1", "-3/1", "4/1", "-3/1", "1/1"],
                    "denominator": ["1/1", "-3/1", "4/1", "-2/1", "1/1"]
                  }
                }
              ],
              "trends": [{"low": "0/1", "high": "1/1", "trend": "falls"}],
              "least": {"at": ["1/1"], "attained": false, "value": {"low": "0/1", "high": "0/1"}},
              "greatest": {"at": ["0/1"], "attained": false, "value": {"low": "1/1", "high": "1/1"}}
            }
          ]
        }
      }
    ],
    "explored": {
      "states": 19,
      "transitions": 24,
      "depth": 7,
      "time": "3/1",
      "complete": true,
      "decided_early": false,
      "stopped_by": [],
      "faults": [],
      "dead_ends": []
    },
    "slices": [],
    "zeno": null,
    "diagnostics": []
  }
  [1]

At an end of the range, and at any other value, plain numbers.

  $ scc check ruin.sc -D k=2/5 --check how_often --check half | grep -v '^ '
  semantics 3: timestep 1
  
  how_often: 171/211
  
  half: holds (exhaustive)
  
  explored: 19 states, 24 transitions, depth 7, model time 3; complete
  2 properties: 1 holds, 1 measured

Something is left to choose: whether the bond is released as Quick or as Slow.

  $ cat > free.sc <<'END'
  > model free
  > split_step 1
  > param k in (0, 1)
  > import <solids>
  > behaviour A on solids.Cube(1) = omega(bond, {right}). Quick + omega(bond, {right}). Slow
  > behaviour B on solids.Cube(1) = omega(bond, {left}). nil
  > behaviour Quick on solids.Cube(1) = omega(m, {left}) chance k. Won
  > behaviour Slow on solids.Cube(1) = omega(m, {left}) chance 1/3. Won
  > behaviour Won on solids.Cube(1) = nil
  > behaviour C on solids.Cube(1) = omega(m, {right}). nil
  > process c = solids.Cube(1) mass 1 at translate (-1, 0, 0) [C]
  > process a = solids.Cube(1) mass 1 [A]
  > process b = solids.Cube(1) mass 1 at translate (1, 0, 0) [B]
  > bond <bond, {a.right, b.left}>
  > bond <m, {c.right, a.left}>
  > check won  : P = ? [ eventually behaviour(a) = Won within 3 ]
  > check most : Pmax <= 3/4 [ eventually behaviour(a) = Won within 3 ]
  > check sum  : Emin = ? [ event weak U behaviour(a) = Won ]
  > END
  $ scc check free.sc --parametric k
  semantics 3: split step 1
  
  won: least 0; greatest 2 functions of k, for k in (0, 1), at split step 1
    P = ? [ eventually behaviour(a) = Won within 3 ]
    least, as a function of k
      0
      is constant for k in (0, 1)
    greatest, as a function of k
      for k in (0, 1/3): 19/27
      for k in (1/3, 1): k^3 - 3k^2 + 3k
        derivative: 3k^2 - 6k + 3
      is constant for k in (0, 1/3)
      rises for k in (1/3, 1)
      least over k: 19/27 at k = 1/3
      greatest over k: towards 1, as k goes to 1
  
  most: violated for some k in (0, 1), at split step 1
    Pmax <= 3/4 [ eventually behaviour(a) = Won within 3 ]
    holds where
      k in (0, root of 4k^3 - 12k^2 + 12k - 3 in (3/10, 2/5), about 0.370039]
    as a function of k
      for k in (0, 1/3): 19/27
      for k in (1/3, 1): k^3 - 3k^2 + 3k
        derivative: 3k^2 - 6k + 3
      is constant for k in (0, 1/3)
      rises for k in (1/3, 1)
      least over k: 19/27 at k = 1/3
      greatest over k: towards 1, as k goes to 1
  
  sum: 2, for k in (0, 1), at split step 1
    Emin = ? [ event weak U behaviour(a) = Won ]
    as a function of k
      2
      is constant for k in (0, 1)
  
  explored: 10 states, 13 transitions, depth 4, model time 1; complete
  3 properties: 1 violated, 2 measured
  [1]

Where k cannot stand, and where transitions would come and go.

  $ refused () { cat > refused.sc; scc check refused.sc --parametric k "$@"; }
  $ refused <<'END'
  > param k in (0, 1)
  > import <solids>
  > process p = solids.Cube(1) mass 1 at translate (k, 0, 0) [nil]
  > END
  refused.sc:3:48: error[SC0218]: `k` is the parameter that is asked about, and cannot stand here: the states of the model would depend on it
     |
   3 | process p = solids.Cube(1) mass 1 at translate (k, 0, 0) [nil]
     |                                                ^^^^^^^^^
    hint: with `--parametric` it may stand in weights and chances
  [3]
  $ refused <<'END'
  > param k in (0, 1)
  > import <solids>
  > process p = solids.Cube(1) mass 1 [nil]
  > motion p = choose { (k, 0, 0), (0, 0, 0) weight if k > 1/2 then 1 else 2 }
  > END
  refused.sc:4:21: error[SC0218]: `k` is the parameter that is asked about, and cannot stand here: bodies would move otherwise, and the states of the model would not be the same
     |
   4 | motion p = choose { (k, 0, 0), (0, 0, 0) weight if k > 1/2 then 1 else 2 }
     |                     ^^^^^^^^^
    hint: with `--parametric` it may stand in weights and chances
  refused.sc:4:49: error[SC0218]: `k` is the parameter that is asked about, and cannot stand here: what is compared or rounded must be known
     |
   4 | motion p = choose { (k, 0, 0), (0, 0, 0) weight if k > 1/2 then 1 else 2 }
     |                                                 ^^^^^^^^^^^^^^^^^^^^^^^^
    hint: with `--parametric` it may stand in weights and chances
  [3]
  $ refused <<'END'
  > param k in (0, 1)
  > import <solids>
  > process p = solids.Cube(1) mass 1 [nil]
  > motion p = choose { (1, 0, 0) weight 2*k*k - 1, (0, 0, 0) weight 1/(3*k - 1) }
  > END
  refused.sc:4:38: error[SC0208]: a weight is 0 for k = root of 2k^2 - 1 in (7/10, 4/5), about 0.707107, or not defined, and transitions would come and go there
     |
   4 | motion p = choose { (1, 0, 0) weight 2*k*k - 1, (0, 0, 0) weight 1/(3*k - 1) }
     |                                      ^^^^^^^^^
    hint: a narrower range, as by `-D 'k=(LOW, HIGH)'`, may leave such values out
  refused.sc:4:66: error[SC0207]: a division by zero for k = 1/3
     |
   4 | motion p = choose { (1, 0, 0) weight 2*k*k - 1, (0, 0, 0) weight 1/(3*k - 1) }
     |                                                                  ^^^^^^^^^^^
    hint: a narrower range, as by `-D 'k=(LOW, HIGH)'`, may leave such values out
  [3]
  $ refused <<'END'
  > param k in (0, 2)
  > import <solids>
  > behaviour A on solids.Cube(1) = omega(m, {left}) chance k. nil + omega(m, {left}) rate k. nil
  > process p = solids.Cube(1) mass 1 [A]
  > check c : P >= (k) [ eventually gone(p) ]
  > END
  refused.sc:3:57: error[SC0208]: 1 minus a chance is 0 for k = 1, or not defined, and transitions would come and go there
     |
   3 | behaviour A on solids.Cube(1) = omega(m, {left}) chance k. nil + omega(m, {left}) rate k. nil
     |                                                         ^
    hint: a narrower range, as by `-D 'k=(LOW, HIGH)'`, may leave such values out
  refused.sc:3:88: error[SC0218]: `k` is the parameter that is asked about, and cannot stand here: the chance of a rate is the simplest fraction near its exponential, and no function of the rate
     |
   3 | behaviour A on solids.Cube(1) = omega(m, {left}) chance k. nil + omega(m, {left}) rate k. nil
     |                                                                                        ^
    hint: with `--parametric` it may stand in weights and chances
  refused.sc:5:17: error[SC0218]: `k` is the parameter that is asked about, and cannot stand here: a constant is expected
     |
   5 | check c : P >= (k) [ eventually gone(p) ]
     |                 ^
    hint: with `--parametric` it may stand in weights and chances
  [3]

What depends on the state is found when it comes up: here at x = 0, for k = 1/2.

  $ refused <<'END'
  > param k in (0, 1)
  > import <solids>
  > process p = solids.Cube(1) mass 1 [nil]
  > motion p = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight (k - 1/2)*(k - 1/2) + x*x }
  > check c : P = ? [ eventually x(p) > 1 within 2 ]
  > END
  refused.sc: error[SC0601]: a probability, (4k^2 - 4k + 1)/(4k^2 - 4k + 5), is 0 or not defined for k = 1/2: transitions would come and go there
    hint: a narrower range, as by `-D 'k=(LOW, HIGH)'`, may leave such values out
  [3]
  $ scc check refused.sc --parametric k -D 'k=(1/2, 1)' | head -n 5
  semantics 3: timestep 1
  
  c: 16/(16k^4 - 32k^3 + 72k^2 - 56k + 45), for k in (1/2, 1)
    P = ? [ eventually x(p) > 1 within 2 ]
    as a function of k
  $ scc check refused.sc --parametric j
  command line: error[SC0209]: the model has no parameter `j`
    hint: did you mean `k`?
  [64]
  $ scc check refused.sc --parametric k -D k=1/3
  command line: error[SC0209]: the parameter `k` has one value, and no range
    hint: declare it as in `param k in (0, 1)`, and give it no value
  [64]
  $ sed 's/^param k.*/&\nparam n = 2/' refused.sc > two.sc; grep -c param two.sc; scc check two.sc --parametric n
  2
  command line: error[SC0209]: the parameter `n` has one value, and no range
    hint: declare it as in `param n in (0, 1)`, and give it no value
  [64]
  $ scc check refused.sc --parametric k --where
  scc: --where does not go with --parametric
  [64]

Two summands that are one term at a single value of k: there a lot stays, and the function would be wrong.

  $ cat > equal.sc <<'SC'
  > import <solids>
  > param k in (0, 1)
  > split_step 1
  > behaviour A on solids.Cube(1) = omega(bond, {right}) chance (1 - k). Quick + omega(m, {left}) chance k. Won
  > behaviour B on solids.Cube(1) = omega(bond, {left}). nil
  > behaviour Quick on solids.Cube(1) = omega(m, {left}) chance (1 - k). Won
  > behaviour Won on solids.Cube(1) = nil
  > behaviour C on solids.Cube(1) = omega(m, {right}). nil
  > process c = solids.Cube(1) mass 1 at translate (-1, 0, 0) [C]
  > process a = solids.Cube(1) mass 1 [A]
  > process b = solids.Cube(1) mass 1 at translate (1, 0, 0) [B]
  > bond <bond, {a.right, b.left}>
  > bond <m, {c.right, a.left}>
  > check c : E = ? [ bonds(m) at 1 ]
  > SC
  $ scc check equal.sc --parametric k
  equal.sc:1:1: error[SC0208]: `chance k` and `chance -k + 1` are equal for k = 1/2: there two summands are the same term, and a lot that was drawn by one of them stays for the other
     |
   1 | import <solids>
     | ^
    hint: a narrower range, as by `-D 'k=(LOW, HIGH)'`, may leave such values out
  [3]
  $ scc check equal.sc --parametric k -D 'k=(1/2, 1)' | grep '^c:'
  c: -(1/2)k^2 - (1/2)k + 1, for k in (1/2, 1), at split step 1
  $ scc check equal.sc -D k=2/3 | grep '^c:'
  c: 4/9, at split step 1
  $ scc check equal.sc -D k=1/2 | grep '^c:'
  c: 1/2, at split step 1
