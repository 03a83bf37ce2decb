// Hexokinase: an enzyme with two pockets takes ATP and glucose and turns them
// into ADP and glucose-6-phosphate.
//
// The enzyme is a compound of two floors and three posts, fixed in a
// membrane. ATP falls into pocket A, glucose into pocket B, in either order
// (both arrive at once by default; -D glucose_arrives=3 lets ATP be first).
// Each may be released again by a weak split; once both are bound, both bonds
// react in one strong split.
model hexokinase

param atp_arrives = 2
param glucose_arrives = 2
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

fixed   enzyme  = Enzyme [Empty]
process atp     = Cube mass 5 velocity (0,-1,0) at translate (-9/4, 1 + atp_arrives, 0) [Atp]
process glucose = Cube mass 2 velocity (0,-1,0) at translate (9/4, 1 + glucose_arrives, 0) [Glucose]

let reacted = behaviour(atp) = Adp and behaviour(glucose) = G6p

check reaction   : possibly reacted                                            // expect: holds
check in_time    : possibly reacted within 3                                   // expect: holds
check together   : always (behaviour(atp) = Adp => behaviour(glucose) = G6p)   // expect: holds
check at_most    : always bonds(atp) <= 1 and bonds(glc) <= 1                  // expect: holds
check full       : possibly size(enzyme) = 7                                   // expect: holds
check surely     : eventually reacted                                          // expect: violated
check releases   : possibly behaviour(atp) = Atp and vy(atp) = 0                // expect: holds
check in_pocket  : always x(atp) = -9/4 and y(atp) >= 1                        // expect: holds
