// Receptors with two sites: an agonist at the upper one opens the lower one, to which effectors bind.
model allostery
timestep 1 steady
split_step 1
blocked wait
collisions drawn
import <solids>
param n = 10
let rs = ceil(n/4)
let long = 8*rs + 1
behaviour Shut = <ago, {only back}> . Open
behaviour Open = <eff, {only front}> . Active + omega(ago, {only back}) . Shut
behaviour Active = nil
behaviour Agonist  = <~ago, {only front}> . AgonistOn
behaviour AgonistOn = omega(ago, {only front}) rate 1/8 . Agonist
behaviour Effector = <~eff, {only back}> . nil
fixed room = solids.Room(long, 7, 1, 1)
for i in 1..rs {
  let x0 = 8*(i - 1) - 4*(rs - 1)
  fixed rec[i] = solids.Cube(1) at translate (x0, 0, 0) [Shut]
  for k in 0..1 {
    process ago[i, k] = solids.Cube(1) mass 1 at translate (x0 - 2 + 4*k, 2, 0) [Agonist]
    process eff[i, k] = solids.Cube(1) mass 1 at translate (x0 - 2 + 4*k, -2, 0) [Effector]
  }
}
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check active_at_40 : E = ? [ count(r in rec: behaviour(r) = Active) at 40 ]
check first_by_40  : P = ? [ eventually behaviour(rec[1]) = Active within 40 ]
