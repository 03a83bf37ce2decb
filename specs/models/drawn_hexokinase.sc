// Hexokinase as it was drawn: the silhouette of parts/hexokinase.svg, inflated to a solid and cut into convex parts. scripts/drawing
// makes all of it from the drawing. Glucose flies into the cleft between the two lobes and binds at its innermost edge; ATP comes
// from above and binds to the crown of the upper lobe. Both react in one strong split, as in hexokinase.sc.
model drawn_hexokinase

param atp_arrives = 2
param glucose_arrives = 2
split_step 1

compound Enzyme = decompose "parts/hexokinase.obj" mass 1

behaviour Empty       on Enzyme = <~atp, {[v8, v9]}>. WithAtp + <~glc, {[v5, v6]}>. WithGlucose
behaviour WithAtp     on Enzyme = <~glc, {[v5, v6]}>. Both + omega(atp, {[v8, v9]}). Empty
behaviour WithGlucose on Enzyme = <~atp, {[v8, v9]}>. Both + omega(glc, {[v5, v6]}). Empty
behaviour Both        on Enzyme = rho({<atp, {[v8, v9]}>, <glc, {[v5, v6]}>}). Empty
                                + omega(atp, {[v8, v9]}). WithGlucose
                                + omega(glc, {[v5, v6]}). WithAtp

shape Substrate = box(1/4, 1/4, 1/4)
behaviour Atp          on Substrate = <atp, {front}>. AtpBound
behaviour AtpBound     on Substrate = omega(atp, {front}). Atp + rho({<atp, {front}>}). Adp
behaviour Adp          on Substrate = nil
behaviour Glucose      on Substrate = <glc, {left}>. GlucoseBound
behaviour GlucoseBound on Substrate = omega(glc, {left}). Glucose + rho({<glc, {left}>}). G6p
behaviour G6p          on Substrate = nil

fixed   enzyme  = Enzyme [Empty]
process atp     = Substrate mass 5 velocity (0, -1, 0) at translate (0, 2 + atp_arrives, 0) [Atp]
process glucose = Substrate mass 2 velocity (-1, 0, 0) at translate (2 + glucose_arrives, 1/8, 0) [Glucose]

let reacted = behaviour(atp) = Adp and behaviour(glucose) = G6p

check reaction  : possibly reacted                                                    // expect: holds
check in_cleft  : AG (event bind(glc) => x(glucose) < 0)                              // expect: holds
check together  : always (behaviour(atp) = Adp => behaviour(glucose) = G6p)           // expect: holds
check at_most   : always bonds(atp) <= 1 and bonds(glc) <= 1                          // expect: holds
check surely    : eventually reacted                                                  // expect: violated
