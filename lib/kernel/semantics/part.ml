open Scc_exact
open Scc_rigid
open Scc_calculus

type t = {
  process : int;
  owner : State.process;
  leaf : State.leaf;
  index : int;
  placed : Placed.t;
  centre : Vec.t;
}

let name p = (p.leaf.leaf, p.index)
let velocity p = p.owner.velocity
let turns p = not (Vec.is_zero p.owner.spin)
let relative_velocity a b = Vec.sub b.owner.velocity a.owner.velocity

let in_relative_motion a b =
  a.process <> b.process
  && ((not (Vec.equal a.owner.velocity b.owner.velocity)) || turns a || turns b)

(* Whoever moves as the first does, without turning, moves as all others that do. *)
let move_alike parts = Array.for_all (fun p -> not (in_relative_motion parts.(0) p)) parts

let reach p = Speed.reach p.placed.solid (Vec.sub (Placed.centroid p.placed) p.centre)
