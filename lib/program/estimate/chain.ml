open Scc_base
open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_ctl
open Scc_evaluate

type node = { state : State.t; before : (State.t * Transition.label) option  (** by which it was reached *) }

(* What comes after the last state. *)
type over = Unknown | For_ever | Dead_end

type t = {
  semantics : Semantics.t;
  nodes : node Growable.t;
  mutable over : over;
  at : (int * int, Truth.t) Hashtbl.t;  (** by predicate and node: what has been found *)
  along : (int * int, Truth.t Timeline.t) Hashtbl.t;
}

let make semantics =
  { semantics; nodes = Growable.create (); over = Unknown; at = Hashtbl.create 64; along = Hashtbl.create 64 }

let start t state = Growable.push t.nodes { state; before = None }
let length t = Growable.length t.nodes
let node t i = Growable.get t.nodes i

let step t label state =
  Growable.push t.nodes { state; before = Some ((node t (length t - 1)).state, label) }

let for_ever t = t.over <- For_ever
let dead_end t = t.over <- Dead_end
let is_over t = t.over <> Unknown

(* {1 The graph} *)

let label t i =
  match (node t (i + 1)).before with
  | Some (_, label) -> label
  | None -> Bug.fail __POS__ "a beginning in the midst of a run"
let is_last t i = i = length t - 1

let edges t i =
  if is_last t i then [||] else match label t i with Transition.Time _ -> [||] | _ -> [| i + 1 |]

let flow t i : Timed_graph.flow =
  if is_last t i then match t.over with For_ever -> Forever | Unknown | Dead_end -> No_flow
  else match label t i with Time d -> Lasts (d, [| i + 1 |]) | _ -> No_flow

let graph t : Timed_graph.t =
  {
    size = length t;
    known = (fun i -> (not (is_last t i)) || t.over <> Unknown);
    edges = edges t;
    drawn = (fun _ -> None);
    flow = flow t;
  }

let trajectory t i extent =
  let node = node t i in
  let arrived event =
    match node.before with None -> false | Some (source, label) -> Event.matches ~source label event
  in
  Trajectory.make ~arrived t.semantics node.state extent

(* {1 Formulas} *)

type questions = {
  paths : Path.t list;
  formulas : Timed_formula.t list;
  truths : (Trajectory.t -> Truth.t Timeline.t) array;  (** of each predicate *)
  steady : bool array;
}

let questions semantics paths =
  let formulas, props = Skeleton.of_temporal (List.map (fun (p : Path.t) -> p.formula) paths) in
  let rigid = Option.is_some (Semantics.model semantics).Model.rigid in
  {
    paths;
    formulas;
    truths = Array.map (Trajectory.predicate semantics) props;
    steady = Array.map (Scc_property.Formula.steady ~rigid) props;
  }

let remembered table (key : int * int) find =
  match Hashtbl.find_opt table key with
  | Some x -> x
  | None ->
    let x = find () in
    Hashtbl.add table key x;
    x

let predicates q t : Eval.predicates =
  {
    at =
      (fun p i ->
         remembered t.at (p, i) (fun () -> (q.truths.(p) (trajectory t i Timeline.Instant)).start));
    along =
      (fun p i extent -> let find () = q.truths.(p) (trajectory t i extent) in
        remembered t.along (p, i) find);
    steady = (fun p -> q.steady.(p));
  }

type answer = Truth of bool | Number of Rat.t | Never | Open | No_value of string

let number t n i offset =
  let extent = Timed_graph.extent (flow t i) in
  Trajectory.number_at (trajectory t i extent) n offset

let counted t p i _ =
  let n = Counted.by t.semantics ~source:(node t i).state (label t i) p in
  (n.least, n.most)

let mean eval t (formula : Timed_formula.t) (mean : Property.mean) =
  let what : Expectation.what =
    match (mean, formula) with
    | Time_until _, Finally (_, _, g) -> Time_until g
    | Events_until (p, _), Until (_, _, _, g) -> Counts_until (counted t p, g)
    | Value_at (n, time), _ -> Value_at (number t n, time)
    | (Time_until _ | Events_until _), _ -> Bug.fail __POS__ "a mean with another formula"
  in
  match Expectation.find eval Least what with
  | Known { least = Exact x; most = Exact y } when Rat.equal x y -> Number x
  | Known { least = Infinite; _ } -> Never
  | Known _ | Unknown { reason = None; _ } -> Open
  | Unknown { reason = Some why; _ } -> No_value why

let answers q t =
  let eval = Eval.create (Timed_graph.index (graph t)) (predicates q t) in
  let answer (path : Path.t) formula =
    match path.question with
    | Amounts (m, _) -> mean eval t formula m
    | Does -> (
        match Eval.truth eval formula (Positions.start 0) with
        | Some truth -> Truth truth
        | None -> Open)
  in
  List.map2 answer q.paths q.formulas
