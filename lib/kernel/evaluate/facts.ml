open Scc_exact
open Scc_ctl
open Scc_semantics
open Scc_property

(* More atoms than this do not help anyone. *)
let most = 16

let is_constant = function Property.Const _ -> true | _ -> false

let value trajectory model offset n =
  let value = Value.at (Timeline.at (Trajectory.num trajectory n) offset) offset in
  match String.length value >= 6 && String.equal (String.sub value 0 6) "about " with
  | true -> Printf.sprintf "%s is %s" (Show.num model n) value
  | false -> Printf.sprintf "%s = %s" (Show.num model n) value

let changes_with_time model n = Time_seen.same_kind (Time_seen.num model n) Always

(* Of a time that stands for all later ones nothing else is known. *)
let values ?later_than ~known trajectory model offset (p : Property.prop) =
  match p with
  | Compare (_, a, b) ->
    let is_told n = (not (is_constant n)) && List.for_all known (By_cases.values n) in
    let compared = List.filter is_told [ a; b ] in
    (match later_than with
     | Some c when List.exists (changes_with_time model) compared ->
       [ Printf.sprintf "time > %s" (Rat.to_string c) ]
     | Some _ | None -> List.map (value trajectory model offset) compared)
  | _ -> []

let fact ?later_than ~known trajectory model offset p =
  let text = Show.prop model p in
  let values = values ?later_than ~known trajectory model offset p in
  match (Timeline.at (Trajectory.prop trajectory p) offset, values) with
  | Truth.Undecided reason, _ -> Printf.sprintf "%s cannot be decided: %s" text reason
  | (True | False) as truth, values ->
    let verb = if Truth.equal truth True then "holds" else "fails" in
    let why = match values with [] -> "" | _ -> ": " ^ String.concat ", " values in
    Printf.sprintf "%s %s%s" text verb why

let every trajectory model offset p =
  let known _ = true in
  List.map (fun atom -> fact ~known trajectory model offset atom) (Show.atoms p)

let at ?arrived ?later_than ?(known = fun _ -> true) semantics state extent offset p =
  let model = Semantics.model semantics in
  let trajectory = Trajectory.make ?arrived semantics state extent in
  let atoms = Show.atoms p in
  let shown = List.map (fact ?later_than ~known trajectory model offset) (Scc_data.Lists.take most atoms) in
  let more = List.length atoms - most in
  if more > 0 then shown @ [ Printf.sprintf "and %d more atoms" more ] else shown
