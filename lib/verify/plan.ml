open Scc_exact
open Scc_property

type t =
  | Now of Property.prop
  | Possibly of Rat.t option * Property.prop
  | Always of Rat.t option * Property.prop
  | Eventually of Rat.t option * Property.prop
  | Not_eventually of Rat.t option * Property.prop
  | All of t list
  | Any of t list

let not_yet what = Error (what ^ " cannot be checked by this version")

(* What an operator applies to must be a predicate, its bound an interval from 0. *)
let simple (bound : Property.bound) f make =
  if Rat.sign bound.low > 0 then not_yet "a time interval that does not begin at 0"
  else
    match Formula.state_formula f with
    | Some p -> Ok (make bound.high p)
    | None -> not_yet "a temporal operator inside another"

let rec all_ok acc = function
  | [] -> Ok (List.rev acc)
  | Ok x :: rest -> all_ok (x :: acc) rest
  | Error e :: _ -> Error e

(* [positive] is false under an odd number of negations. *)
let rec plan positive (f : Property.temporal) =
  match Formula.state_formula f with
  | Some p -> Ok (Now (if positive then p else Formula.negate p))
  | None -> (
      match f with
      | State p -> Ok (Now (if positive then p else Formula.negate p))
      | Temporal_not f -> plan (not positive) f
      | Temporal_and list -> connect positive ~all:positive list
      | Temporal_or list -> connect positive ~all:(not positive) list
      | Finally (Exists, bound, f) ->
        simple bound f (fun b p ->
            if positive then Possibly (b, p) else Always (b, Formula.negate p))
      | Globally (All, bound, f) ->
        simple bound f (fun b p ->
            if positive then Always (b, p) else Possibly (b, Formula.negate p))
      | Finally (All, bound, f) ->
        simple bound f (fun b p -> if positive then Eventually (b, p) else Not_eventually (b, p))
      | Globally (Exists, _, _) -> not_yet "`EG`"
      | Next _ -> not_yet "the operator `X`"
      | Until _ -> not_yet "the operator `U`")

and connect positive ~all list =
  all_ok [] (List.map (plan positive) list)
  |> Result.map (fun plans -> if all then All plans else Any plans)

let of_formula f = if Formula.has_events f then not_yet "the atom `event`" else plan true f
