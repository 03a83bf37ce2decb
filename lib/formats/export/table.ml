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
  let field = Scc_base.Visible.text field in
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

(* At the start of a trajectory. *)
let at_start trajectory o =
  match o.what with
  | Number n -> (
      match (Trajectory.num trajectory n).start with
      | Undefined _ -> None
      | Ratio (n, d) -> Some (Rat.div (Polynomial.eval n Rat.zero) (Polynomial.eval d Rat.zero)))
  | Truth p -> (
      match (Trajectory.prop trajectory p).start with
      | True -> Some Rat.one
      | False -> Some Rat.zero
      | Undecided _ -> None)

let exact semantics o state = at_start (Trajectory.make semantics state Timeline.Instant) o

let value trajectory o =
  match (at_start trajectory o, o.what) with
  | None, _ -> [ ""; "" ]
  | Some r, Number _ -> number r
  | Some r, Truth _ -> if Rat.sign r = 0 then [ "false"; "0" ] else [ "true"; "1" ]

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

let header observables put =
  let both text = [ text; text ^ " (float)" ] in
  line put (both "time" @ [ "event" ] @ List.concat_map (fun o -> both o.text) observables)

(* {1 As the run is made} *)

type lines = {
  semantics : Semantics.t;
  observables : observable list;
  text : Buffer.t;
  mutable over : Rat.t;
  mutable latest : State.t;
}

let add t ~time ~last s = row (Buffer.add_string t.text) t.semantics t.observables ~time ~last s

let start semantics observables initial =
  let text = Buffer.create 4096 in
  header observables (Buffer.add_string text);
  let t = { semantics; observables; text; over = Rat.zero; latest = initial } in
  add t ~time:Rat.zero ~last:None initial;
  t

let leg t (l : Course.leg) =
  t.over <- Rat.add l.start (Transition.duration_of l.label);
  t.latest <- l.after;
  add t ~time:t.over ~last:(Some (l.before, l.label)) l.after

let finish t ~rest put =
  if Rat.sign rest > 0 then
    add t ~time:(Rat.add t.over rest) ~last:None (Time.pass t.semantics rest t.latest);
  put (Buffer.contents t.text)

(* {1 At given times} *)

let at course observables times put =
  header observables put;
  let row time = row put (Course.semantics course) observables ~time ~last:None (Course.at course time) in
  List.iter row times
