// walkers that do not bounce, where bodies turn
dynamics free_body
blocked wait
process p = box(1, 1, 1) mass 1 [nil]
motion p = choose { (1,0,0), (-1,0,0) }
