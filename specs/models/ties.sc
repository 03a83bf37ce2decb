// Two walkers on either side of a site in a row of five places. The site binds the first one that runs into it. Both may
// do so at one instant, and then chance decides (rule Ties). Without `collisions drawn` that is a free choice, and the
// probability that the near walker binds is from 7/12 to 2/3. By hand: the near walker binds at once with 1/2. Else it
// steps back, and the far one binds with 1/2 or waits at the wall. If it waits, both are far, and each binds with 1/2.
model ties

timestep 1 steady
blocked wait
collisions drawn

import <solids>

shape Body = solids.Cube(1)

behaviour Site on Body = <a, {left, right}>. nil
behaviour Key  on Body = <~a, {left, right}>. nil

fixed room = solids.Room(5, 1, 1, 1)
fixed site = Body [Site]
process near = Body mass 1 at translate (-1, 0, 0) [Key]
process far  = Body mass 1 at translate (2, 0, 0) [Key]

motion choose { (1, 0, 0), (-1, 0, 0) }

check near_binds : P = ? [ eventually bound(near, site) ]                 // expect: 5/8
check one_binds  : P = ? [ eventually bonds(a) = 1 ]                      // expect: 1
check no_choice  : P <= 5/8 [ eventually bound(near, site) ]              // expect: holds
check takes      : E = ? [ time U bonds(a) = 1 ]                          // expect: 5/6
