// n dimers side by side, each of which may release its bond at any split
// instant from time 1 on, up to time 4, when it must react: nothing meets,
// and all that is explored is the interleaving.
model dimers

param n = 4
timestep 1
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Left  on Cube = eps(1). omega(link, {right}). nil + eps(4). rho({<link, {right}>}). nil
behaviour Right on Cube = eps(1). omega(link, {left}). nil + eps(4). rho({<link, {left}>}). nil

for i in 1..n {
  process l[i] = Cube mass 1 at translate (0, 4*i, 0) [Left]
  process r[i] = Cube mass 1 at translate (2, 4*i, 0) [Right]
  bond <link, {l[i].right, r[i].left}>
}
