open Scc_exact
open Scc_geometry

type outcome = Never | At of Algebraic.t

let first_penetration _ _ ~from:_ ~until:_ = Scc_base.Bug.fail __POS__ "not there yet"

let relation a b t =
  let a, at = Motion.placed a t and b, bt = Motion.placed b t in
  Obstacle.relation (Obstacle.make a b) (Vec.sub bt at)
