open Scc_exact
open Scc_property
open Scc_calculus
open Scc_semantics
open Scc_ctl
open Scc_motion
open Scc_evaluate

type observable = { text : string; what : what }
and what = Number of Property.num | Truth of Property.prop

(* {1 Lines} *)

let quoted field =
  if String.exists (function ',' | '"' | '\n' | '\r' -> true | _ -> false) field then
    "\"" ^ String.concat "\"\"" (String.split_on_char '"' field) ^ "\""
  else field

let line put fields =
  put (String.concat "," (List.map quoted fields));
  put "\r\n"

let number r =
  let rounded = match Floats.of_rat r with x -> Floats.text x | exception Floats.Too_great -> "" in
  [ Rat.to_string r; rounded ]

(* {1 Values} *)

let value trajectory o =
  match o.what with
  | Number n -> (
      match (Trajectory.num trajectory n).start with
      | Undefined _ -> [ ""; "" ]
      | Ratio (n, d) ->
        let at_start p = Polynomial.eval p Rat.zero in
        number (Rat.div (at_start n) (at_start d)))
  | Truth p -> (
      match (Trajectory.prop trajectory p).start with
      | True -> [ "true"; "1" ]
      | False -> [ "false"; "0" ]
      | Undecided _ -> [ ""; "" ])

let row put semantics observables ~time ~last (s : State.t) =
  let arrived event =
    match last with None -> false | Some (source, label) -> Event.matches ~source label event
  in
  let trajectory = Trajectory.make ~arrived semantics s Timeline.Instant in
  let event =
    match last with
    | None | Some (_, Transition.Time _) -> ""
    | Some (_, label) -> Transition.label_to_string (Semantics.model semantics) label
  in
  line put (number time @ [ event ] @ List.concat_map (value trajectory) observables)

let header observables =
  let both text = [ text; text ^ " (float)" ] in
  both "time" @ [ "event" ] @ List.concat_map (fun o -> both o.text) observables

let file (f : Film.t) course observables ~every put =
  let semantics = Course.semantics course in
  let row = row put semantics observables in
  line put (header observables);
  match every with
  | Some _ -> List.iter (fun time -> row ~time ~last:None (Course.at course time)) (Film.instants f ~every)
  | None ->
    row ~time:Rat.zero ~last:None (Course.initial course);
    let leg (l : Course.leg) =
      let time = Rat.add l.start (Transition.duration_of l.label) in
      row ~time ~last:(Some (l.before, l.label)) l.after
    in
    Array.iter leg (Course.legs course);
    if Rat.sign (Course.rest course) > 0 then
      let time = Course.duration course in
      row ~time ~last:None (Course.at course time)
