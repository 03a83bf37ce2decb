// n dimers that spin side by side, each of which may release its bond at any split instant from time 1 on: nothing meets,
// and what is explored is the interleaving, of bodies that turn.
model spinners

param n = 4
timestep 1/4
split_step 1
round orientation 2^-20

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Left  on Cube = eps(1). omega(link, {right}). nil
behaviour Right on Cube = eps(1). omega(link, {left}). nil

for i in 1..n {
  process d[i] = l[i] : Cube mass 1 spin (1/4,0,0) at translate (0, 20*i, 0) [Left]
                 <link, {l[i].right, r[i].left}>
                 r[i] : Cube mass 1 spin (1/4,0,0) at translate (2, 20*i, 0) [Right]
}
