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

let rec horizon (f : Property.temporal) =
  match f with
  | State _ -> Some Rat.zero
  | Temporal_not f -> horizon f
  | Temporal_and fs | Temporal_or fs -> latest_horizon fs
  | Next _ -> None
  | Finally (_, b, f) | Globally (_, b, f) -> Option.map2 Rat.add b.high (horizon f)
  | Until (_, b, f, g) -> Option.map2 Rat.add b.high (latest_horizon [ f; g ])

and latest_horizon formulas =
  List.fold_left (fun latest f -> Option.map2 Rat.max latest (horizon f)) (Some Rat.zero) formulas
