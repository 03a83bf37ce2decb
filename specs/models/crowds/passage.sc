// Crowded first passage: a tracer looks for a target along the far side of a floor, among n obstacles that walk too.
model passage
timestep 1 steady
blocked wait
collisions drawn
import <solids>
param n = 10
let long = 2*ceil(n/3) + 1
behaviour Tracer = <dock, {only back}> . nil
behaviour Target = <~dock, {only front}> . nil
fixed room   = solids.Room(long, 7, 1, 1)
fixed target = box(long, 1, 1) at translate (0, 3, 0) [Target]
process tracer = solids.Cube(1) mass 1 at translate (0, -3, 0) [Tracer]
for i in 1..n {
  process o[i] = solids.Cube(1) mass 1
    at translate (2*floor((i - 1)/3) - (long - 1)/2 + 1, 2*((i - 1) mod 3) - 2, 0) [nil]
}
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check by_40 : P = ? [ eventually bound(tracer, target) within 40 ]
check seen_at_40 : E = ? [ if bound(tracer, target) then 1 else 0 at 40 ]
