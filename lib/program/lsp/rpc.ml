open Scc_base
open Scc_json

type message =
  | Request of { id : Json.t; name : string; params : Json.t }
  | Notification of { name : string; params : Json.t }
  | Response of { id : Json.t; result : Json.t option }
  | Invalid of { id : Json.t; code : int; why : string }

exception Refused of int * string

let refuse code fmt = Printf.ksprintf (fun why -> raise (Refused (code, why))) fmt
let parse_error = -32700
let invalid_request = -32600
let unknown_method = -32601
let invalid_params = -32602
let internal_error = -32603
let not_initialized = -32002
let failed = -32803
let cancelled = -32800

let of_object json =
  let id = Option.value (Json.member "id" json) ~default:`Null in
  let params = Option.value (Json.member "params" json) ~default:`Null in
  let has_id = match id with `Int _ | `String _ -> true | _ -> false in
  let invalid why = Invalid { id = (if has_id then id else `Null); code = invalid_request; why } in
  let version = Option.bind (Json.member "jsonrpc" json) Json.string in
  let has_method = match json with `Assoc members -> List.mem_assoc "method" members | _ -> false in
  let name = Option.bind (Json.member "method" json) Json.string in
  match (name, Json.member "result" json, Json.member "error" json) with
  | _ when version <> Some "2.0" -> invalid "`jsonrpc` is not \"2.0\""
  | None, _, _ when has_method -> invalid "`method` is no text"
  | Some name, None, None -> (
      match (id, params) with
      | _, (`Bool _ | `Int _ | `Float _ | `String _) -> invalid "`params` is neither an object nor an array"
      | `Null, _ -> Notification { name; params }
      | _ when has_id -> Request { id; name; params }
      | _ -> invalid "`id` is neither an integer nor a text")
  | Some _, _, _ -> invalid "a message with a method has no result and no error"
  | None, result, None when has_id -> Response { id; result = Some (Option.value result ~default:`Null) }
  | None, _, Some _ when has_id -> Response { id; result = None }
  | None, _, _ -> invalid "it is no request, notification or response"

let is_utf_8 text =
  let n = String.length text in
  let rec from i = i >= n || match Utf8.length text i with 0 -> false | k -> from (i + k) in
  from 0

let read text =
  let invalid code why = Invalid { id = `Null; code; why } in
  if not (is_utf_8 text) then invalid parse_error "the message is not in UTF-8"
  else match Json.parse (Source.make ~name:"message" text) with
    | Error _ when String.trim text = "" -> invalid parse_error "the message is empty"
    | Error d -> invalid parse_error ("the message cannot be read: " ^ d.message)
    | Ok (`Assoc _ as json) -> of_object json
    | Ok (`List _) -> invalid invalid_request "the protocol has no batches"
    | Ok _ -> invalid invalid_request "a message is an object"

let same_id (a : Json.t) (b : Json.t) =
  match (a, b) with
  | `Int a, `Int b -> Int.equal a b
  | `String a, `String b -> String.equal a b
  | _ -> false

(* {1 Params} *)

let member name json =
  match Json.member name json with
  | Some value -> value
  | None -> refuse invalid_params "the params have no `%s`" name

let of_kind what get name json =
  match get (member name json) with
  | Some x -> x
  | None -> refuse invalid_params "`%s` is no %s" name what

let string = of_kind "text" Json.string
let int = of_kind "integer" Json.int
let list = of_kind "array" Json.list
let position json = (int "line" json, int "character" json)

(* {1 Messages of the server} *)

let message members : Json.t = `Assoc (("jsonrpc", `String "2.0") :: members)
let answer ~id result = message [ ("id", id); ("result", result) ]

let error ~id code why =
  message [ ("id", id); ("error", `Assoc [ ("code", `Int code); ("message", Json.text why) ]) ]

let notification name params = message [ ("method", `String name); ("params", params) ]
let request ~id name params = message [ ("id", `Int id); ("method", `String name); ("params", params) ]
