open Scc_broad_phase
open Scc_calculus
open Scc_semantics

(* A leaf whose law is another one than when it was asked belongs to another model ({!Semantics.with_model}). One
   statement gives its law to many leaves, and then they have one answer in memory. *)
let laws (model : Model.t) : Kinematics.laws =
  let known = Array.make (Array.length model.leaves) None and last = ref None in
  fun leaf law ask ->
    match (known.(leaf), !last) with
    | Some (same, shares), _ when same == law -> shares
    | _, Some (same, shares) when same == law ->
      known.(leaf) <- !last;
      shares
    | _ ->
      let shares = ask () in
      if Law.is_constant law then begin
        last := Some (law, shares);
        known.(leaf) <- !last
      end;
      shares

let of_model model =
  let memory = Obstacle_cache.create () in
  let geometry = Geometry.exact ~obstacle:(Obstacle_cache.find memory) in
  let geometry =
    match model.Model.rigid with
    | None when Model.stops_walkers model ->
      let known = Path_cache.create () in
      { geometry with paths = Path_cache.find known geometry.paths }
    | None -> geometry
    | Some _ ->
      let casts = Cast_cache.create () in
      { geometry with first_penetration = Cast_cache.find casts geometry.first_penetration }
  in
  let memo = Process_cache.create () in
  Semantics.make ~geometry ~neighbours:(Neighbours.boxes ()) ~laws:(laws model) ~memo model
