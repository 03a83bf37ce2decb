open Scc_exact
open Scc_rigid

type t = { process : int; leaf : int; index : int; placed : Placed.t; motion : Motion.t }

let name p = (p.leaf, p.index)
let relative_velocity a b = Vec.sub b.motion.velocity a.motion.velocity

let in_relative_motion a b =
  a.process <> b.process
  && ((not (Vec.equal a.motion.velocity b.motion.velocity)) || Motion.turns a.motion || Motion.turns b.motion)

let reach p = Speed.reach p.motion.solid (Vec.sub (Placed.centroid p.placed) p.motion.centre)
