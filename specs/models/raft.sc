// A raft of two cubes that drifts, and may come apart at any whole time, or never. Nothing depends on where it
// is, so that what differs by a translation of everything is one state (rule Translation). With
// `--no-reduce translation` it is somewhere else at each split instant, and the exploration never ends.
model raft

split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Held = omega(rope, {left, right}). nil

process raft = p : Cube mass 1 velocity (1,0,0) at translate (0,0,0) [Held] <rope, {p.right, q.left}>
               q : Cube mass 1 velocity (1,0,0) at translate (2,0,0) [Held]

check breaks  : possibly bonds(rope) = 0                       // expect: holds
check surely  : eventually bonds(rope) = 0                     // expect: violated
check side    : always distance2(p, q) = 4 and vx(p) = 1       // expect: holds
check anytime : AG (bound(p, q) => EF[1, 3] event weak(rope))  // expect: holds
