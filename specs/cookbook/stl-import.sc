model stl_import

shape Wedge = mesh "wedge.stl" weld orient merge

behaviour Key  = <fit, {f3}>. nil
behaviour Hole = <~fit, {left}>. nil

process wedge  = Wedge mass 1 velocity (1, 0, 0) [Key]
fixed   socket = box(1, 4, 4) at translate (6, 1, 1) [Hole]

check fits : eventually bound(wedge, socket)
