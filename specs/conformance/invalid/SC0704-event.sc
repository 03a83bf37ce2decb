// events that no behaviour can bring about (warnings), and some that are only not met
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour Dock  = <dock, {right}>. nil + <clip, {right}>. Bound
behaviour Clip  = <~clip, {left}>. Bound
behaviour Bound = omega(clip, {left, right}). nil
process p = Cube mass 1 velocity (1,0,0) [Dock]
process q = Cube mass 1 velocity (-1,0,0) at translate (6,0,0) [Clip]
check unopened  : always not event bind(dock)
check opened    : always not event bind(clip, q)
check no_strong : always not event strong(clip)
check weak      : always not event weak(clip)
check bounce    : always not event bounce
