open Scc_polyhedra
open Scc_semantics

type step = Happens of Transition.label | Passes of Linear.t | Passes_some
type t = { steps : (step * Zone.t) list; cells : Passing.due First.cell list }

let none = { steps = []; cells = [] }
let both a b = { steps = a.steps @ b.steps; cells = a.cells @ b.cells }
let happens (h : Happening.t) = (Happens h.label, h.target)

let of_cell c ~may_split z (cell : Passing.due First.cell) =
  let pass time = List.map (fun target -> (Passes time, target)) (Passing.until c z cell) in
  let until = List.concat_map pass (Option.to_list cell.time) in
  let some = if may_split then [ (Passes_some, Passing.within c z cell) ] else [] in
  { steps = until @ some; cells = [ cell ] }

let all c ~events (z : Zone.t) =
  let may_split = Passing.may_split z && not (Passing.on_grid c) in
  let of_region region =
    let { Happening.urgent; weak } = Happening.all c ~events z region in
    let now = { steps = List.map happens urgent @ List.map happens weak; cells = [] } in
    if urgent = [] && not z.halted then
      List.fold_left (fun all cell -> both all (of_cell c ~may_split z cell)) now (Passing.cells c z region)
    else now
  in
  List.fold_left (fun all region -> both all (of_region region)) none (Instant.cells c z)
