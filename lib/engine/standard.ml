open Scc_broad_phase
open Scc_semantics

(* A leaf whose law is another one than when it was asked belongs to another model ({!Semantics.with_model}). *)
let laws () : Kinematics.laws =
  let known = Hashtbl.create 16 in
  fun leaf law ask ->
    match Hashtbl.find_opt known leaf with
    | Some (same, shares) when same == law -> shares
    | Some _ | None ->
      let shares = ask () in
      Hashtbl.replace known leaf (law, shares);
      shares

let of_model model =
  let memory = Obstacle_cache.create () in
  let geometry = Geometry.exact ~obstacle:(Obstacle_cache.find memory) in
  Semantics.make ~geometry ~neighbours:Neighbours.boxes ~laws:(laws ()) model
