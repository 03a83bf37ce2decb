model rates

split_step 1/10

import <solids>

behaviour Complex  = omega(site, {right}) rate 3. Enzyme + omega(site, {right}) rate 1. Spent
behaviour Enzyme   = nil
behaviour Spent    = nil
behaviour Substrate = omega(site, {left}). nil

process enzyme    = solids.Cube(1) mass 1 [Complex]
process substrate = solids.Cube(1) mass 1 at translate (1, 0, 0) [Substrate]
bond <site, {enzyme.right, substrate.left}>

check converts : P = ? [ eventually behaviour(enzyme) = Spent ]
check soon     : P >= 9/10 [ eventually not bound(enzyme, substrate) within 1 ]
