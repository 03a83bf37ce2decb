// An enzyme for each ten bodies along a wall; half of the n bodies are substrate, half a competitive inhibitor.
model enzyme
timestep 1 steady
split_step 1
blocked wait
collisions drawn
import <solids>
param n = 10
param k = 1/2
let sites = ceil(n/10)
let long = 11*sites
behaviour Enzyme  = <sub, {only front}> . Holds + <inh, {only front}> . Blocked
behaviour Holds   = omega(sub, {only front}) . Enzyme
behaviour Blocked = omega(inh, {only front}) . Enzyme
behaviour Substrate = <~sub, {only back}> . AtWork
behaviour AtWork    = omega(sub, {only back}) rate k . Product
behaviour Product   = nil
behaviour Inhibitor = <~inh, {only back}> . Blocking
behaviour Blocking  = omega(inh, {only back}) rate (k/4) . Inhibitor
fixed room = solids.Room(long, 5, 1, 1)
for i in 1..sites { fixed enzyme[i] = solids.Cube(1) at translate (11*(i - 1) - (long - 11)/2, 2, 0) [Enzyme] }
for i in 1..n if i mod 2 = 0 { process s[i] = solids.Cube(1) mass 1
  at translate (i - long/2, -2, 0) [Substrate] }
for i in 1..n if i mod 2 = 1 { process h[i] = solids.Cube(1) mass 1
  at translate (i - long/2, 0, 0) [Inhibitor] }
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
let made = count(p in s: behaviour(p) = Product)
check product : E = ? [ made at 40 ]
check first   : P = ? [ eventually made >= 1 within 20 ]
