open Scc_exact
open Scc_polyhedra
open Scc_state_sets
module Truth = Scc_ctl.Truth

exception Not_known of string

let not_known reason = raise (Not_known reason)

(* {1 What is looked at}

   A stretch is what time makes of a region of a node until what comes next: the states (y, d) that are strictly
   between, where d > 0 says how much time has passed. *)

type stretch = {
  region : Polyhedron.t;  (** of the node *)
  zone : Zone.t;  (** the trajectory *)
  for_ever : bool;
}

type node = {
  it : Zone_graph.node;
  stretches : stretch list;
  happens : Zone_graph.edge list;  (** at once *)
  passes : Zone_graph.edge list;
  splits : (Zone_graph.edge * Zone_graph.edge list option) list;
  (** to a halted node, with what may happen there, [None] if it is not explored: from states of stretches *)
}

(* A set of states: of nodes, and of their stretches. *)
type sets = { at : Union.t array; along : Union.t list array }

type model = { nodes : node array; atoms : Atoms.context; before : int list array; whole : bool }

let is_explored n = n.it.expanded

let of_graph context atoms graph =
  let events_of (halted : Zone_graph.node) = if halted.expanded then Some halted.edges else None in
  let node i =
    let it = Zone_graph.node graph i in
    let stretch (cell : Passing.due First.cell) =
      { region = cell.region; zone = Passing.trajectory context it.zone cell; for_ever = cell.time = None }
    in
    let is step (e : Zone_graph.edge) = step e.step in
    let halted = List.filter (is (function Passes_some -> true | Happens _ | Passes _ -> false)) it.edges in
    {
      it;
      stretches = List.map stretch it.cells;
      happens = List.filter (is (function Happens _ -> true | Passes _ | Passes_some -> false)) it.edges;
      passes = List.filter (is (function Passes _ -> true | Happens _ | Passes_some -> false)) it.edges;
      splits = List.map (fun (e : Zone_graph.edge) -> (e, events_of (Zone_graph.node graph e.target))) halted;
    }
  in
  let nodes = Array.init (Zone_graph.size graph) node in
  let before = Array.make (Array.length nodes) [] in
  let follows i (e : Zone_graph.edge) = before.(e.target) <- i :: before.(e.target) in
  let add i n =
    if not n.it.zone.halted then begin
      List.iter (follows i) n.happens;
      List.iter (follows i) n.passes;
      List.iter (fun (_, edges) -> List.iter (follows i) (Option.value edges ~default:[])) n.splits
    end
  in
  Array.iteri add nodes;
  let before = Array.map (List.sort_uniq Int.compare) before in
  { nodes; atoms; before; whole = Array.for_all is_explored nodes }

(* {1 Sets} *)

let tidy u = Union.merged u
let some p = Union.of_polyhedron p
let all_of n = some n.it.zone.set
let all_along s = some s.zone.set
let map2 f a b = { at = Array.map2 f a.at b.at; along = Array.map2 (List.map2 f) a.along b.along }
let union a b = if Union.is_empty a then b else if Union.is_empty b then a else tidy (Union.union a b)
let inter a b = if Union.is_empty a then a else if Union.is_empty b then b else tidy (Union.inter a b)
let minus a b = if Union.is_empty a || Union.is_empty b then a else tidy (Union.difference a b)

let complement m s =
  {
    at = Array.mapi (fun i u -> minus (all_of m.nodes.(i)) u) s.at;
    along = Array.mapi (fun i us -> List.map2 (fun x u -> minus (all_along x) u) m.nodes.(i).stretches us) s.along;
  }

let project u ~dimension =
  Union.map ~dimension (fun p -> Polyhedron.project p (Array.init dimension Fun.id)) u

let restrict u constraints =
  Union.map ~dimension:(Union.dimension u) (fun p -> Polyhedron.add_all p constraints) u

(* {1 State predicates} *)

let where truth =
  let pick = function
    | p, Truth.True -> Some p
    | _, Truth.False -> None
    | _, Truth.Undecided reason -> not_known reason
  in
  List.filter_map pick truth

let rests n (s : stretch) = s.for_ever && not (Zone_time.may_split n.it.zone)

let unknown n ~may = if may then all_of n else Union.empty (Zone.dimension n.it.zone)

let of_prop m ~may prop =
  let truth = Atoms.truth m.atoms prop in
  let look zone ~passing ~quiescent =
    tidy (Union.of_polyhedra (Zone.dimension zone) (where (truth { zone; passing; quiescent })))
  in
  let at n =
    if not (is_explored n) && (n.it.zone.halted || Search_sets.asks_for_rest prop) then unknown n ~may
    else if n.it.zone.halted then Union.empty (Zone.dimension n.it.zone)
    else
      let quiescent = List.filter_map (fun s -> if rests n s then Some s.region else None) n.stretches in
      look n.it.zone ~passing:false ~quiescent
  in
  let along n s = look s.zone ~passing:true ~quiescent:(if rests n s then [ s.zone.set ] else []) in
  { at = Array.map at m.nodes; along = Array.map (fun n -> List.map (along n) n.stretches) m.nodes }

let everything m ~may = of_prop m ~may (Scc_property.Property.Bool true)

(* {1 Backwards} *)

(* From where an edge leads into a set of its target. *)
let back (e : Zone_graph.edge) target =
  let dimension = Polyhedron.dimension e.guard in
  let from p = Polyhedron.inter e.guard (Polyhedron.preimage p ~dimension e.map) in
  Union.of_polyhedra dimension (List.map from (Union.pieces target))

let back_all edges ~dimension (at : Union.t array) =
  List.fold_left (fun u (e : Zone_graph.edge) -> union u (back e at.(e.target))) (Union.empty dimension) edges

(* From where time may halt for a split that leads into the set: over the variables of the node, and the time that
   passes before, which may be none. *)
let halting n at =
  let of_split u ((to_halted : Zone_graph.edge), edges) =
    match edges with
    | None -> union u (back to_halted at.(to_halted.target))
    | Some [] -> u
    | Some ((first : Zone_graph.edge) :: _ as edges) ->
      union u (back to_halted (back_all edges ~dimension:(Polyhedron.dimension first.guard) at))
  in
  List.fold_left of_split (Union.empty (Zone.dimension n.it.zone + 1)) n.splits

(* The states of a stretch at which time may halt so. *)
let halts n s at = inter (all_along s) (halting n at)

(* The states of a node from which an event leads into the set at once. *)
let at_once n at =
  let dimension = Zone.dimension n.it.zone in
  let time = Linear.variable (dimension + 1) dimension in
  let no_time = Constraint.equals time (Linear.constant (dimension + 1) Rat.zero) in
  union (back_all n.happens ~dimension at) (project (restrict (halting n at) [ no_time ]) ~dimension)

(* Where the end of a stretch leads into the set: over the variables of the node. *)
let ends n s at =
  inter (some s.region) (back_all n.passes ~dimension:(Zone.dimension n.it.zone) at)

let late n s = inter (some s.region) (Union.of_polyhedra (Zone.dimension n.it.zone) n.it.late)

(* Sets over (y, d) as sets over (y, d, d', ...): with d, or with d' for d. *)
let embed u ~dimension at = Union.map ~dimension (fun p -> Polyhedron.embed p ~dimension at) u
let before_ ~dimension i j = Constraint.less (Linear.variable dimension i) (Linear.variable dimension j)

(* The (y, d, d') of a stretch, d <= d', such that no state strictly between is in the set [bad]. *)
let clear_until s bad =
  let n = Zone.dimension s.zone - 1 in
  let y = Array.init n Fun.id in
  let with_last last = Array.append y [| last |] in
  let both =
    let with_last i = embed (all_along s) ~dimension:(n + 2) (with_last i) in
    inter (with_last n) (with_last (n + 1))
  in
  let d = Linear.variable (n + 2) n and d' = Linear.variable (n + 2) (n + 1) in
  let ordered = restrict both [ Constraint.at_most d d' ] in
  if Union.is_empty bad then ordered
  else
    let between = restrict (embed bad ~dimension:(n + 3) (with_last (n + 2))) [
        before_ ~dimension:(n + 3) n (n + 2); before_ ~dimension:(n + 3) (n + 2) (n + 1) ]
    in
    minus ordered (project between ~dimension:(n + 2))

(* The (y, d) of a stretch such that no later state is in the set. *)
let clear_to_end s bad =
  if Union.is_empty bad then all_along s
  else
    let n = Zone.dimension s.zone - 1 in
    let y = Array.init n Fun.id in
    let later =
      restrict (embed bad ~dimension:(n + 2) (Array.append y [| n + 1 |])) [ before_ ~dimension:(n + 2) n (n + 1) ]
    in
    minus (all_along s) (project later ~dimension:(n + 1))

(* The (y, d) from which a state of the set is reached, itself or later, with none in [bad] before it but perhaps
   the first one. *)
let reach s ~bad target =
  if Union.is_empty target then target
  else
    let n = Zone.dimension s.zone - 1 in
    let at_later = embed target ~dimension:(n + 2) (Array.append (Array.init n Fun.id) [| n + 1 |]) in
    tidy (project (inter (clear_until s bad) at_later) ~dimension:(n + 1))

(* What is not after a state of [bad], of some states of a stretch. *)
let not_after s ~bad states =
  if Union.is_empty bad then states
  else
    (* d' is the state, d'' one before it *)
    let n = Zone.dimension s.zone - 1 in
    let y = Array.init n Fun.id in
    let before =
      restrict (embed bad ~dimension:(n + 2) (Array.append y [| n + 1 |])) [ before_ ~dimension:(n + 2) (n + 1) n ]
    in
    minus states (project before ~dimension:(n + 1))

let reach_from_start s ~bad target = project (not_after s ~bad target) ~dimension:(Zone.dimension s.zone - 1)

let clear_from_start s ~bad = minus (some s.region) (project bad ~dimension:(Zone.dimension s.zone - 1))
let extend_over s u =
  let n = Zone.dimension s.zone - 1 in
  inter (all_along s) (embed u ~dimension:(n + 1) (Array.init n Fun.id))
