Bonds that close rings, where a model says so. Two that bind within one process neither collide nor move otherwise.

  $ M=../../specs/models
  $ scc check $M/closed_ring.sc --witness runs | grep -A 7 "violates"
    a run that violates it:
      1. time passes by 2, to time 2
      2. sw and se collide and bind by <row, {sw.right, se.left}>, at time 2
      3. nw and ne collide and bind by <row, {nw.right, ne.left}>, at time 2
      4. time passes by 1, to time 3
      5. sw and nw collide and bind by <col, {sw.top, nw.bottom}>, at time 3
      6. se and ne, of one process, bind by <col, {se.top, ne.bottom}>, at time 3
      bonds() <= 3 fails: bonds() = 4
  $ scc explain runs/tree.json $M/closed_ring.sc
  semantics 3: bonds cyclic
  
  tree: always bonds() <= 3
  at time 3:
    bonds() <= 3 fails: bonds() = 4
  because of step 2 (bonds of sw), step 3 (bonds of nw), step 5 (bonds of sw), step 6 (bonds of se)
  
       1. time passes by 2, at time 2
  *    2. sw and se collide and bind by <row, {sw.right, se.left}>, at time 2
           because of how everything started
  *    3. nw and ne collide and bind by <row, {nw.right, ne.left}>, at time 2
           because of how everything started
       4. time passes by 1, at time 3
  *    5. sw and nw collide and bind by <col, {sw.top, nw.bottom}>, at time 3
           because of step 2 (motion of sw, bonds of sw, behaviour of sw), step 3 (motion of nw, bonds of nw, behaviour of nw)
  *    6. se and ne, of one process, bind by <col, {se.top, ne.bottom}>, at time 3
           because of step 2 (behaviour of se), step 3 (behaviour of ne), step 5 (bonds of se)
  
  4 of 4 events matter
  every body takes part: none could be left out to try

What is recorded conforms, and is replayed; a closing is not told as a binding.

  $ scc trace $M/clasp.sc --choose random:3 --steps 30 > run.jsonl
  $ scc conform $M/clasp.sc run.jsonl
  run.jsonl: conforms: 16 events, a run of 30 transitions up to time 14
  $ scc trace $M/clasp.sc --schedule run.jsonl | cmp - run.jsonl
  $ sed 's/"close"/"bind"/' run.jsonl | scc conform $M/clasp.sc - | head -4
  <standard input>: diverges at line 3, time 0: wrong-kind
    the trace: bind(clasp, nw.bottom, sw.top)
    close(clasp, sw.top, nw.bottom) is allowed there: the two are of one process already
    rules: Bind, Bounce
  $ cat > told.csv <<EOF
  > time,event,bodies,channel,features
  > 0,close,sw;nw,clasp,sw.top;nw.bottom
  > 3,weak,sw;nw,clasp,
  > 4,close,sw;nw,,
  > EOF
  $ scc conform $M/clasp.sc told.csv
  told.csv: conforms: 3 events, a run of 7 transitions up to time 4

Labels are hidden and compared like others.

  $ scc compare $M/clasp.sc $M/clasp.sc --hide 'close(clasp, *)' | head -2
  equivalent modulo branching
    as labels tell it, which know no places: beside a third body the two may differ

If nothing is said, bonds are a tree.

  $ sed 's/^bonds cyclic//; s/^bond <link, {ne.left, nw.right}>/&\nbond <link, {sw.top, nw.bottom}>/' $M/clasp.sc > tree.sc
  $ scc check tree.sc
  tree.sc:23:6: error[SC0406]: this bond closes a cycle: `sw` and `nw` are joined already, and the bonds of a process are a tree
      |
   23 | bond <link, {sw.top, nw.bottom}>
      |      ^^^^^^^^^^^^^^^^^^^^^^^^^^^
    hint: `bonds cyclic` lets the bonds of a process close rings
  [3]
  $ sed 's/^bonds cyclic/bonds open/' $M/clasp.sc | scc check -
  <standard input>:4:7: error[SC0201]: unknown bonds `open`; it is acyclic or cyclic
     |
   4 | bonds open
     |       ^^^^
  [3]
  $ sed 's/^bonds cyclic/bonds/' $M/clasp.sc | scc check - 2>&1 | head -2
  <standard input>:5:1: error[SC0110]: `split_step` does not fit here: expected `acyclic` or `cyclic`
     |

A word of the language since: it is still a name elsewhere.

  $ sed 's/clasp/bonds/; s/<clasp/<bonds/; s/(clasp/(bonds/; s/~clasp/~bonds/; s/weak(clasp)/weak(bonds)/' $M/clasp.sc > named.sc
  $ scc check named.sc | tail -1
  6 properties: 4 hold, 2 violated
