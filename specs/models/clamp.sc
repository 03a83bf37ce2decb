// A clamp drawn as one concave body, which `decompose` makes a compound of convex parts: three bars of a C.
//
// Its faces keep the names that they have in the drawing. `inner` is the floor between the jaws: a ball that flies in
// between them binds there, and one that comes to the tip of a jaw bounces off. `front0` is the C itself, which the
// file has in triangles and which three bars share: a coin that lands on any of them binds.
model clamp

compound Clamp = decompose "parts/clamp.obj" mass 60

behaviour Open on Clamp = <dock, {inner}>. Open + <coin, {front0}>. Open

process clamp = Clamp [Open]
process ball  = box(2, 2, 2) mass 1 velocity (-1, 0, 0) at translate (20, 1, 3) [<~dock, {left}>. nil]
process stray = box(1, 1, 1) mass 1 velocity (-3, 0, 0) at translate (12, 1, 1/2) [<~dock, {left}>. nil]
process coin  = box(1, 1/2, 1/2) mass 1 velocity (0, 1, 0) at translate (1, -10, 11/2) [<~coin, {back}>. nil]

check weighs   : always momentum.x = -4 and momentum.y = 1     // expect: holds
check catches  : eventually bound(clamp, ball)                 // expect: holds
check at_floor : AG (event bind(dock) => x(ball) - x(clamp) = -3/8) // expect: holds
check bounces  : eventually event bounce(clamp, stray)         // expect: holds
check no_tip   : always not bound(clamp, stray)                // expect: holds
check any_bar  : eventually bound(clamp, coin)                 // expect: holds
check one_way  : possibly bonds(dock) > 1                      // expect: violated
