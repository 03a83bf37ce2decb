model turning

dynamics free_body

behaviour Arm  = <catch, {right, left}>. nil
behaviour Post = <~catch, {bottom}>. nil

process arm  = box(4, 1, 1) mass 1 spin (0, 0, 1/2) [Arm]
fixed   post = box(1, 1, 1) at translate (0, 2, 0) [Post]

check touches : eventually touching(arm, post) within 4
check back    : AG (event bounce(arm, post) => wz(arm) < 0)
