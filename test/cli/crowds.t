The models of crowds (guide, Crowds): exact numbers for two bodies, intervals for ten, and none is from 0 to 1.

  $ M=../../specs/models
  $ for m in antibody filament motor patch pore signal; do scc check $M/crowds/$m.sc -D n=2 | grep -E '^[a-z_0-9]+: ' | grep -v explored; done
  bridges_at_60: 0
  one_by_30: 0
  grown: about 2.322649
  two: about 0.192827
  first_at_9: 0
  moved_at_20: 2198810394625/1099511627776 (about 1.999806)
  bound_at_50: about 0.531772
  any_by_20: 44718160142299772991517/604462909807314587353088 (about 0.073980)
  through_at_100: about 0.292886
  first_by_50: about 0.133432
  informed_at_40: about 0.842708
  all_by_100: about 0.994390
  $ for m in $M/crowds/*.sc; do scc estimate $m --runs 20; done
  active_at_40: estimated: 0.35, from 0.058407 to 1.185176 with confidence 99/100, 20 runs
  
  first_by_40: estimated: 0.15, from 0.017642 to 0.449466 with confidence 99/100, 20 runs
  bridges_at_60: estimated: 1.1, from 0.440662 to 2.333689 with confidence 99/100, 20 runs
  
  one_by_30: estimated: 0.45, from 0.180648 to 0.742775 with confidence 99/100, 20 runs
  shells_at_100: estimated: 0.45, from 0.087093 to 1.564357 with confidence 99/100, 20 runs
  
  one_by_50: estimated: 0, from 0 to 0.23273 with confidence 99/100, 20 runs
  pairs_at_40: estimated: 0.6, from 0.151206 to 3.466596 with confidence 99/100, 20 runs
  
  one_by_10: estimated: 0.25, from 0.058333 to 0.559761 with confidence 99/100, 20 runs
  product: estimated: 0.6, from 0.151206 to 1.971037 with confidence 99/100, 20 runs
  
  first: estimated: 0.15, from 0.017642 to 0.449466 with confidence 99/100, 20 runs
  grown: estimated: 3.25, from 2.116923 to 7.448121 with confidence 99/100, 20 runs
  
  two: estimated: 0.35, from 0.113879 to 0.656569 with confidence 99/100, 20 runs
  first_at_9: estimated: 0.35, from 0.113879 to 0.656569 with confidence 99/100, 20 runs
  
  moved_at_20: estimated: 4.75, from 3.271262 to 6.385974 with confidence 99/100, 20 runs
  by_40: estimated: 0.3, from 0.08455 to 0.609608 with confidence 99/100, 20 runs
  
  seen_at_40: estimated: 0.3, from 0.08455 to 0.609608 with confidence 99/100, 20 runs
  bound_at_50: estimated: 0.6, from 0.131809 to 4.979315 with confidence 99/100, 20 runs
  
  any_by_20: estimated: 0.05, from 0.00025 to 0.317142 with confidence 99/100, 20 runs
  through_at_100: estimated: 0.85, from 0.288255 to 3.64423 with confidence 99/100, 20 runs
  
  first_by_50: estimated: 0.45, from 0.180648 to 0.742775 with confidence 99/100, 20 runs
  informed_at_40: estimated: 8.25, from 5.599253 to 8.920525 with confidence 99/100, 20 runs
  
  all_by_100: estimated: 1, from 0.76727 to 1 with confidence 99/100, 20 runs

A thousand bodies need no other options, and nothing is left open.

  $ scc estimate $M/crowds/motor.sc -D n=1000 --check first_at_9 --runs 1
  first_at_9: estimated: 1, from 0.004999 to 1 with confidence 99/100, 1 run

A short exploration of each shows a run to an unexplored state, also where draws are too many to be joined.

  $ for m in $M/crowds/*.sc; do scc check $m --states 30 > short.txt 2>&1; test $? = 2 || echo "$m: $?"; done

If the draws of one instant are more than the bound of states, it ends at once, and says so. Nothing is lost by that: with
a bound of depth it goes on up to the bound, and knows no more.

  $ scc check $M/crowds/passage.sc -D n=100 --check by_40 | grep -vE '^    [0-9]'
  semantics 3: timestep 1 steady, collisions drawn, blocked wait
  
  by_40: in [0, 1], as far as is known: the exploration ended at the bound of 200000 states (a default), which the draws of 101 bodies at one instant exceed; 766 unexplored states matter
    P = ? [ eventually bound(tracer, target) within 40 ]
    likely cure: `scc estimate --check by_40` tells it from many runs, by an interval with a confidence
    to the nearest unexplored state that matters:
  
  explored: 1021 states, 1020 transitions, depth 5, model time 0; not complete: stopped by the bound of 200000 states (a default), which the draws of 101 bodies at one instant exceed
    likely cause: many draws of the same instant, each of which has several outcomes: the last 1021 states that were found begin at one instant
      cure: fewer bodies that draw, or fewer velocities for each of them; ask `possibly` and `always` of named bodies, and others are left out; `scc estimate` for probabilities and means
    (specs/guide.md, "Why did my model blow up?")
  1 property: 1 undecided
  $ scc check $M/crowds/passage.sc -D n=100 --check by_40 --states 3000 --depth 1000000 | grep -E '^by_40|^explored'
  by_40: in [0, 1], as far as is known: the exploration ended at the bound of 3000 states; 2248 unexplored states matter
  explored: 2997 states, 2996 transitions, depth 6, model time 0; not complete: stopped by the bound of 3000 states
  $ scc check $M/crowds/passage.sc -D n=100 --check by_40 --json | grep -A1 '"limit"'
            "bound": {"limit": "states", "value": 200000, "origin": "default"},
            "witness": null
  --
      "stopped_by": [{"limit": "states", "value": 200000, "origin": "default"}],
      "faults": [],
