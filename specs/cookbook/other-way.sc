model other_way

behaviour Enzyme = <~site, {left}>. eps(1). rho({<site, {left}>}). nil + <~site, {left}>. nil
behaviour Ligand = <site, {right}>. (rho({<site, {right}>}). Product)
behaviour Product = nil

process ligand = box(2, 2, 2) mass 1 velocity (1, 0, 0) [Ligand]
fixed   enzyme = box(2, 2, 2) at translate (5, 0, 0) [Enzyme]

check reacts : eventually behaviour(ligand) = Product
