type fragment = { plane : int; polygon : Place.t array }

module Planes = Hashtbl.Make (Plane)

let in_front fragments plane =
  let ahead f = Array.exists (fun p -> Plane.side plane p > 0) f.polygon in
  Array.exists ahead fragments

let planes_of fragments =
  List.sort_uniq Int.compare (Array.to_list (Array.map (fun f -> f.plane) fragments))

(* How many fragments are cut, and how uneven the halves are. *)
let cost planes fragments k =
  let across = ref 0 and front = ref 0 and back = ref 0 in
  Array.iter
    (fun f ->
       if f.plane <> k then
         match Cell.position planes.(k) f.polygon with
         | Across -> incr across
         | In_front -> incr front
         | Behind -> incr back
         | On -> ())
    fragments;
  if !front + !across = 0 then None else Some (!across, abs (!front - !back))

(* As many planes are tried as keep the work at one cell near linear. *)
let most_tried fragments = Int.max 24 (40_000 / Int.max 1 (Array.length fragments))

let sample most list =
  let all = Array.of_list list in
  let n = Array.length all in
  if n <= most then list else List.init most (fun i -> all.(i * n / most))

let best planes fragments candidates =
  let better found k =
    match (cost planes fragments k, found) with
    | None, _ -> found
    | Some c, Some (least, _) when compare least c <= 0 -> found
    | Some c, _ -> Some (c, k)
  in
  Option.map snd (List.fold_left better None candidates)

(* The plane of a fragment in front of which there is something; none when the fragments are in convex position. *)
let choose planes fragments =
  let all = planes_of fragments in
  match best planes fragments (sample (most_tried fragments) all) with
  | Some k -> Some k
  | None -> List.find_opt (fun k -> in_front fragments planes.(k)) all

let halves planes fragments k =
  let plane = planes.(k) in
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
  (* Cells that wait, so that nothing depends on how deep the cuts go. *)
  let rec work found = function
    | [] -> List.rev found
    | (cell, fragments) :: waiting -> (
        tick ();
        match choose planes fragments with
        | None ->
          let inside = List.fold_left (fun cell k -> clipped cell planes.(k)) cell (planes_of fragments) in
          work (inside :: found) waiting
        | Some k ->
          let back, front = halves planes fragments k in
          let behind = clipped cell planes.(k) in
          let waiting =
            if Array.length front = 0 then waiting
            else (clipped cell (Plane.opposite planes.(k)), front) :: waiting
          in
          if Array.length back = 0 then work (behind :: found) waiting else work found ((behind, back) :: waiting))
  in
  work [] [ (box, fragments) ]
