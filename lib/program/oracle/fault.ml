open Scc_json
open Scc_runs
open Json_format

type stop = Seconds | Memory
type place = Member of string | Item of place * int | Within of place * string

type t =
  | Parse of int * string
  | Invalid_request of string
  | No_method of string
  | Invalid_params of place * string
  | Internal of string
  | Limit of string * int
  | Unknown_handle of string
  | Shape_refused of Json.t list
  | Model_refused of Json.t list
  | Stopped of stop
  | Not_possible of { at : int; possible : string list; message : string }
  | No_transitions of { at : int; diagnostics : Json.t list }
  | Formula_refused of Json.t list
  | Not_in_contact of { at : int; relation : string }

exception Refused of t

let refuse fault = raise (Refused fault)
let invalid place fmt = Printf.ksprintf (fun s -> refuse (Invalid_params (place, s))) fmt

let rec place = function
  | Member name -> name
  | Item (p, i) -> Printf.sprintf "%s[%d]" (place p) i
  | Within (p, name) -> place p ^ "." ^ name

(* The first of some reasons speaks for all. *)
let first what reasons =
  match List.find_map (fun r -> Option.bind (Json.member "message" r) Json.string) reasons with
  | Some reason -> what ^ ": " ^ reason
  | None -> what

let message = function
  | Parse (_, why) -> "this is not JSON: " ^ why
  | Invalid_request why -> "invalid request: " ^ why
  | No_method name -> Printf.sprintf "there is no method `%s`" name
  | Invalid_params (at, why) -> Printf.sprintf "invalid params: %s: %s" (place at) why
  | Internal what -> "internal error: " ^ what
  | Limit (name, most) -> Printf.sprintf "the limit `%s` is %d" name most
  | Unknown_handle handle -> Printf.sprintf "there is no `%s`" handle
  | Shape_refused faults -> first "no convex closed polyhedron" faults
  | Model_refused diagnostics -> first "the model is refused" diagnostics
  | Stopped Seconds -> "the request took more time than it may"
  | Stopped Memory -> "the request took more memory than there is"
  | Not_possible { message; _ } -> message
  | No_transitions { diagnostics; _ } -> first "the transitions cannot be computed" diagnostics
  | Formula_refused diagnostics -> first "the formula is refused" diagnostics
  | Not_in_contact { at; relation } -> Printf.sprintf "pair %d of `touching` is %s" at relation

(* The code of one kind of faults, and its data. *)
type kind = Kind : int * (t -> 'a option) * ('a, unit) members -> kind

let kinds =
  let at part = field "at" natural part in
  let rendered t = list ~least:1 (json ~schema:(schema t) ()) in
  let diagnostics part = field "diagnostics" (rendered Diag_json.format) part in
  [
    Kind (-32700, (function Parse (at, _) -> Some at | _ -> None), field "offset" natural Fun.id);
    Kind (-32600, (function Invalid_request _ -> Some () | _ -> None), all []);
    Kind (-32601, (function No_method name -> Some name | _ -> None), field "method" text Fun.id);
    Kind (-32602, (function Invalid_params (at, _) -> Some at | _ -> None), field "at" text place);
    Kind (-32603, (function Internal what -> Some what | _ -> None), field "what" text Fun.id);
    Kind
      ( -32000,
        (function Limit (name, most) -> Some (name, most) | _ -> None),
        all [ field "limit" text fst; field "most" natural snd ] );
    Kind (-32001, (function Unknown_handle handle -> Some handle | _ -> None), field "handle" text Fun.id);
    Kind
      ( -32002,
        (function Shape_refused faults -> Some faults | _ -> None),
        field "faults" (rendered Scc_reports.Shape_json.fault) Fun.id );
    Kind (-32003, (function Model_refused all -> Some all | _ -> None), diagnostics Fun.id);
    Kind
      ( -32004,
        (function Stopped Seconds -> Some "seconds" | Stopped Memory -> Some "memory" | _ -> None),
        field "limit" (word Fun.id [ "seconds"; "memory" ]) Fun.id );
    Kind
      ( -32005,
        (function Not_possible { at; possible; _ } -> Some (at, possible) | _ -> None),
        all [ at fst; field "possible" Shared.texts snd ] );
    Kind
      ( -32006,
        (function No_transitions { at; diagnostics } -> Some (at, diagnostics) | _ -> None),
        all [ at fst; diagnostics snd ] );
    Kind (-32007, (function Formula_refused all -> Some all | _ -> None), diagnostics Fun.id);
    Kind
      ( -32008,
        (function Not_in_contact { at; relation } -> Some (at, relation) | _ -> None),
        all [ at fst; field "relation" (word Fun.id [ "apart"; "interpenetrating" ]) snd ] );
  ]

let format =
  let of_kind (Kind (code, part, data)) =
    let error =
      fields
        [ fixed "code" (`Int code); field "message" some_text fst; field "data" (obj data) snd ]
    in
    case error (fun fault -> Option.map (fun data -> (message fault, data)) (part fault)) ignore
  in
  union (List.map of_kind kinds) |> named ~file:"oracle" "error"

let diagnostics ~source list = List.map (Diag_json.diagnostic ~source) list
