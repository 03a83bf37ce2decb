model trajectory

behaviour Free  = <hook, {right}>. nil
behaviour Eye   = <~hook, {left}>. nil

process p = box(1, 1, 1) mass 3 velocity (1, 0, 0) [Free]
process q = box(1, 1, 1) mass 1 velocity (-1, 0, 0) at translate (5, 0, 0) [Eye]

check joined : eventually bound(p, q)
