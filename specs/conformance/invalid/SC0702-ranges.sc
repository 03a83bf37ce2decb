// implications whose left sides hold for no values of a parameter and at no instant of a split (warnings), and some that
// hold for some of them, or later
split_step any
param y in [0, 6]
shape Cube = box(2,2,2)
behaviour Free  on Cube = <a, {right}>. Bound
behaviour Bound on Cube = omega(a, {right}). eps(1). nil
behaviour Other on Cube = <~a, {left}>. Held
behaviour Held  on Cube = omega(a, {left}). nil
process p = Cube mass 1 velocity (1,0,0) at translate (0,y,0) [Free]
process q = Cube mass 1 at translate (12,0,0) [Other]
process r = Cube mass 1 at translate (12,40,0) [nil]
check some    : always (bound(p, q) => y < 2)
check never   : always (touching(p, r) => y < 3)
check lead    : event bounce(p, r) leads_to event weak(a)
check parts   : always (event weak(a) => y < 2)
check early   : always (bound(p, q) => y < 1) within 5
check late    : always (bound(p, q) => y < 2) within 15
check broken  : (always (bound(p, q) => y < 1)) and (always (bound(p, r) => y < 1))
