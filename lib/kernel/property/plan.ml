open Scc_exact

type t =
  | Now of Property.prop
  | Possibly of Rat.t option * Property.prop
  | Always of Rat.t option * Property.prop
  | Formula of Property.temporal
  | All of t list
  | Any of t list

let from_now (b : Property.bound) = Rat.sign b.low = 0

(* [positive] is false under an odd number of negations. *)
let rec plan positive (f : Property.temporal) =
  let whole () = Formula (if positive then f else Temporal_not f) in
  match Formula.state_formula f with
  | Some p -> Now (if positive then p else Formula.negate p)
  | None -> (
      match f with
      | Temporal_not f -> plan (not positive) f
      | Temporal_and list -> connect positive ~all:positive list
      | Temporal_or list -> connect positive ~all:(not positive) list
      | Finally (Exists, bound, g) when from_now bound -> (
          match Formula.state_formula g with
          | Some p when positive -> Possibly (bound.high, p)
          | Some p -> Always (bound.high, Formula.negate p)
          | None -> whole ())
      | Globally (All, bound, g) when from_now bound -> (
          match Formula.state_formula g with
          | Some p when positive -> Always (bound.high, p)
          | Some p -> Possibly (bound.high, Formula.negate p)
          | None -> whole ())
      | State _ | Next _ | Until _ | Finally _ | Globally _ -> whole ())

and connect positive ~all list =
  let plans = List.map (plan positive) list in
  if all then All plans else Any plans

let of_formula f = plan true f

let rec is_search = function
  | Now _ | Possibly _ | Always _ -> true
  | Formula _ -> false
  | All plans | Any plans -> List.for_all is_search plans

let rec searches : t -> Property.temporal list = function
  | Now p -> [ State p ]
  | Possibly (high, p) -> [ Finally (Exists, { low = Rat.zero; high }, State p) ]
  | Always (high, p) -> [ Globally (All, { low = Rat.zero; high }, State p) ]
  | Formula f -> [ f ]
  | All plans | Any plans -> List.concat_map searches plans

type reach = { time : Rat.t; events : int }

let latest reaches =
  let later a b = { time = Rat.max a.time b.time; events = Int.max a.events b.events } in
  List.fold_left (Option.map2 later) (Some { time = Rat.zero; events = 0 }) reaches

(* The next event may be however late, so a bound of time that is to be counted from there gives no end. *)
let rec reach (f : Property.temporal) =
  match f with
  | State _ -> latest []
  | Temporal_not f -> reach f
  | Temporal_and fs | Temporal_or fs -> latest (List.map reach fs)
  | Next (_, f) ->
    let after f = if Rat.sign f.time = 0 then Some { f with events = f.events + 1 } else None in
    Option.bind (reach f) after
  | Finally (_, b, f) | Globally (_, b, f) -> after b (reach f)
  | Until (_, b, f, g) -> after b (latest [ reach f; reach g ])

and after b f = Option.map2 (fun high f -> { f with time = Rat.add high f.time }) b.high f

let latest_horizon formulas =
  match latest (List.map reach formulas) with
  | Some { time; events = 0 } -> Some time
  | Some _ | None -> None
