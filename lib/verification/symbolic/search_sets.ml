open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets
module Truth = Scc_ctl.Truth

type place = { node : Zone_graph.node; states : Polyhedron.t; passing : bool; prop : Property.prop }

type t = {
  truth : Atoms.view -> (Polyhedron.t * Truth.t) list;
  prop : Property.prop;
  parameters : int;
  bound : Rat.t option;
  while_passing : bool;  (** what it says may change between two events *)
  mutable found : Polyhedron.t list;
  mutable doubtful : Polyhedron.t list;
  mutable reasons : string list;
  mutable first : place option;
  mutable outside : Rat.t array option;  (** values that were not found when somebody asked last *)
}

let make context ~parameters ~bound prop =
  {
    truth = Atoms.truth context prop;
    prop;
    parameters;
    bound;
    while_passing = (not (Formula.steady ~rigid:false prop)) || Formula.has_events (State prop);
    found = [];
    doubtful = [];
    reasons = [];
    first = None;
    outside = None;
  }

let add pieces p = if List.exists (Polyhedron.included p) pieces then pieces else Union.add_merged p pieces

let in_time t (z : Zone.t) =
  match (t.bound, z.time) with
  | Some b, Some time -> [ Constraint.at_most time (Linear.constant (Zone.dimension z) b) ]
  | None, _ -> []
  | Some _, None -> Scc_base.Bug.fail __POS__ "a bound on time that is not kept"

let note t node (view : Atoms.view) =
  let z = view.zone in
  let of_cell (region, truth) =
    let states = Polyhedron.add_all region (in_time t z) in
    if not (Polyhedron.is_empty states) then
      let values () = Polyhedron.image states z.parameters in
      match (truth : Truth.t) with
      | False -> ()
      | True ->
        if t.first = None then t.first <- Some { node; states; passing = view.passing; prop = t.prop };
        t.found <- add t.found (values ())
      | Undecided reason ->
        if not (List.mem reason t.reasons) then t.reasons <- t.reasons @ [ reason ];
        t.doubtful <- add t.doubtful (values ())
  in
  if not (Polyhedron.is_empty z.set) then List.iter of_cell (t.truth view)

let asks_for_rest prop =
  List.exists (fun (a : Atom.t) -> String.equal a.word "quiescent") (Formula.atoms (State prop))

let quiescent (node : Zone_graph.node) =
  if Zone_time.may_split node.zone then []
  else
    List.filter_map
      (fun (cell : Passing.due First.cell) -> if cell.time = None then Some cell.region else None)
      node.cells

let look_at t (node : Zone_graph.node) =
  note t node { zone = node.zone; passing = false; quiescent = quiescent node }

let look context t (node : Zone_graph.node) =
  if not node.zone.halted then begin
    look_at t node;
    if t.while_passing then
      let of_cell (cell : Passing.due First.cell) =
        let zone = Passing.trajectory context node.zone cell in
        let rests = cell.time = None && not (Zone_time.may_split node.zone) in
        note t node { zone; passing = true; quiescent = (if rests then [ zone.set ] else []) }
      in
      List.iter of_cell node.cells
  end

let leave t (z : Zone.t) =
  let states = Polyhedron.add_all z.set (in_time t z) in
  if not (Polyhedron.is_empty states) then t.doubtful <- add t.doubtful (Polyhedron.image states z.parameters)

let look_around t (node : Zone_graph.node) =
  let z = node.zone in
  (* whether it is quiescent there is not known *)
  if not (z.halted || asks_for_rest t.prop) then note t node { zone = z; passing = false; quiescent = [] };
  leave t z

let union t pieces = Union.of_polyhedra t.parameters pieces
let found t = union t t.found
let open_ t = union t t.doubtful
let reasons t = t.reasons
(* Asked again and again while it explores, about one set. *)
let covers t set =
  let is_found point = List.exists (fun p -> Polyhedron.mem p point) t.found in
  match t.outside with
  | Some point when not (is_found point) -> false
  | Some _ | None ->
    t.outside <- Union.outside (found t) set;
    Option.is_none t.outside
let first t = t.first
