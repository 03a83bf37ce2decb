model competition

timestep 1 steady
blocked wait
collisions drawn

import <solids>

param head_start = 1

behaviour Drug  = <site, {left}>. nil
behaviour Rival = <site, {right}>. nil
behaviour Site  = <~site, {left, right}>. nil

process drug     = solids.Cube(1) mass 1 at translate (3 + head_start, 0, 0) [Drug]
process rival    = solids.Cube(1) mass 1 at translate (-3, 0, 0) [Rival]
fixed   receptor = solids.Cube(1) [Site]
fixed   room     = solids.Room(11, 1, 1, 1)

motion choose { (1, 0, 0), (-1, 0, 0) }

check drug_wins  : P = ? [ eventually event bind(site, drug) ]
check rival_wins : P = ? [ eventually event bind(site, rival) ]
