open Scc_polyhedra

type coming = { region : Polyhedron.t; time : Linear.t option }
type 'a cell = { region : Polyhedron.t; time : Linear.t option; due : 'a list }

let where region c =
  let p = Polyhedron.add region c in
  if Polyhedron.is_empty p then None else Some p

(* The events before, with the last ones first, and one more. *)
let merge event (before : 'a cell) ({ region; time } : coming) =
  match (before.time, time) with
  | _, None -> [ { before with region } ]
  | None, Some _ -> [ { region; time; due = [ event ] } ]
  | Some t, Some t' ->
    let on c time due = Option.to_list (Option.map (fun region -> { region; time; due }) (where region c)) in
    on (Constraint.less t t') before.time before.due
    @ on (Constraint.equals t t') before.time (event :: before.due)
    @ on (Constraint.greater t t') time [ event ]

let make within events =
  let add cells (event, comes) =
    List.concat_map (fun (cell : _ cell) -> List.concat_map (merge event cell) (comes cell.region)) cells
  in
  let start = if Polyhedron.is_empty within then [] else [ { region = within; time = None; due = [] } ] in
  List.map (fun (c : _ cell) -> { c with due = List.rev c.due }) (List.fold_left add start events)
