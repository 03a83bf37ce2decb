The canonical layout: comments stay, formatting twice changes nothing.

  $ cat > model.sc <<'END'
  > // a cube that drifts
  > model   drift
  > param n=2 // how far
  > 
  > 
  > shape Cube { vertices a (-1,-1,-1) b (1,-1,-1) c (1,1,-1) d (-1,1,-1) e (-1,-1,1) f (1,-1,1) g (1,1,1) h (-1,1,1) faces bottom [a,d,c,b] top [e,f,g,h] left [a,e,h,d] right [b,c,g,f] front [a,b,f,e] back [d,h,g,c] }
  > /* the only body */
  > process p=Cube mass (1/2) velocity (1,0,0) [ε(1/2). ⟨a, {top}⟩. nil]
  > check far:possibly x(p)>n
  > END
  $ scc fmt model.sc | tee once.sc
  // a cube that drifts
  model drift
  param n = 2 // how far
  
  shape Cube {
    vertices a (-1, -1, -1)  b (1, -1, -1)  c (1, 1, -1)  d (-1, 1, -1)  e (-1, -1, 1)  f (1, -1, 1)
             g (1, 1, 1)  h (-1, 1, 1)
    faces    bottom [a, d, c, b]  top [e, f, g, h]  left [a, e, h, d]  right [b, c, g, f]
             front [a, b, f, e]  back [d, h, g, c]
  }
  /* the only body */
  process p = Cube mass 1/2 velocity (1, 0, 0) [eps(1/2). <a, {top}>. nil]
  check far : possibly x(p) > n
  $ scc fmt once.sc | cmp - once.sc
  $ scc fmt --check once.sc
  $ scc fmt --check model.sc once.sc
  model.sc
  [1]
  $ cp model.sc rewritten.sc
  $ scc fmt --inplace rewritten.sc && cmp rewritten.sc once.sc
  $ scc fmt - < model.sc | cmp - once.sc

The meaning stays.

  $ scc check model.sc
  model.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  semantics 3
  
  far: holds (exhaustive)
    possibly x(p) > n
    a run that shows it:
      1. time passes by 1/2, to time 1/2
      then time passes: right after time 2, for example at time 3
      x(p) > 2 holds: x(p) = 3
      there:
        p at (3, 0, 0) [<a, {top}>. nil], velocity (1, 0, 0)
  
  explored: 2 states, 1 transition, depth 1, model time 1/2; complete
  1 property: 1 holds
  $ scc check once.sc > /dev/null
  once.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be

Every model of the examples can be formatted, and the result again without change.

  $ for model in ../../specs/models/*.sc; do
  >   scc fmt $model > formatted.sc && scc fmt --check formatted.sc || echo $model
  > done

What cannot be read or written.

  $ scc fmt nowhere.sc
  nowhere.sc: error[SC0101]: cannot read: No such file or directory
  [3]
  $ echo 'process p = ' > broken.sc
  $ scc fmt --inplace broken.sc
  broken.sc:2:1: error[SC0110]: the text ends here: expected a leaf such as `Cube mass 1 [B]` or `q : Cube mass 1 [B]`
     |
   2 | 
     | ^
  [3]
  $ cat broken.sc
  process p = 
  $ scc fmt 2> /dev/null
  [64]
