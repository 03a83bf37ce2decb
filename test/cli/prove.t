Proofs where no state ever comes back (rule Invariants): a bound ends the exploration, and an invariant says the rest.

  $ cp ../../specs/models/escape.sc ../../specs/models/tumble.sc ../../specs/models/hexokinase.sc .
  $ scc check escape.sc | sed '/a run that/,/^$/d'
  semantics 3
  
  apart: holds (proved by an invariant, all x in [-8, -7])
    always not touching(p, q) and not touching(n, q)
  
  inside: holds (proved by an invariant, all x in [-8, -7])
    always x(n) <= -2
  
  order: holds (proved by an invariant, all x in [-8, -7])
    always x(p) + 2 <= x(n)
  
  slow: violated for x = -22/3
    always x(q) <= 20
  invariant: 8 kinds of states that no run leaves, checked afresh
  explored: 3124 states, 3194 transitions, depth 1000; not complete: stopped by the depth bound 1000 (a default)
  4 properties: 3 hold, 1 violated
  $ scc check escape.sc --prove --invariant - | sed '/^semantics/,$d'
  8 kinds of states, of which no run leaves the union:
  1.
    p, velocity (2/3, 0, 0)
    n, velocity (-1, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x <= -7
  2.
    p, velocity (-1, 0, 0)
    n, velocity (2/3, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x <= -7
  3.
    p, velocity (1, 0, 0)
    n, velocity (2/3, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x(p) + 6 < x(q)
      x <= -7
  4.
    p, velocity (1, 0, 0)
    n, velocity (-2/3, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x(p) + 6 < x(q)
      x <= -7
  5.
    p, velocity (-2/3, 0, 0)
    n, velocity (1, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x <= -7
  6.
    p, velocity (-2/3, 0, 0)
    n, velocity (-1, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x <= -7
  7.
    p, velocity (-1, 0, 0)
    n, velocity (-2/3, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x <= -7
  8.
    p, velocity (2/3, 0, 0)
    n, velocity (1, 0, 0)
    q, velocity (1, 0, 0)
      x >= -8
      x(p) >= -8
      x(q) >= 2
      x(n) <= -2
      x(p) + 2 <= x(n)
      x(p) + 6 < x(q)
      x <= -7
  
  $ scc check escape.sc --invariant found.txt --json | python3 -c '
  > import json, sys
  > report = json.load(sys.stdin)
  > for p in report["properties"]:
  >     print(p["name"], p["verdict"], p.get("by_invariant", False))
  > kind = report["invariants"][0]["kinds"][0]
  > print(kind["processes"][2]["velocity"], kind["just_now"], kind["constraints"][0])'
  apart holds True
  inside holds True
  order holds True
  slow violated False
  ['2/3', '0/1', '0/1'] [] {'coefficients': {'age(west)': '1/1'}, 'relation': '=', 'bound': '0/1'}
  $ head -1 found.txt
  8 kinds of states, of which no run leaves the union:

An ordinary model has one looked for when it is asked to.

  $ sed 's/^param x.*/param x = -8/' escape.sc > one.sc
  $ scc check one.sc --prove --depth 40 | sed '/a run that/,/^$/d'
  semantics 3
  
  apart: holds (proved by an invariant)
    always not touching(p, q) and not touching(n, q)
  
  inside: holds (proved by an invariant)
    always x(n) <= -2
  
  order: holds (proved by an invariant)
    always x(p) + 2 <= x(n)
  
  slow: violated
    always x(q) <= 20
  invariant: 8 kinds of states that no run leaves, checked afresh
  explored: 22 states, 21 transitions, depth 21, model time 81/5; not complete: every property was decided before
  4 properties: 3 hold, 1 violated
  $ scc check one.sc --depth 40 | grep -A1 apart
  apart: holds up to the bound: the depth bound 40
    always not touching(p, q) and not touching(n, q)
  $ scc check hexokinase.sc --prove | grep "proved\|^invariant"
  together: holds (proved by an invariant), at split step 1
  at_most: holds (proved by an invariant), at split step 1
  in_pocket: holds (proved by an invariant), at split step 1
  invariant: 10 kinds of states that no run leaves, checked afresh

What cannot be proved so is explored: what comes, or what the set of states that was found does not rule out.

  $ sed '/^check/d' one.sc > none.sc
  $ echo 'check comes : possibly x(q) > 9' >> none.sc
  $ scc check none.sc --prove --depth 40 | grep "comes\|invariant\|explored"
  comes: holds (exhaustive)
  no invariant: no run leaves the set of states that was found, but this proves nothing
  explored: 6 states, 5 transitions, depth 5, model time 6; not complete: every property was decided before

Where no invariant can be looked for, it is said.

  $ scc check tumble.sc --prove
  error[SC0901]: no invariant of this model can be looked for: its bodies turn
    hint: its checks can be explored, without --prove
  [3]
  $ scc check one.sc --invariant no/such/folder --depth 40 | tail -1
  no/such/folder: error[SC0103]: cannot write: No such file or directory
  4 properties: 3 hold, 1 violated

A delay that leads to itself goes on for ever, and a bond may be released at any time before it is over, or when it is:

  $ cat > again.sc <<'END'
  > split_step any
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > behaviour Beat on Cube = eps(1/2). Beat + <~b, {top}>. nil
  > process p = Cube mass 1 velocity (2,0,0) at translate (2,0,0) [Beat]
  > process d = Cube mass 1 velocity (-1,0,0) at translate (13,0,0) [omega(a, {right}). nil]
  > process e = Cube mass 1 velocity (-1,0,0) at translate (15,0,0) [omega(~a, {left}). nil]
  > bond <a, {d.right, e.left}>
  > check order : always x(p) + 2 <= x(d)
  > check near  : always x(p) + 3 <= x(d)
  > END
  $ scc check again.sc --prove --depth 20 | grep "proved\|^near\|invariant"
  order: holds (proved by an invariant, all instants)
  near: violated
  invariant: 8 kinds of states that no run leaves, checked afresh

A delay that is known for some values only, beside one that may be over before it:

  $ cat > beside.sc <<'E'
  > param u in (0, 3)
  > shape Cube = box(1,1,1)
  > process p = Cube mass 1 [eps(u). eps(1/2). nil + eps(1/2). <a, {top}>. nil]
  > check stays : always x(p) < 6
  > E
  $ scc check beside.sc --prove | sed '/^semantics/,/^$/d'
  stays: holds (proved by an invariant, all u in (0, 3))
    always x(p) < 6
  
  invariant: 6 kinds of states that no run leaves, checked afresh
  explored: 1 state, 0 transitions, depth 0; not complete: every property was decided before
  1 property: 1 holds

Where the search takes long, exploring comes first; how far it goes is counted, and is the same on every machine.

  $ scc check ../bench/checker/hexokinase.sc -D n=4 --prove
  semantics 3: split step 1
  
  together: holds (exhaustive), at split step 1
    always bonds(atp) <= 1 and bonds(glc) <= 1
  
  no invariant: the search for one was given up after 10 million steps of arithmetic
  explored: 23044 states, 34625 transitions, depth 2388, model time 1368; complete
  1 property: 1 holds

No invariant is searched for where it could prove nothing.

  $ cat > nested.sc <<'EOF'
  > param u in [-1, -1/2]
  > shape C = box(2,2,2)
  > shape W = box(2,40,40)
  > process p = C mass 1 velocity (2,-1,0) at translate (0,1,0) [nil]
  > process q = C mass 2 velocity (-1,0,0) at translate (6 + u,0,0) [nil]
  > fixed l = W at translate (-5,0,0)
  > fixed r = W at translate (14,0,0)
  > check c : EG EX true
  > EOF
  $ scc check nested.sc --depth 30 | grep -E '^c:|invariant'
  c: undecided: the exploration ended at the depth bound 30; one unexplored state matters
  $ scc check nested.sc --depth 30 --prove | grep -E '^c:|invariant'
  c: undecided: the exploration ended at the depth bound 30; one unexplored state matters
  no invariant: an invariant proves no formula that nests operators of time, or that asks about time or quiescence
