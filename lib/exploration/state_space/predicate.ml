open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_motion
open Scc_property
open Scc_evaluate

let by_process c any f = Catalogue.remembered (Network_lts.catalogue c) any f

let leaves c = Array.length (Network_lts.model c).leaves

(* The number of the process of a leaf: it is in the slot of its first leaf, which comes no later. Or nobody. *)
let home_number c leaf =
  let catalogue = Network_lts.catalogue c in
  fun (tuple : int array) ->
    let rec from i =
      if i < 0 then Catalogue.nobody
      else if tuple.(i) <> Catalogue.nobody then
        let p = (Catalogue.body catalogue tuple.(i)).process in
        if State.has_leaf p leaf then tuple.(i) else from (i - 1)
      else from (i - 1)
    in
    from leaf

let home c leaf =
  let number = home_number c leaf in
  fun tuple ->
    let n = number tuple in
    if n = Catalogue.nobody then None else Some (Catalogue.body (Network_lts.catalogue c) n).process

(** A state as a tuple, at its instant. *)
module Tuple = struct
  type context = { lts : Network_lts.context; later : bool  (** what has just happened is past *) }
  type t = int array

  (* Or why there is none. *)
  type number = (Rat.t, string) result
  type truth = Truth.t

  let semantics c = Network_lts.semantics c.lts

  let of_curve (c : Path.curve) : number =
    match c with
    | Steady r -> Ok r
    | Quotient _ | Not_followed -> Option.to_result ~none:Value.not_followed (Path.now c)

  let both f (a : number) (b : number) : number =
    match (a, b) with
    | Ok x, Ok y -> Ok (f x y)
    | (Error _ as e), _ | _, (Error _ as e) -> e

  let neg = Result.map Rat.neg
  let add = both Rat.add
  let sub = both Rat.sub
  let mul = both Rat.mul

  let div ~reason (a : number) (b : number) : number =
    match (a, b) with
    | _, Ok y when Rat.sign y = 0 -> Error reason
    | Ok x, Ok y -> Ok (Rat.div x y)
    | (Error _ as e), _ | _, (Error _ as e) -> e

  let constant r =
    let n : number = Ok r in
    fun _ -> n

  let choose (condition : truth) a b : number =
    match condition with
    | True -> a ()
    | False -> b ()
    | Undecided reason -> Error reason

  let count (n : number) (truth : truth) : number =
    match (n, truth) with
    | Error _, _ | _, False -> n
    | Ok n, True -> Ok (Rat.add n Rat.one)
    | Ok _, Undecided reason -> Error reason

  let quantity { lts = c; _ } (q : Meaning.quantity) : t -> number =
    let path process = Path.make (Network_lts.model c) process in
    let undefined leaf : number = Error (Meaning.of_the_gone (Network_lts.model c) leaf) in
    match q with
    | Of_process (i, f) ->
      let home = home c i in
      fun t -> (match home t with Some p -> of_curve (f (path p)) | None -> undefined i)
    | Of_two (i, j, f) ->
      let one = home c i and two = home c j in
      fun t -> (
          match (one t, two t) with
          | Some p, Some q -> of_curve (f (path p) (path q))
          | None, _ -> undefined i
          | Some _, None -> undefined j)
    | Counted (i, f) ->
      let home = home c i in
      fun t -> Ok (Rat.of_int (Option.fold ~none:0 ~some:f (home t)))
    | Sum f ->
      let of_number = by_process c (Ok Rat.zero) (fun p -> of_curve (f (path p))) in
      let of_slot p = if p = Catalogue.nobody then Ok Rat.zero else of_number p in
      Running_sum.rationals ~width:(leaves c) of_slot
    | Number (_, f) ->
      let of_number = by_process c 0 f in
      let of_slot p = if p = Catalogue.nobody then 0 else of_number p in
      let sum = Running_sum.integers ~width:(leaves c) of_slot in
      fun t -> Ok (Rat.of_int (sum t))
    | Time -> (
        fun t ->
          match Catalogue.time (Network_lts.catalogue c) t with
          | Some time -> Ok time
          | None -> Scc_base.Bug.fail __POS__ "a property speaks of time, and the state does not keep it")
    | Parameter _ -> Scc_base.Bug.fail __POS__ "a parameter that is not known, in one state after the other"

  let bool b =
    let truth = Truth.of_bool b in
    fun _ -> truth

  let fact { lts = c; later } (f : Meaning.fact) : t -> truth =
    match f with
    | Missing i ->
      let number = home_number c i in
      fun t -> Truth.of_bool (number t = Catalogue.nobody)
    | In_process (i, test) ->
      let home = home c i in
      fun t -> Truth.of_bool (Option.fold ~none:false ~some:test (home t))
    | In_behaviour (leaf, test) ->
      let number = home_number c leaf in
      let of_number = by_process c false (fun p -> test (State.leaf_of p leaf).behaviour) in
      fun t ->
        let n = number t in
        Truth.of_bool (n <> Catalogue.nobody && of_number n)
    | Touch (i, j, along) ->
      let one = home c i and two = home c j and path process = Path.make (Network_lts.model c) process in
      fun t -> (
          match (one t, two t) with
          | Some p, Some q -> (along Timeline.Instant (path p) (path q)).start
          | None, _ | _, None -> Truth.False)
    | Rest test -> fun t -> Truth.of_bool (test (Catalogue.decode (Network_lts.catalogue c) t))
    | Arrival _ when later -> fun _ -> Truth.False
    | Arrival e ->
      let arrived = Network_lts.arrived c e in
      fun t -> Truth.of_bool (arrived t)

  let compare op (a : number) (b : number) : truth =
    match (a, b) with
    | Ok x, Ok y -> Truth.of_bool (Law.compare_rationals op x y)
    | Error reason, _ | _, Error reason -> Undecided reason

  let not_ = Truth.not_
  let and_ = Truth.and_

  let is_false : truth -> bool = function
    | False -> true
    | True | Undecided _ -> false
end

module In_state = Terms.Make (Tuple)

(* Along the trajectory of the whole state. *)
let along c p =
  let semantics = Network_lts.semantics c in
  let predicate = Trajectory.predicate semantics p in
  fun tuple extent ->
    let state = Catalogue.decode (Network_lts.catalogue c) tuple and kept = Array.copy tuple in
    predicate (Trajectory.make ~arrived:(fun e -> Network_lts.arrived c e kept) semantics state extent)

let make c p : On_the_fly.predicate =
  let at = In_state.prop { lts = c; later = false } p in
  if not (Formula.steady ~rigid:(Option.is_some (Network_lts.model c).rigid) p) then
    { at; along = Some (along c p) }
  else if Formula.has_events (State p) then
    let later = In_state.prop { lts = c; later = true } p in
    { at; along = Some (fun tuple extent -> Timeline.after_start extent (at tuple) (later tuple)) }
  else { at; along = None }
