open Scc_polyhedra
open Scc_semantics
open Scc_state_sets

type step = Happens of Transition.label | Passes of Linear.t | Passes_some

type t = {
  steps : (step * Zone.t) list;
  postponed : (step * Zone.t) list;
  cells : Passing.due First.cell list;
}


let none = { steps = []; postponed = []; cells = [] }

let both a b =
  { steps = a.steps @ b.steps; postponed = a.postponed @ b.postponed; cells = a.cells @ b.cells }

let happens (h : Happening.t) = (Happens h.label, h.target)

let of_cell c ~may_split z (cell : Passing.due First.cell) =
  let pass time = List.map (fun target -> (Passes time, target)) (Passing.until c z cell) in
  let until = List.concat_map pass (Option.to_list cell.time) in
  let some = if may_split then [ (Passes_some, Passing.within c z cell) ] else [] in
  { steps = until @ some; postponed = []; cells = [ cell ] }

let some_leaf (h : Happening.t) =
  match (h.label, Transition.bonds h.label) with
  | _, b :: _ -> b.one.at
  | Bounce { firsts = i :: _; _ }, [] -> i
  | (Absorb { first; _ } | Draw { first; _ }), [] -> first
  | (Time _ | Bounce _ | Bind _ | Close _ | Weak_split _ | Strong_split _ | Lot _), [] ->
    Scc_base.Bug.fail __POS__ "an event of nobody"

(* Rule Order: what one group does that nobody can see, if it has to do something, before what all others do. *)
let in_one_order c z region ~visible ~must all =
  match all with
  | [] | [ _ ] -> (all, [])
  | _ :: _ :: _ -> (
      let groups = Near_groups.make c z region in
      let group h = Near_groups.of_leaf groups (some_leaf h) in
      match List.find_opt (fun h -> Near_groups.hidden groups ~visible (group h)) must with
      | None -> (all, [])
      | Some first -> List.partition (fun h -> group h = group first) all)

let all ?visible c ~events (z : Zone.t) =
  let may_split = Zone_time.splits_at_any_time (Semantics.model c.Zone_parts.semantics) z in
  let of_region region =
    let happenings = Happening.all c ~events z region in
    let passes = not (Network.is_urgent happenings || z.halted) in
    (* Where time may halt for a weak split, the one at once is the one after no time. *)
    let weak = if passes && may_split then [] else happenings.weak in
    let must = happenings.urgent @ happenings.collisions in
    let first, later =
      match visible with
      | None -> (must @ weak, [])
      | Some visible -> in_one_order c z region ~visible ~must (must @ weak)
    in
    let now = { steps = List.map happens first; postponed = List.map happens later; cells = [] } in
    if passes then
      List.fold_left (fun all cell -> both all (of_cell c ~may_split z cell)) now (Passing.cells c z region)
    else now
  in
  List.fold_left (fun all region -> both all (of_region region)) none (Instant.cells c z)
