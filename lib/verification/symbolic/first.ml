open Scc_polyhedra

type 'a cell = { region : Polyhedron.t; time : Linear.t option; due : 'a list }

let start within = if Polyhedron.is_empty within then [] else [ { region = within; time = None; due = [] } ]

(* One event more on a region in which it comes at a time. *)
let merge event (cell : 'a cell) region time =
  match cell.time with
  | None -> [ { region; time = Some time; due = [ event ] } ]
  | Some t ->
    let on c time due = List.map (fun region -> { region; time; due }) (Region.where region [ c ]) in
    on (Constraint.less t time) cell.time cell.due
    @ on (Constraint.equals t time) cell.time (cell.due @ [ event ])
    @ on (Constraint.greater t time) (Some time) [ event ]

let at time event cells = List.concat_map (fun (cell : _ cell) -> merge event cell cell.region time) cells

let on comes event cells =
  let add (cell : _ cell) =
    let hits, rest = comes ~limit:cell.time cell.region in
    List.map (fun region -> { cell with region }) rest
    @ List.concat_map (fun (region, time) -> merge event cell region time) hits
  in
  List.concat_map add cells

let merged same cells =
  let alike a b = Option.equal Linear.equal a.time b.time && List.equal same a.due b.due in
  let rec go found = function
    | [] -> List.concat (List.rev found)
    | cell :: rest -> (
        match List.partition (alike cell) rest with
        | [], rest -> go ([ cell ] :: found) rest
        | more, rest ->
          let regions = List.map (fun c -> c.region) (cell :: more) in
          let union = Union.of_polyhedra (Polyhedron.dimension cell.region) regions in
          let one region = { cell with region } in
          go (List.map one (Union.pieces (Union.merged union)) :: found) rest)
  in
  go [] cells
