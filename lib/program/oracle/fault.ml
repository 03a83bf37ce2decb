open Scc_json
open Scc_runs

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

let code = function
  | Parse _ -> -32700
  | Invalid_request _ -> -32600
  | No_method _ -> -32601
  | Invalid_params _ -> -32602
  | Internal _ -> -32603
  | Limit _ -> -32000
  | Unknown_handle _ -> -32001
  | Shape_refused _ -> -32002
  | Model_refused _ -> -32003
  | Stopped _ -> -32004
  | Not_possible _ -> -32005
  | No_transitions _ -> -32006
  | Formula_refused _ -> -32007
  | Not_in_contact _ -> -32008

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

let members = function
  | Parse (offset, _) -> [ ("offset", `Int offset) ]
  | Invalid_request _ -> []
  | No_method name -> [ ("method", Json.text name) ]
  | Invalid_params (at, _) -> [ ("at", Json.text (place at)) ]
  | Internal what -> [ ("what", Json.text what) ]
  | Limit (name, most) -> [ ("limit", `String name); ("most", `Int most) ]
  | Unknown_handle handle -> [ ("handle", Json.text handle) ]
  | Shape_refused faults -> [ ("faults", `List faults) ]
  | Stopped Seconds -> [ ("limit", `String "seconds") ]
  | Stopped Memory -> [ ("limit", `String "memory") ]
  | Not_possible { at; possible; _ } ->
    [ ("at", `Int at); ("possible", `List (List.map Json.text possible)) ]
  | No_transitions { at; diagnostics } -> [ ("at", `Int at); ("diagnostics", `List diagnostics) ]
  | Model_refused diagnostics | Formula_refused diagnostics -> [ ("diagnostics", `List diagnostics) ]
  | Not_in_contact { at; relation } -> [ ("at", `Int at); ("relation", `String relation) ]

let data fault = `Assoc (members fault)
let diagnostics ~source list = List.map (Diag_json.diagnostic ~source) list
