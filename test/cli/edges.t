Where sets of starts meet their edges.

A delay whose length may be 0 is over at once where it is, and what comes to be for each other length comes to be there:

  $ cat > zero.sc <<'EOF'
  > shape Cube = box(1,1,1)
  > param u in [0, 1]
  > behaviour K on Cube = eps(u). Z
  > behaviour Z on Cube = nil
  > process p = Cube mass 1 [K]
  > check comes : eventually behaviour(p) = Z
  > check some  : possibly behaviour(p) = Z
  > check waits : possibly behaviour(p) = K
  > EOF
  $ scc check zero.sc --where 2>/dev/null | grep -E '^[a-z]+: [hv]|^    [uv]|everywhere|nowhere'
  comes: holds (exhaustive, all u in [0, 1])
    holds everywhere
  some: holds (exhaustive, all u in [0, 1])
    holds everywhere
  waits: violated for u = 0
      u > 0
    probability 1, but not everywhere
  $ for u in 0 1/3 1; do scc check zero.sc -D u=$u 2>/dev/null | grep '^[a-z]*: [hv]'; done
  comes: holds (exhaustive)
  some: holds (exhaustive)
  waits: violated
  comes: holds (exhaustive)
  some: holds (exhaustive)
  waits: holds (exhaustive)
  comes: holds (exhaustive)
  some: holds (exhaustive)
  waits: holds (exhaustive)

Likewise where two parameters coincide:

  $ cat > face.sc <<'EOF'
  > shape Cube = box(1,1,1)
  > param u in [1, 2]
  > param v in [0, 1]
  > behaviour K on Cube = eps(u - v). Z
  > behaviour Z on Cube = <a, {right}>. nil
  > process p = Cube mass 1 [K]
  > process q = Cube mass 1 velocity (-1,0,0) at translate (1+u, 0, 0) [<~a, {left}>. nil]
  > check comes : eventually behaviour(p) = Z
  > check early : possibly (time = 0 and behaviour(p) = Z)
  > check late  : AG (event bind(a) => time >= u)
  > check binds : eventually event bind(a)
  > EOF
  $ scc check face.sc --where | grep -E '^[a-z]+: [hv]|^    [uv]|everywhere|nowhere'
  comes: holds (exhaustive, all u in [1, 2], v in [0, 1])
    holds everywhere
  early: violated for u = 3/2, v = 1/2
      u = 1, v = 1 (no area)
    probability 0, but not nowhere
  late: holds (exhaustive, all u in [1, 2], v in [0, 1])
    holds everywhere
  binds: holds (exhaustive, all u in [1, 2], v in [0, 1])
    holds everywhere
  $ scc check face.sc -D u=1 -D v=1 | grep '^[a-z]*: [hv]'
  comes: holds (exhaustive)
  early: holds (exhaustive)
  late: holds (exhaustive)
  binds: holds (exhaustive)
  $ scc check face.sc -D u=1 -D v=1/2 | grep '^[a-z]*: [hv]'
  comes: holds (exhaustive)
  early: violated
  late: holds (exhaustive)
  binds: holds (exhaustive)

A bound of time that begins late: the run is judged, and shown, from then on.

  $ cat > late.sc <<'EOF'
  > shape Cube = box(1,1,1)
  > param v in [1, 4]
  > process p = Cube mass 1 velocity (1,0,0) [nil]
  > process q = Cube mass 1 at translate (3,0,0) [eps(v). nil]
  > check moves : EG[3, 5] vx(q) = 1
  > check after : EG[3, 5] time >= 3
  > EOF
  $ scc check late.sc
  semantics 3
  
  moves: holds (exhaustive, all v in [1, 4])
    EG[3, 5] vx(q) = 1
    a run that shows it:
      1. time passes by 2, to time 2
      2. p and q collide and bounce, at time 2
      then time passes beyond the bound, which ends at time 5
      vx(q) = 1 holds: vx(q) = 1
      there:
        p at (2, 0, 0) [nil], velocity (0, 0, 0)
        q at (6, 0, 0) [nil], velocity (1, 0, 0)
  
  after: holds (exhaustive, all v in [1, 4])
    EG[3, 5] time >= 3
    a run that shows it:
      1. time passes by 2, to time 2
      2. p and q collide and bounce, at time 2
      then time passes beyond the bound, which ends at time 5
      time >= 3 holds: time = 5
      there:
        p at (2, 0, 0) [nil], velocity (0, 0, 0)
        q at (6, 0, 0) [nil], velocity (1, 0, 0)
  
  explored: 9 states, 8 transitions, depth 3; complete
  2 properties: 2 hold
  $ sed -i 's/param .*/split_step any/; s/eps(v)/eps(2)/' late.sc
  $ scc check late.sc | grep '^[a-z]*: [hv]'
  moves: holds (exhaustive)
  after: holds (exhaustive)

Bodies with one reference point, which is in none of them: neither their names nor the order of declaration decide who
draws first.

  $ cat > one_point.sc <<'EOF'
  > timestep 1
  > shape Far { vertices a (2,-1,-1) b (4,-1,-1) c (4,1,-1) d (2,1,-1) e (2,-1,1) f (4,-1,1) g (4,1,1) h (2,1,1)
  >   faces bottom [a,d,c,b] top [e,f,g,h] front [a,b,f,e] back [d,h,g,c] left [a,e,h,d] right [b,c,g,f] }
  > process p = Far mass 1 [nil]
  > process q = Far mass 1 at rotate quaternion (0,0,0,1) [nil]
  > motion p = choose { (1,0,0) weight 1, (2,0,0) weight 2 }
  > motion q = choose { (-1,0,0) weight 1, (-3,0,0) weight 4 }
  > check q_first : EF[0, 0] (P >= 1 [ eventually vx(q) = -1 within 0 ] and P < 1 [ eventually vx(p) = 1 within 0 ] and P > 0 [ eventually vx(p) = 1 within 0 ])
  > check p_first : EF[0, 0] (P >= 1 [ eventually vx(p) = 1 within 0 ] and P < 1 [ eventually vx(q) = -1 within 0 ] and P > 0 [ eventually vx(q) = -1 within 0 ])
  > EOF
  $ grep '^process q' one_point.sc > q; grep '^process p' one_point.sc > p
  $ (grep -v '^process\|^motion\|^check' one_point.sc; cat q p; grep '^motion\|^check' one_point.sc) > swapped.sc
  $ sed -E 's/\bp\b/zz/g' one_point.sc | sed 's/check zz_first/check p_first/' > renamed.sc
  $ for f in one_point swapped renamed; do scc check $f.sc 2>/dev/null | grep -E '^[pq]_first'; done
  q_first: holds (exhaustive)
  p_first: violated
  q_first: holds (exhaustive)
  p_first: violated
  q_first: holds (exhaustive)
  p_first: violated

An undecided check over a range has no split step in JSON.

  $ cat > open.sc <<'EOF'
  > param u in [-1/2, 1/2]
  > shape C = box(1,1,1)
  > behaviour P on C = <a, {right}>. omega(a, {right}). eps(1). P
  > behaviour Q on C = <~a, {left}>. omega(a, {left}). eps(1). Q
  > process p = C mass 1 velocity (1,0,0) [P]
  > process q = C mass 2 velocity (-1/2,0,0) at translate (3,u,0) [Q]
  > check c : AF event bounce(p, q)
  > check d : EF[0, 3] bound(p, q)
  > EOF
  $ scc check open.sc --json --depth 1 | grep -E '"(verdict|split_step)"'
        "verdict": "undecided",
        "verdict": "undecided",

The next event over all values: X looks at no more than so many events, within a bound of time as well, and however
late they are. What a run does at the same instant after them does not count.

  $ cat > next.sc <<'EOF'
  > param u in [0, 1]
  > shape C = box(1,1,1)
  > fixed l = C at translate (-4,0,0)
  > fixed r = C at translate (4,0,0)
  > process p = C mass 1 velocity (-1,0,0) at translate (-1 - u,0,0) [nil]
  > process q = C mass 1 velocity (1,0,0) at translate (1 + u,0,0) [nil]
  > check comes : EG[<= 1] EX event bounce
  > EOF
  $ scc check next.sc --where | grep -E '^[a-z]+: |everywhere'
  comes: holds (exhaustive, all u in [0, 1])
    holds everywhere
          everywhere on this run, EX event bounce holds: that is known of all states that it goes through
  explored: 10 states, 10 transitions, depth 5; complete
  $ cat > three.sc <<'EOF'
  > param u in [0, 1]
  > shape C = box(1,1,1)
  > fixed l = C at translate (-3,0,0)
  > fixed r = C at translate (3 + u/3,0,0)
  > process p = C mass 1 velocity (1,0,0) at translate (u,0,0) [nil]
  > process q = C mass 1 velocity (1,7/5,0) at translate (0,40,0) [nil]
  > check a : EX event bounce
  > check b : EF[<= 1] EX event bounce(p, r)
  > check c : EF[<= 4] (event bounce and EX event bounce(p, l))
  > check d : AG[<= 7] (not event bounce(p,r) or EX (event bounce(p,l) and EX event bounce(p,r)))
  > check e : E[true U[1,2] AX event bounce(p, r)]
  > EOF
  $ scc check three.sc | grep -E '^[a-z]+: '
  a: holds (exhaustive, all u in [0, 1])
  b: holds (exhaustive, all u in [0, 1])
  c: holds (exhaustive, all u in [0, 1])
  d: holds (exhaustive, all u in [0, 1])
  e: holds (exhaustive, all u in [0, 1])
  explored: 9 states, 8 transitions, depth 8; complete

Formulas that no search decides are known over all values before all is explored, which here would never end.

  $ (grep -v '^check' three.sc; cat <<'EOF'
  > check a : E[not event bounce U event bounce(p) and EX event bounce(p, l)]
  > check b : EF (event bounce(p, r) and EX event bounce(p, l))
  > check c : A[not event bounce U event bounce(p, r) and AX event bounce(p, l)]
  > check d : AG (event bounce(p, r) or AX event bounce(p, r))
  > check e : EG AX event bounce(p)
  > EOF
  > ) > known.sc
  $ scc check known.sc --depth 30 | grep -E '^[a-z]+: '
  a: holds (exhaustive, all u in [0, 1])
  b: holds (exhaustive, all u in [0, 1])
  c: holds (exhaustive, all u in [0, 1])
  d: violated for u = 1/2
  e: undecided: the exploration ended at the depth bound 30; one unexplored state matters
  explored: 31 states, 30 transitions, depth 30; not complete: stopped by the depth bound 30
  $ scc check known.sc --time 6 | grep -E '^[a-z]+: '
  a: holds (exhaustive, all u in [0, 1])
  b: holds (exhaustive, all u in [0, 1])
  c: holds (exhaustive, all u in [0, 1])
  d: violated for u = 1/2
  e: undecided: the exploration ended at the time bound 6; one unexplored state matters
  explored: 6 states, 5 transitions, depth 5; not complete: stopped by the time bound 6

A bound of time that is over decides where nothing later is explored, beside checks that look further.

  $ (cat next.sc; cat <<'EOF'
  > check a : AG[0, 0] EX time > 0
  > check b : EF[100, 101] (event bounce and EX event bounce)
  > check c : EX time = 2
  > check d : AF[0, 2] (event bounce and EX true)
  > check e : A[true U[0, 2] event bounce and EX event bounce]
  > check f : AF[0, 1] (event bounce and EX true)
  > EOF
  > ) > beside.sc
  $ scc check beside.sc --depth 40 | grep -E '^[a-z]+: '
  comes: holds (exhaustive, all u in [0, 1])
  a: holds (exhaustive, all u in [0, 1])
  b: undecided: the exploration ended at the depth bound 40; one unexplored state matters
  c: violated for u = 1/2
  d: holds (exhaustive, all u in [0, 1])
  e: holds (exhaustive, all u in [0, 1])
  f: violated for u = 1/2
  explored: 49 states, 56 transitions, depth 40; not complete: stopped by the depth bound 40

A bound that is passed far away: what spins is shown there while few turns come before.

  $ cat > turns.sc <<'EOF'
  > shape Cube = box(1,1,1)
  > dynamics constant_spin
  > param until = 20
  > process p = Cube mass 1 velocity (1,0,0) spin (0,0,1) [nil]
  > check near : eventually y(p) >= 1 within until
  > EOF
  $ scc check turns.sc | grep -A 6 'a run'
    a run that violates it:
      then time passes beyond the bound, which ends at time 20
      y(p) >= 1 fails: y(p) = 0
      there:
        p at (20, 0, 0) turned ~(0.717928, 0.000000, 0.000000, 0.282072) [nil], velocity (1, 0, 0), spin (0, 0, 1)
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  $ scc check turns.sc -D until=1e24 | grep -A 6 'a run'
    a run that violates it:
      then time passes beyond the bound, which ends at time 1000000000000000000000000; until then bodies turn too often for the state there to be shown
      y(p) >= 1 fails: y(p) = 0
      before that, in the last state:
        p at (0, 0, 0) [nil], velocity (1, 0, 0), spin (0, 0, 1)
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
