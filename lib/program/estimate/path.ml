open Scc_exact
open Scc_property

type question = Does | Amounts of Property.mean * Range.t

type t = {
  check : Property.check;
  question : question;
  formula : Property.temporal;
  horizon : Rat.t option;
}

let rec about_states : Property.temporal -> bool = function
  | State _ -> true
  | Temporal_not f -> about_states f
  | Temporal_and fs | Temporal_or fs -> List.for_all about_states fs
  | Next _ | Finally _ | Globally _ | Until _ -> false

(* On the one run that there is, all runs do what it does. *)
let of_run : Property.temporal -> (Property.temporal * Rat.t option) option = function
  | Finally (_, b, f) when about_states f -> Some (Finally (All, b, f), b.high)
  | Globally (_, b, f) when about_states f -> Some (Globally (All, b, f), b.high)
  | Until (_, b, f, g) when about_states f && about_states g -> Some (Until (All, b, f, g), b.high)
  | State _ | Temporal_not _ | Temporal_and _ | Temporal_or _ | Next _ | Finally _ | Globally _ | Until _ -> None

let is_likelihood : Property.temporal -> bool = function
  | Finally (Chance _, _, _) | Globally (Chance _, _, _) | Until (Chance _, _, _, _) -> true
  | _ -> false

let nested = "what is in its brackets is about other runs: single ones do not tell"

(* How long something takes, and how often it happens, has no upper bound that is known. *)
let range model ~from : Property.mean -> Range.t = function
  | Value_at (n, time) -> Range.of_number model ~from ~time n
  | Time_until _ | Events_until _ -> Range.never_negative

let of_check ?from model (check : Property.check) =
  let made question =
    match of_run check.formula with
    | Some (formula, horizon) -> Ok { check; question; formula; horizon }
    | None -> Error nested
  in
  match check.asked with
  | How_likely _ -> made Does
  | Whether when is_likelihood check.formula -> made Does
  | Whether -> Error "no probability or mean is asked for: `scc check` decides it"
  | Expected (_, mean, _) -> made (Amounts (mean, range model ~from mean))

let atoms path =
  let of_number n = Formula.atoms (State (Compare (Eq, n, Const Rat.zero))) in
  let of_mean : Property.mean -> Atom.t list = function
    | Time_until f -> Formula.atoms f
    | Events_until (p, f) -> Formula.atoms (State p) @ Formula.atoms f
    | Value_at (n, _) -> of_number n
  in
  let of_question = match path.question with Does -> [] | Amounts (mean, _) -> of_mean mean in
  Formula.atoms path.formula @ of_question

(* An event is in the label of a transition, but for the processes of its leaves. *)
let seen paths =
  let atoms = List.concat_map atoms paths in
  let is_global (a : Atom.t) =
    match a.scope with Whole -> Option.is_none a.event && Option.is_none a.total | Named -> false
  in
  if List.exists is_global atoms then None
  else Some (List.sort_uniq Int.compare (List.concat_map Atom.leaves atoms))

let test path =
  match (path.check.asked, path.check.formula) with
  | Expected ([ side ], _, Some test), _ -> Some (side, test)
  | Whether, (Finally (Chance c, _, _) | Globally (Chance c, _, _) | Until (Chance c, _, _, _)) ->
    Some (c.side, c.test)
  | _, _ -> None
