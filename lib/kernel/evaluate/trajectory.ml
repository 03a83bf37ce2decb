open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property

type t = {
  semantics : Semantics.t;
  state : State.t;
  extent : Timeline.extent;
  paths : Path.t array;  (** by process *)
  home : int -> int;  (** by leaf, the index of its process; -1 if it is in none *)
  arrived : Property.event -> bool;
  total : Property.quantity -> int option;  (** of sums over all processes: those that are known *)
}

(* A part of a state may have few processes of many. *)
let few = 4

let home (model : Model.t) (state : State.t) =
  if Array.length state.processes <= few then begin
    let rec from leaf i =
      if i < 0 || State.has_leaf state.processes.(i) leaf then i else from leaf (i - 1)
    in
    fun leaf -> from leaf (Array.length state.processes - 1)
  end
  else begin
    let homes = Array.make (Array.length model.leaves) (-1) in
    Array.iteri
      (fun i (p : State.process) -> Array.iter (fun (l : State.leaf) -> homes.(l.leaf) <- i) p.leaves)
      state.processes;
    Array.get homes
  end

let make ?(arrived = fun _ -> false) ?(total = fun _ -> None) semantics (state : State.t) extent =
  let model = Semantics.model semantics in
  let for_ever =
    match (extent : Timeline.extent) with
    | Forever -> true
    | Instant | Lasts _ -> false
  in
  let paths = Array.map (Path.make ~for_ever model) state.processes in
  { semantics; state; extent; home = home model state; arrived; total; paths }

let extent semantics state (transitions : Transition.t list) : Timeline.extent =
  let time (t : Transition.t) = match t.label with Time d -> Some d | _ -> None in
  match List.find_map time transitions with
  | Some d when Rat.sign d > 0 -> Lasts d
  | Some _ -> Instant
  | None ->
    let only_weak (t : Transition.t) = match t.label with Weak_split _ -> true | _ -> false in
    if Network.quiescent semantics state || (transitions <> [] && List.for_all only_weak transitions) then Forever
    else Instant

(** A trajectory as a whole: numbers and truths vary from piece to piece. *)
module Stretch = struct
  type context = Semantics.t
  type nonrec t = t
  type number = Value.t Timeline.t
  type truth = Truth.t Timeline.t

  let semantics c = c

  let path s leaf =
    match s.home leaf with
    | -1 -> None
    | i -> Some s.paths.(i)

  let process s leaf = Option.map Path.process (path s leaf)

  let constant r s = Timeline.constant s.extent (Value.of_rat r)
  let bool b s = Timeline.constant s.extent (Truth.of_bool b)

  (* What is a curve along a stretch is its first value at an instant. *)
  let curve s (c : Path.curve) =
    match (s.extent, Path.now c) with
    | Instant, Some r -> constant r s
    | Instant, None | (Lasts _ | Forever), _ -> Timeline.constant s.extent (Value.of_curve c)

  (* What is steady is added up apart, by the way of numbers. *)
  let sum s quantity =
    let add (steady, others) path : Rat.t * Value.t list =
      match (quantity path : Path.curve) with
      | Steady r -> (Rat.add steady r, others)
      | (Quotient _ | Not_followed) as c -> (steady, Value.of_curve c :: others)
    in
    let steady, others = Array.fold_left add (Rat.zero, []) s.paths in
    Timeline.constant s.extent (List.fold_left Value.add (Value.of_rat steady) (List.rev others))

  let time s =
    match s.state.time with
    | Some t -> curve s (Quotient (Polynomial.of_coefficients [ t; Rat.one ], Polynomial.one))
    | None -> Scc_base.Bug.fail __POS__ "a property speaks of time, and the state does not keep it"

  (* Of who is gone, if it is. *)
  let undefined s leaf =
    Timeline.constant s.extent (Value.Undefined (Meaning.of_the_gone (Semantics.model s.semantics) leaf))

  let quantity _ (q : Meaning.quantity) s =
    match q with
    | Of_process (i, f) -> (
        match path s i with
        | Some p -> curve s (f p)
        | None -> undefined s i)
    | Of_two (i, j, f) -> (
        match (path s i, path s j) with
        | Some p, Some q -> curve s (f p q)
        | None, _ -> undefined s i
        | Some _, None -> undefined s j)
    | Counted (i, f) -> constant (Rat.of_int (Option.fold ~none:0 ~some:f (process s i))) s
    | Sum f -> sum s f
    | Number (q, f) ->
      let counted () = Array.fold_left (fun n p -> n + f p) 0 s.state.processes in
      let total = match s.total q with Some n -> n | None -> counted () in
      constant (Rat.of_int total) s
    | Time -> time s
    | Parameter _ -> Scc_base.Bug.fail __POS__ "a parameter that is not known, along one run"

  (* True at most at the instant at which the trajectory starts. *)
  let at_the_start s holds = Timeline.after_start s.extent (Truth.of_bool holds) Truth.False

  let fact _ (f : Meaning.fact) s =
    match f with
    | Missing i -> bool (Option.is_none (path s i)) s
    | In_process (i, test) -> bool (Option.fold ~none:false ~some:test (process s i)) s
    | In_behaviour (i, test) ->
      let test p = test (State.leaf_of p i).behaviour in
      bool (Option.fold ~none:false ~some:test (process s i)) s
    | Touch (i, j, along) -> (
        match (path s i, path s j) with
        | Some p, Some q -> along s.extent p q
        | None, _ | _, None -> bool false s)
    | Rest test -> bool (test s.state) s
    | Arrival e -> at_the_start s (s.arrived e)

  let neg = Timeline.map Value.neg
  let add = Timeline.map2 Value.add
  let sub = Timeline.map2 Value.sub
  let mul = Timeline.map2 Value.mul
  let div ~reason (a : number) b = Value.div ~reason a.extent a b

  let choose condition a b =
    let one truth (x, y) =
      match (truth : Truth.t) with
      | True -> x
      | False -> y
      | Undecided reason -> Value.Undefined reason
    in
    Timeline.map2 one condition (Timeline.map2 (fun x y -> (x, y)) (a ()) (b ()))

  let count =
    let one = Value.of_int 1 in
    Timeline.map2 (fun (n : Value.t) (truth : Truth.t) ->
        match (n, truth) with
        | Undefined _, _ | _, False -> n
        | Ratio _, True -> Value.add n one
        | Ratio _, Undecided reason -> Undefined reason)

  let compare op (a : number) b = Value.compare op a.extent a b
  let not_ = Timeline.map Truth.not_
  let and_ a b = Timeline.simplify Truth.equal (Timeline.map2 Truth.and_ a b)

  let is_false (t : truth) =
    let is_false : Truth.t -> bool = function
      | False -> true
      | True | Undecided _ -> false
    in
    match t.rest with
    | [] -> is_false t.start && is_false t.first
    | _ :: _ -> false
end

module Along = Terms.Make (Stretch)

let predicate = Along.prop
let prop s p = Along.prop s.semantics p s
let num s n = Along.num s.semantics n s
let number_at t n offset =
  match Timeline.at (num t n) (Algebraic.of_rat offset) with
  | Value.Ratio (p, q) -> Ok (Rat.div (Polynomial.eval p offset) (Polynomial.eval q offset))
  | Undefined reason -> Error reason

let holds semantics state p = (prop (make semantics state Timeline.Instant) p).Timeline.start
