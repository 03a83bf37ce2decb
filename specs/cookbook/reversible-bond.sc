model reversible_bond

timestep 1 steady

import <solids>

behaviour Free  = <site, {right}>. Held
behaviour Held  = omega(site, {right}) chance 1/4. Free
behaviour Site  = <~site, {left}>. Taken
behaviour Taken = omega(site, {left}). Site

fixed   wall     = solids.Cube(1) at translate (-2, 0, 0)
process ligand   = solids.Cube(1) mass 1 [Free]
fixed   receptor = solids.Cube(1) at translate (2, 0, 0) [Site]

motion ligand = choose { (1, 0, 0), (-1, 0, 0) }

check again : AG EF event bind(site)
check life  : AG (event bind(site) => P >= 3/4 [ eventually event weak(site) within 6 ])
check held  : E = ? [ if bound(ligand, receptor) then 1 else 0 at 20 ]
