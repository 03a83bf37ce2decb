open Scc_base
open Scc_exact
open Scc_geometry
open Scc_mesh

type t = { grid : Rat.t option; weld : bool; orient : bool; merge : bool }

let merged set ~taken =
  let set, line = Mend.merge set in
  let taken =
    if taken = 0 then ""
    else Printf.sprintf "; %s took in corners of others" (Plural.count taken "face" "faces")
  in
  (set, line ^ taken)

let orient set =
  Result.map (fun t -> (t.Oriented.set, [ ("orient", "oriented: " ^ Oriented.told t) ])) (Oriented.make set)

let weld set =
  let set, line = Mend.weld set in
  (set, [ ("weld", line) ])

(* A solid that shares a face with another one is a closed piece as long as it has vertices of its own. Faces with
   corners of others within their edges are not closed, and so they take these in first. *)
let apply o set =
  let set, gridded =
    match o.grid with
    | None -> (set, [])
    | Some d ->
      let set, line = Mend.on_grid d set in
      (set, [ ("grid", line) ])
  in
  let wanted by step set = if by then step set else Ok (set, []) in
  let first = o.weld && o.orient && Oriented.pieces set > 0 in
  let* set, early = wanted first orient set in
  let* set, welded = wanted o.weld (fun set -> Ok (weld set)) set in
  let set, taken = if o.merge then Fitted.make set else (set, 0) in
  let* set, late = wanted (o.orient && not first) orient set in
  let merge set =
    let set, line = merged set ~taken in
    Ok (set, [ ("merge", line) ])
  in
  let* set, merged = wanted o.merge merge set in
  Ok (set, gridded @ welded @ early @ late @ merged)

(* {1 What helps} *)

(* Each trial looks at all faces. *)
let most_tried = 100_000

let to_be_closed (set : Polyhedron.ifs) faults =
  let opened = function Polyhedron_fault.Open_edge _ -> true | _ -> false in
  Array.length set.ifs_faces <= most_tried && List.exists opened faults

let closing set faults = if to_be_closed set faults then Mend.closing_grid set else None

let closing_merge set =
  let closed (set : Polyhedron.ifs) = Array.length set.ifs_faces > 0 && not (Mend.is_open set) in
  let merged set = fst (Mend.merge (fst (Fitted.make set))) in
  if not (Mend.is_open set) then None
  else if closed (merged set) then Some `Alone
  else
    let welded = fst (Mend.weld set) in
    if Mend.is_open welded && closed (merged welded) then Some `Welded else None

let merging set faults = if to_be_closed set faults then closing_merge set else None

let one_side_each (set : Polyhedron.ifs) =
  let welded = fst (Mend.weld set) in
  Array.length welded.ifs_faces < Array.length set.ifs_faces
  && (not (Mend.is_open welded))
  && Rat.sign (Drawn.volume welded) <> 0
