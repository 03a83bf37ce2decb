open Scc_json

type question = { id : Json.t; uri : string; work : unit -> Json.t; mutable job : Job.t option }
type t = { send : string -> unit; mutable questions : question list  (* in the order of their requests *) }

let most_running = 2

(* The protocol's code for an answer about a text that is not the present one. *)
let content_modified = -32801
let create ~send = { send; questions = [] }
let jobs t = List.filter_map (fun q -> q.job) t.questions
let leave t q = t.questions <- List.filter (fun other -> other != q) t.questions

let end_ t q code why =
  Option.iter Job.kill q.job;
  leave t q;
  t.send (Json.line (Rpc.error ~id:q.id code why))

(* The whole message is written there. *)
let answer q =
  Json.line
    (match q.work () with
     | json -> Rpc.answer ~id:q.id json
     | exception Rpc.Refused (code, why) -> Rpc.error ~id:q.id code why)

let ended t q found =
  leave t q;
  let lost () = Json.line (Rpc.error ~id:q.id Rpc.internal_error "the process that worked on it came to an end") in
  t.send (match found with Some text -> text | None -> lost ())

let start t q =
  let work _ = answer q in
  match Job.start ~work ~progress:ignore ~ended:(ended t q) with
  | Some job -> q.job <- Some job
  | None -> end_ t q Rpc.failed "the system gives no process"

let go_on t =
  let waiting = List.filter (fun q -> Option.is_none q.job) t.questions in
  let room = Int.max 0 (most_running - List.length (jobs t)) in
  List.iter (start t) (Scc_data.Lists.take room waiting)

let ask t ~id ~uri work =
  t.questions <- List.append t.questions [ { id; uri; work; job = None } ];
  go_on t

let changed t uri =
  let about = List.filter (fun q -> String.equal q.uri uri) t.questions in
  List.iter (fun q -> end_ t q content_modified "the document has changed") about

let cancel t id =
  match List.find_opt (fun q -> Rpc.same_id q.id id) t.questions with
  | Some q ->
    end_ t q Rpc.cancelled "the request was cancelled";
    true
  | None -> false

let close t =
  List.iter (fun q -> Option.iter Job.kill q.job) t.questions;
  t.questions <- []
