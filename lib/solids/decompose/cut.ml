type fragment = { plane : int; polygon : Homogeneous.t array }

module Planes = Hashtbl.Make (Plane)

let in_front fragments plane =
  let ahead f = Array.exists (fun p -> Plane.side plane p > 0) f.polygon in
  Array.exists ahead fragments

let planes_of fragments =
  List.sort_uniq Int.compare (Array.to_list (Array.map (fun f -> f.plane) fragments))

(* The plane of a fragment in front of which there is something; none when the fragments are in convex position. *)
let separating planes fragments =
  List.find_opt (in_front fragments) (List.map (fun k -> planes.(k)) (planes_of fragments))

let choose ~prefer ~all planes fragments notches =
  match Notch.plane ~prefer ~all planes notches with
  | Some plane -> Some plane
  | None -> separating planes fragments

let halves plane fragments =
  let opposite = Plane.opposite plane in
  let front = ref [] and back = ref [] in
  Array.iter
    (fun f ->
       match Cell.position plane f.polygon with
       | On -> ()
       | Behind -> back := f :: !back
       | In_front -> front := f :: !front
       | Across ->
         back := { f with polygon = Cell.behind plane f.polygon } :: !back;
         front := { f with polygon = Cell.behind opposite f.polygon } :: !front)
    fragments;
  (Array.of_list (List.rev !back), Array.of_list (List.rev !front))

let clipped cell plane =
  match Cell.clip cell plane with
  | Some cell -> cell
  | None -> Scc_base.Bug.fail __POS__ "a plane of a cell that does not meet it"

(* Cells that wait, so that nothing depends on how deep the cuts go. *)
let cells ~tick ~prefer box planes fragments notches =
  let all = Array.length notches in
  let rec work found = function
    | [] -> List.rev found
    | (cell, fragments, notches) :: waiting -> (
        tick ();
        match choose ~prefer ~all planes fragments notches with
        | None ->
          let inside = List.fold_left (fun cell k -> clipped cell planes.(k)) cell (planes_of fragments) in
          work (inside :: found) waiting
        | Some plane ->
          let back, front = halves plane fragments in
          let notches_behind, notches_ahead = Notch.split plane notches in
          let behind = clipped cell plane in
          let waiting =
            if Array.length front = 0 then waiting
            else (clipped cell (Plane.opposite plane), front, notches_ahead) :: waiting
          in
          if Array.length back = 0 then work (behind :: found) waiting
          else work found ((behind, back, notches_behind) :: waiting))
  in
  work [] [ (box, fragments, notches) ]

(* From so many edges on, even halves make fewer parts, in less time. *)
let most_in_both_ways = 64

let parts ~tick box polygons =
  let numbers = Planes.create 64 and count = ref 0 and list = ref [] in
  let number plane =
    match Planes.find_opt numbers plane with
    | Some k -> k
    | None ->
      let k = !count in
      Planes.add numbers plane k;
      list := plane :: !list;
      incr count;
      k
  in
  let fragments = Array.map (fun (plane, polygon) -> { plane = number plane; polygon }) (Array.of_list polygons) in
  let planes = Array.of_list (List.rev !list) in
  let notches = Notch.of_surface planes (Array.map (fun f -> (f.plane, f.polygon)) fragments) in
  let by prefer = cells ~tick ~prefer box planes fragments notches in
  by Notch.Even :: (if Array.length notches > most_in_both_ways then [] else [ by Notch.Any ])
