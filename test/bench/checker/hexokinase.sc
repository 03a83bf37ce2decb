// Hexokinase with n substrates, ATP and glucose in turns: as specs/models/hexokinase.sc,
// in a closed box. They come down on the pockets from above, from the front and from
// behind, one after another. Who finds its pocket taken bounces off, or throws out who
// is in there loose, flies about in the box, and comes again. All masses are equal and
// all places on a grid, so that velocities are only handed on, places recur, and there
// are finitely many states.
model hexokinase

param n = 2
timestep 1
split_step 1

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
shape Floor = Cube scaled (5/2, 1/2, 1)
shape Post  = Cube scaled (1/2, 1, 1)

compound Enzyme {
  part floorA : Floor mass 1 at translate (-5/2, -1/2, 0)
  part floorB : Floor mass 1 at translate (5/2, -1/2, 0)
  part postA  : Post  mass 1 at translate (-9/2, 1, 0)
  part postM  : Post  mass 1 at translate (0, 1, 0)
  part postB  : Post  mass 1 at translate (9/2, 1, 0)
  glue floorA.right ~ floorB.left
  glue postA.bottom ~ floorA.top
  glue postM.bottom ~ floorA.top
  glue postB.bottom ~ floorB.top
}

behaviour Empty       on Enzyme = <~atp, {floorA.top}>. WithAtp + <~glc, {floorB.top}>. WithGlucose
behaviour WithAtp     on Enzyme = <~glc, {floorB.top}>. Both + omega(atp, {floorA.top}). Empty
behaviour WithGlucose on Enzyme = <~atp, {floorA.top}>. Both + omega(glc, {floorB.top}). Empty
behaviour Both        on Enzyme = rho({<atp, {floorA.top}>, <glc, {floorB.top}>}). Empty
                                + omega(atp, {floorA.top}). WithGlucose
                                + omega(glc, {floorB.top}). WithAtp

behaviour Atp          on Cube = <atp, {bottom}>. AtpBound
behaviour AtpBound     on Cube = omega(atp, {bottom}). Atp + rho({<atp, {bottom}>}). Adp
behaviour Adp          on Cube = nil
behaviour Glucose      on Cube = <glc, {bottom}>. GlucoseBound
behaviour GlucoseBound on Cube = omega(glc, {bottom}). Glucose + rho({<glc, {bottom}>}). G6p
behaviour G6p          on Cube = nil

// The box: x in [-5, 5], z in [-4, 4], y from the underside of the enzyme to a ceiling that makes room for all.
let top = 4 + 2*n
fixed enzyme  = Enzyme [Empty]
fixed bottom  = Cube scaled (5, 1, 4) at translate (0, -2, 0)
fixed ceiling = Cube scaled (5, 1, 4) at translate (0, top + 1, 0)
fixed left    = Cube scaled (1, (top + 1)/2, 4) at translate (-6, (top - 1)/2, 0)
fixed right   = Cube scaled (1, (top + 1)/2, 4) at translate (6, (top - 1)/2, 0)
fixed back    = Cube scaled (5, (top + 1)/2, 1) at translate (0, (top - 1)/2, -5)
fixed front   = Cube scaled (5, (top + 1)/2, 1) at translate (0, (top - 1)/2, 5)

let atps = round(n/2, 1)
// The first comes from above, the next from the front, the next from behind, and so on.
for i in 1..atps {
  process atp[i] = Cube mass 1 velocity (0, -1, (if i = 1 then 0 else if 2*round(i/2, 1) = i then -1 else 1))
      at translate (-9/4, 4*i - 1, (if i = 1 then 0 else if 2*round(i/2, 1) = i then 2 else -2)) [Atp]
}
for i in 1..n - atps {
  process glucose[i] = Cube mass 1 velocity (0, -1, (if i = 1 then 0 else if 2*round(i/2, 1) = i then 1 else -1))
      at translate (9/4, 4*i - 1, (if i = 1 then 0 else if 2*round(i/2, 1) = i then -2 else 2)) [Glucose]
}

check together : always bonds(atp) <= 1 and bonds(glc) <= 1          // expect: holds
