open Scc_exact
open Scc_geometry
open Scc_mesh

(* No corner of the hull, and so no point of the cloud, is that far in front of a face. *)
let holds ~tolerance (hull : Polyhedron.ifs) (solid : Polyhedron.ifs) =
  let tolerance2 = Rat.mul tolerance tolerance in
  let behind (_, corners) =
    let at k = snd solid.ifs_vertices.(corners.(k)) in
    let normal = Vec.cross (Vec.sub (at 1) (at 0)) (Vec.sub (at 2) (at 0)) in
    let most = Rat.mul tolerance2 (Vec.norm2 normal) in
    Array.for_all
      (fun (_, p) ->
         let height = Vec.dot normal (Vec.sub p (at 0)) in
         Rat.sign height <= 0 || Rat.compare (Rat.mul height height) most <= 0)
      hull.ifs_vertices
  in
  Array.for_all behind solid.ifs_faces

(* What is rounded by as much as vertices may move is bent by more in a plane that is but guessed; where faces are
   small, less is better. *)
let bends = [ 2.; 1.; 0.5 ]

let snap ~tolerance hull =
  let attempt bend =
    let set = Hull_of.flattened ~within:(bend *. Rat.to_float tolerance) hull in
    match Snap.snap ~tolerance set with
    | Ok found when holds ~tolerance hull found.set -> Ok found
    | Ok _ -> Error (Snap.Not_found [], set)
    | Error refusal -> Error (refusal, set)
  in
  let rec first refused = function
    | [] -> Error refused
    | bend :: rest -> (
        match attempt bend with
        | Ok found -> Ok found
        | Error _ -> first refused rest)
  in
  match attempt (List.hd bends) with
  | Ok found -> Ok found
  | Error refused -> first refused (List.tl bends)
