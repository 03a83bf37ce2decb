open Scc_exact
open Scc_geometry

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)

let on_a_line set corners =
  let first = place set corners.(0) in
  match List.find_opt (fun v -> not (Vec.equal (place set v) first)) (Array.to_list corners) with
  | None -> true
  | Some other ->
    let along = Vec.sub (place set other) first in
    Array.for_all (fun v -> Vec.is_zero (Vec.cross along (Vec.sub (place set v) first))) corners

let is_sliver (set : Polyhedron.ifs) f =
  let corners = snd set.ifs_faces.(f) in
  Array.length corners >= 3 && on_a_line set corners

let sides corners =
  let n = Array.length corners in
  List.init n (fun k -> (corners.(k), corners.((k + 1) mod n)))

(* The face along each directed edge; None when several run along it. *)
let directed (set : Polyhedron.ifs) =
  let table = Hashtbl.create 1024 in
  let add f side = Hashtbl.replace table side (if Hashtbl.mem table side then None else Some f) in
  Array.iteri (fun f (_, corners) -> List.iter (add f) (sides corners)) set.ifs_faces;
  table

(* The corners strictly between two points of their line, from the first one on. *)
let between set corners u v =
  let from = place set u in
  let along = Vec.sub (place set v) from in
  let far w = Vec.dot along (Vec.sub (place set w) from) in
  let length = Vec.norm2 along in
  let inside (d, _) = Rat.sign d > 0 && Rat.compare d length < 0 in
  let found = List.filter inside (List.map (fun w -> (far w, w)) (Array.to_list corners)) in
  List.map snd (List.sort_uniq (fun (d, _) (e, _) -> Rat.compare d e) found)

(* One round: faces that are next to each other do not go in the same one. *)
let round (set : Polyhedron.ifs) slivers =
  let table = directed set in
  let gone = Hashtbl.create 16 and kept = Hashtbl.create 16 and more = Hashtbl.create 16 in
  let across f (u, v) =
    match (Hashtbl.find_opt table (u, v), Hashtbl.find_opt table (v, u)) with
    | Some (Some _), Some (Some g) when g <> f && not (Hashtbl.mem gone g) -> Some g
    | _ -> None
  in
  let one f =
    let corners = snd set.ifs_faces.(f) in
    let beside = List.map (across f) (sides corners) in
    if (not (Hashtbl.mem kept f)) && List.for_all Option.is_some beside then begin
      Hashtbl.replace gone f ();
      List.iter (Option.iter (fun g -> Hashtbl.replace kept g ())) beside;
      List.iter
        (fun (u, v) ->
           let inner = between set corners v u in
           if inner <> [] then Hashtbl.replace more (v, u) inner)
        (sides corners)
    end
  in
  List.iter one slivers;
  let longer corners =
    let side (u, v) = u :: Option.value (Hashtbl.find_opt more (u, v)) ~default:[] in
    Array.of_list (List.concat_map side (sides corners))
  in
  let face f (name, corners) = if Hashtbl.mem gone f then None else Some (name, longer corners) in
  let left = List.filter_map Fun.id (Array.to_list (Array.mapi face set.ifs_faces)) in
  { set with ifs_faces = Array.of_list left }

let dissolved (set : Polyhedron.ifs) =
  let rec go tries set =
    let slivers = List.filter (is_sliver set) (List.init (Array.length set.Polyhedron.ifs_faces) Fun.id) in
    if slivers = [] || tries = 0 then set
    else
      let after = round set slivers in
      if Array.length after.ifs_faces = Array.length set.ifs_faces then set else go (tries - 1) after
  in
  go 100 set
