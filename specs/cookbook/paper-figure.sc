model paper_figure

behaviour Hand = <grip, {right}>. nil
behaviour Bar  = <~grip, {left}>. nil

process hand = box(1, 2, 2) mass 1 velocity (1, 0, 0) [Hand]
process bar  = prism(6, 1, 4) mass 2 at translate (6, 0, 0) * rotate quaternion (1, 0, 1, 0) [nil]
process block = box(2, 2, 2) mass 1 at translate (3, 0, 0) [Bar]

check grips : eventually bound(hand, block)
