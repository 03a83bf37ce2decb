// The first step of glycolysis in a cell: hexokinase, at both ends of it, takes ATP and glucose and makes ADP and
// glucose-6-phosphate of them. Two of each wander, ATP in one lane and glucose in the other, each of which leads to a
// pocket of either enzyme. An enzyme binds them in any order; what waits for the other may be lost, at a rate; once both are there they
// react, in one strong split. What has been made stays in the cell, and in the way of the others.
//
// So an enzyme works only once: its product does not get out of the lane, and the other substrates do not get past it. With one
// enzyme (-D enzymes=1) half of the glucose is never used. With two of them the first product is there after 2.59 on the
// average, and after 6.13 with one.
model glycolysis

timestep 1 steady

import <solids>

param enzymes = 2

compound Hexokinase {
  part a : solids.Cube(1) mass 1
  part b : solids.Cube(1) mass 1 at translate (0, -1, 0)
  glue a.front ~ b.back
}

behaviour Empty       on Hexokinase = <~atp, {only a.left}> . WithAtp + <~glc, {only b.left}> . WithGlucose
behaviour WithAtp     on Hexokinase = <~glc, {only b.left}> . Both + omega(atp, {a.left}) rate 1/10 . Empty
behaviour WithGlucose on Hexokinase = <~atp, {only a.left}> . Both + omega(glc, {b.left}) rate 1/10 . Empty
behaviour Both        on Hexokinase = rho({<atp, {a.left}>, <glc, {b.left}>}) . Empty

// Either end of a substrate fits.
behaviour Atp     on solids.Cube(1) = <atp, {only left}> . AtLeft(atp, Atp, Adp) + <atp, {only right}> . AtRight(atp, Atp, Adp)
behaviour Glucose on solids.Cube(1) = <glc, {only left}> . AtLeft(glc, Glucose, G6p) + <glc, {only right}> . AtRight(glc, Glucose, G6p)
behaviour AtLeft(c, As, Product)  = omega(c, {left}) . As + rho({<c, {left}>}) . Product
behaviour AtRight(c, As, Product) = omega(c, {right}) . As + rho({<c, {right}>}) . Product
behaviour Adp = nil
behaviour G6p = nil

fixed cell = solids.Room(7, 2, 1, 1)
for i in 1..enzymes {
  fixed e[i] = Hexokinase at translate (if i = 1 then 3 else -3, 1/2, 0) * rotate quaternion (if i = 1 then (1) else (0), 0, if i = 1 then (0) else (1), 0) [Empty]
}
for i in 1..2 {
  process atp[i]     = solids.Cube(1) mass 1 at translate (2*i - 3, 1/2, 0) [Atp]
  process glucose[i] = solids.Cube(1) mass 1 at translate (2*i - 3, -1/2, 0) [Glucose]
  motion  atp[i]     = choose { (1, 0, 0), (-1, 0, 0) }
  motion  glucose[i] = choose { (1, 0, 0), (-1, 0, 0) }
}

let adp = count(i in 1..2: behaviour(atp[i]) = Adp)
let g6p = count(i in 1..2: behaviour(glucose[i]) = G6p)

check possible  : possibly g6p = 2                                                                               // expect: holds
check no_waste  : always adp = g6p                                                                               // expect: holds
check both_work : EF event strong(atp, e[1]) and EF event strong(atp, e[2])                                     // expect: holds
check again     : EF (event strong(atp, e[1]) and EX EF event strong(atp, e[1]))                                 // expect: violated
check loses     : possibly event weak(atp)                                                                       // expect: holds
check surely    : P >= 1 [ eventually g6p = 2 ]                                                                  // expect: holds
check first     : E <= 26/10 [ time U g6p >= 1 ]                                                                 // expect: holds
check second    : E <= 8 [ time U g6p = 2 ]                                                                      // expect: holds
