open Scc_base
open Scc_data

type relation = Trace | Weak | Branching | Strong | Timed

type difference = {
  trace : (string list * bool) option;
  trace_open : bool;
  formula : Modal_formula.t option;
}

type reason = Unknown_states | Effort_spent | Too_many_sets | Too_many_pairs
type verdict = Equivalent | Different of difference | Undecided of reason
type side = { states : int; transitions : int; classes : int option }
type report = { verdict : verdict; first : side; second : side; show : Modal_formula.t -> string }

let prepare relation g =
  match relation with
  | Trace | Weak | Branching -> Graph.reachable (Passing.hide g)
  | Strong -> Passing.without_durations (Passing.merge g)
  | Timed -> Passing.merge g

(* The bisimilarity behind each relation; weak traces do not tell apart what is branching bisimilar. *)
let kind : relation -> Refine.kind = function
  | Trace | Branching -> Branching
  | Weak -> Weak
  | Strong | Timed -> Strong

let view : relation -> Traces.view = function
  | Trace | Weak | Branching -> Observable
  | Strong | Timed -> Every_action

let system relation g = match relation with Timed -> System.timed g | _ -> System.untimed g

(* Both graphs side by side, and what is left of them to look for differences in. *)
type t = {
  effort : Effort.t;
  relation : relation;
  whole : System.t;
  starts : int * int;
  small : System.t;
  small_starts : int * int;
  bisimilar : bool option;  (* the initial states, if it is known *)
  store : Modal_formula.store;
}

(* {1 Differences} *)

(* Nothing is claimed that has not been checked on the graphs as they came. *)
let checked t f =
  let e = Modal_formula.evaluator t.whole in
  let p, q = t.starts in
  if Modal_formula.certainly e f p && not (Modal_formula.possibly e f q) then f
  else Bug.fail __POS__ "a formula that was to tell two graphs apart does not"

let checked_trace t steps ~first =
  let p, q = t.starts in
  let has, lacks = if first then (p, q) else (q, p) in
  let possible = Traces.possible (view t.relation) t.whole in
  if not (possible ~sure:true has steps && not (possible ~sure:false lacks steps)) then
    Bug.fail __POS__ "a trace that was to tell two graphs apart does not"

let trace_formula t steps ~first =
  Traces.formula t.store (view t.relation) steps
  |> Option.map (fun f -> checked t (if first then f else Modal_formula.negation t.store f))

let merge_times steps =
  let open Scc_exact in
  let add step acc =
    match (step, acc) with
    | Traces.Time d, Traces.Time e :: rest -> Traces.Time (Rat.add d e) :: rest
    | _ -> step :: acc
  in
  List.fold_left (fun acc step -> add step acc) [] (List.rev steps)

let texts t steps =
  let labels = (System.graph t.whole).labels in
  List.map
    (function
      | Traces.Action a -> labels.(a)
      | Time d -> Label.of_passing (For d))
    (merge_times steps)

let traces t limits =
  let p, q = t.small_starts in
  Traces.compare t.effort limits (view t.relation) t.small p q

(* A trace, and the formula that goes with it. *)
let by_trace t steps ~first formula =
  checked_trace t steps ~first;
  let formula = match formula with Some f -> Some (checked t f) | None -> trace_formula t steps ~first in
  Different { trace = Some (texts t steps, first); trace_open = false; formula }

let different t formula =
  match traces t Traces.to_explain with
  | Traces.Trace { steps; first } -> by_trace t steps ~first formula
  | (exception Effort.Exhausted) | Too_large | Unclear ->
    Different { trace = None; trace_open = true; formula = Option.map (checked t) formula }
  | Same -> Different { trace = None; trace_open = false; formula = Option.map (checked t) formula }

let play t =
  let p, q = t.small_starts in
  let most = if Option.is_some t.bisimilar then Game.to_explain else Game.to_decide in
  Game.play t.effort (kind t.relation) t.small ~most ~same:(fun _ _ -> false) t.store p q

let complete t = Graph.complete (System.graph t.whole)

let compare_traces t =
  match traces t Traces.to_decide with
  | Trace { steps; first } -> by_trace t steps ~first None
  | Same when complete t -> Equivalent
  | Same | Unclear -> Undecided Unknown_states
  | Too_large -> Undecided Too_many_sets

let compare_moves t =
  match (t.bisimilar, t.relation) with
  | Some true, _ -> Equivalent
  | Some false, Trace | None, Trace -> compare_traces t
  | Some false, _ -> (
      match play t with
      | Differ formula -> different t formula
      | (exception Effort.Exhausted) | Too_large -> different t None
      | Alike -> Bug.fail __POS__ "the game does not find what the partition has found")
  | None, _ -> (
      match play t with
      | Differ formula -> different t formula
      | Alike when complete t -> Equivalent
      | Alike -> Undecided Unknown_states
      | Too_large -> (
          (* a distinguishing trace may be found where the game is too large *)
          match traces t Traces.to_decide with
          | Trace { steps; first } -> by_trace t steps ~first None
          | Same | Unclear | Too_large ->
            Undecided (if complete t then Too_many_pairs else Unknown_states)))

(* {1 Partitions} *)

let classes_of (p : Refine.partition) from upto =
  let seen = Bits.create p.count in
  let n = ref 0 in
  for s = from to upto - 1 do
    let b = Int_array.get p.block s in
    if not (Bits.mem seen b) then begin
      Bits.add seen b;
      incr n
    end
  done;
  !n

(* Passings of time are labels like others once consecutive ones are merged, unless a state has two. *)
let partition_decides relation (g : Graph.t) =
  Graph.complete g
  && match relation with Trace | Weak | Branching | Strong -> true | Timed -> Passing.deterministic g

let run effort relation (g : Graph.t) (h : Graph.t) =
  let both, second = Graph.union g h in
  let starts = (both.initial, second) in
  let whole = system relation both in
  let show = Modal_formula.to_string ~label:(fun a -> both.labels.(a)) in
  let report verdict partition =
    let side (x : Graph.t) from =
      let classes = Option.map (fun p -> classes_of p from (from + x.size)) partition in
      { states = x.size; transitions = Graph.edges x; classes }
    in
    { verdict; first = side g 0; second = side h g.size; show }
  in
  let t =
    {
      effort;
      relation;
      whole;
      starts;
      small = whole;
      small_starts = starts;
      bisimilar = None;
      store = Modal_formula.store ();
    }
  in
  let guarded f = match f () with v -> v | exception Effort.Exhausted -> Undecided Effort_spent in
  if not (partition_decides relation both) then report (guarded (fun () -> compare_moves t)) None
  else
    match Quotient.blocks effort (kind relation) both with
    | exception Effort.Exhausted -> report (Undecided Effort_spent) None
    | p ->
      let reduced = Quotient.make (kind relation) both p in
      let one = Int_array.get p.block (fst starts) and two = Int_array.get p.block second in
      let t =
        {
          t with
          small = system relation reduced;
          small_starts = (one, two);
          bisimilar = Some (one = two);
        }
      in
      report (guarded (fun () -> compare_moves t)) (Some p)

let given_up =
  let side = { states = 0; transitions = 0; classes = None } in
  { verdict = Undecided Effort_spent; first = side; second = side; show = (fun _ -> "") }
