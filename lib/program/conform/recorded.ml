open Scc_base
open Scc_exact

type kind = Bind | Close | Bounce | Absorb | Weak | Strong | Draw

type event = {
  kind : kind;
  channels : string list;
  bodies : string list;
  together : string list;
  features : string list;
  velocity : Vec.t option;
  spin : Vec.t option;
}

type quantity = Position of int | Velocity of int | Spin of int

type body = {
  name : string;
  gone : bool;
  numbers : (quantity * Rat.t) list;
  turned : (Rat.t * Vec.t) option;
  clock : Rat.t option option;
  behaviour : string option;
  origin : string option option;
  group : string list option;
  bonds : string list option;
}

type step = { remaining : Rat.t; phase : string }
type what = Event of event | State of body list * step option | Watched | Quiescent | Stuck
type choice = { number : int option; rules : string list option }
type item = { line : int; at : Span.t; time : Rat.t; what : what; choice : choice option }

type ending = { last : item; claim : string option }

type t = {
  name : string;
  format : string;
  digest : (string * Span.t) option;
  parameters : (string * Rat.t) list;
  semantics : string option;
  items : item array;
  ending : ending option;
  inexact : Span.t option;
}

let events t =
  Array.fold_left (fun n i -> match i.what with Event _ -> n + 1 | _ -> n) 0 t.items

let tells_draws t =
  Array.exists (fun i -> match i.what with Event { kind = Draw; _ } -> true | _ -> false) t.items

let kinds =
  [
    ("bind", Bind); ("close", Close); ("bounce", Bounce); ("absorb", Absorb); ("weak", Weak); ("strong", Strong);
    ("draw", Draw);
  ]
let kind_of_name name = List.assoc_opt name kinds
let kind_name kind = fst (List.find (fun (_, k) -> k = kind) kinds)
let sort = List.sort String.compare

let normal feature =
  let n = String.length feature in
  match String.rindex_opt feature '.' with
  | _ when n < 2 || feature.[n - 1] <> ']' -> feature
  | Some i when i + 1 < n && feature.[i + 1] = '[' ->
    let inner = String.sub feature (i + 2) (n - i - 3) in
    let names = sort (List.map String.trim (String.split_on_char ',' inner)) in
    String.sub feature 0 (i + 2) ^ String.concat "," names ^ "]"
  | Some _ | None -> feature

let bond_text name ends = Printf.sprintf "<%s, {%s}>" name (String.concat ", " (sort ends))

let event_text e =
  let parts =
    match (e.together, e.features) with
    | _ :: _ :: _, _ -> e.together
    | _, [] -> e.channels @ e.bodies
    | _, features -> e.channels @ features
  in
  let drawn = List.map Vec.to_string (Option.to_list e.velocity @ Option.to_list e.spin) in
  Printf.sprintf "%s(%s)" (kind_name e.kind) (String.concat ", " (parts @ drawn))

let axis prefix i = prefix ^ String.make 1 "xyz".[i]

let quantity_text = function
  | Position i -> axis "" i
  | Velocity i -> axis "v" i
  | Spin i -> axis "w" i

let malformed span fmt = Diag.error Code.bad_trace span fmt

let literal s =
  let is_float = String.exists (function '.' | 'e' | 'E' -> true | _ -> false) s in
  match Rat.of_literal s with Ok q -> Some (q, is_float) | Error _ -> None

(* The shortest decimal that is this float: the one that was written, unless it had more than 17 digits. *)
let decimal x =
  let short = Printf.sprintf "%.15g" x in
  if Float.equal (float_of_string short) x then short else Printf.sprintf "%.17g" x

let number : Yojson.Basic.t -> (Rat.t * bool) option = function
  | `Int i -> Some (Rat.of_int i, false)
  | `Float x when Float.is_finite x -> Option.map (fun (q, _) -> (q, true)) (literal (decimal x))
  | `String s -> literal s
  | _ -> None
