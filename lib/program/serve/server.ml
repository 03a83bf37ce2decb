open Lwt.Syntax
open Cohttp
open Scc_json
open Scc_view
module Server = Cohttp_lwt.Make_server (Connections)

type how = {
  desk : Desk.t;
  port : int option;
  desk_process : string array;
  document_process : check:Json.t -> seconds:float option -> (string array, string) result;
  listening : string -> unit;
}

type t = {
  how : how;
  access : Access.t;
  documents : Documents.t;
  mutable helper : Child.t option;  (** of who writes, started when it is asked *)
}

(* {1 Limits} *)

let most_bytes = 8 * Scc_base.Memory.mib
let most_connections = 200
let seconds_to_read = 10.
let seconds_of_connection = 120.
let seconds_for_help = 30.
let seconds_for_news = 1.

(* {1 Answers} *)

type answer = { status : Code.status_code; kind : string; body : string }

let json ?(status = `OK) value = { status; kind = "application/json"; body = Json.line value ^ "\n" }
let text_json text = { status = `OK; kind = "application/json"; body = text ^ "\n" }
let page body = { status = `OK; kind = "text/html; charset=utf-8"; body }
let refused status why = json ~status (`Assoc [ ("error", Json.text why) ])
let done_ = json (`Assoc [])

(* Pages of other servers cannot frame these, and get nothing of them. *)
let headers kind =
  Header.of_list
    [
      ("content-type", kind);
      ("cache-control", "no-store");
      ("connection", "close");
      ("content-security-policy", "frame-ancestors 'self'");
      ("cross-origin-opener-policy", "same-origin");
      ("cross-origin-resource-policy", "same-origin");
      ("referrer-policy", "no-referrer");
      ("x-content-type-options", "nosniff");
    ]

let respond a = Server.respond_string ~headers:(headers a.kind) ~status:a.status ~body:a.body ()

let failure : Child.failure -> answer = function
  | Over -> refused `Gone "the process that could answer has ended"
  | Too_slow -> refused `Gateway_timeout "there was no answer in time: its process has been ended"
  | Busy -> refused `Service_unavailable "too many questions wait for an answer: try again in a moment"

let no_document = refused `Gone "this document is over"

(* {1 Pages} *)

let written write =
  let b = Buffer.create 1_000_000 in
  write (Buffer.add_string b);
  page (Buffer.contents b)

let desk_page t =
  let data put = put (Json.line (Desk.page_data t.how.desk)) in
  written (Page.desk ~title:(t.how.desk.name ^ " – scc") data)

let view_page t d =
  let* answer = Documents.ask d "document" in
  let shown text = written (Page.write ~served:true ~title:(t.how.desk.name ^ " – scc") (fun put -> put text)) in
  Lwt.return (match answer with Ok text -> shown text | Error f -> failure f)

(* {1 Questions to processes} *)

(* A request is a line; ends of lines in it stand between its values alone. *)
let on_one_line = String.map (function '\n' | '\r' -> ' ' | c -> c)

let answered = function Ok text -> text_json text | Error f -> failure f

let helper t =
  match t.helper with
  | Some child when Child.alive child -> child
  | Some _ | None ->
    let child = Child.start t.how.desk_process in
    t.helper <- Some child;
    child

let ask_helper t body =
  Lwt.map answered (Child.ask (helper t) ~seconds:seconds_for_help (on_one_line body))

let ask_document d body =
  if Documents.is_ready d then Lwt.map answered (Documents.ask d (on_one_line body)) else Lwt.return no_document

(* {1 Documents} *)

let object_of body =
  match Json.parse (Scc_base.Source.make ~name:"request" body) with
  | Ok (`Assoc _ as json) -> Ok json
  | Ok _ | Error _ -> Error (refused `Bad_request "the request is no JSON object")

let text_member name json =
  match Option.bind (Json.member name json) Json.string with
  | Some text -> Ok text
  | None -> Error (refused `Bad_request (Printf.sprintf "the request has no text `%s`" name))

let seconds json : (float option, answer) result =
  match Json.member "seconds" json with
  | None -> Ok None
  | Some (`Int n) when n > 0 -> Ok (Some (float_of_int n))
  | Some _ -> Error (refused `Bad_request "`seconds` is a positive integer")

let ( let+ ) = Result.bind
let either = function Ok a | Error a -> a

let open_document t body =
  either
    (let+ json_in = object_of body in
     let+ text = text_member "text" json_in in
     let+ seconds = seconds json_in in
     let check = Option.value (Json.member "check" json_in) ~default:(`String "none") in
     let+ arguments = Result.map_error (refused `Bad_request) (t.how.document_process ~check ~seconds) in
     match Documents.opened t.documents arguments ~text with
     | Some id -> Ok (json (`Assoc [ ("document", `String id) ]))
     | None -> Error (refused `Service_unavailable "too many documents are being made: end one of them first"))

let save t body =
  either
    (let+ json_in = object_of body in
     let+ text = text_member "text" json_in in
     let over = Option.bind (Json.member "saved" json_in) Json.string in
     match Desk.save t.how.desk ~text ~over with
     | Saved digest -> Ok (json (`Assoc [ ("saved", `String digest) ]))
     | Failed why -> Error (refused `Bad_request why)
     | Another { text; digest } ->
       let why = "the file has been changed by somebody else since it was read" in
       let there = [ ("error", Json.text why); ("text", Json.text text); ("saved", `String digest) ] in
       Error (json ~status:`Conflict (`Assoc there)))

(* {1 Requests} *)

let now a = Lwt.return a

let get t path =
  match String.split_on_char '/' path with
  | [ "" ] -> now (desk_page t)
  | [ "view"; id; "" ] -> (
      match Documents.find t.documents id with
      | Some d when Documents.is_ready d -> view_page t d
      | Some _ | None -> now no_document)
  | _ -> now (refused `Not_found "there is no such page")

let of_document t d what body =
  match what with
  | "status" -> Lwt.map json (Documents.status d ~seconds:seconds_for_news)
  | "ask" -> ask_document d body
  | "stop" ->
    Documents.interrupt d;
    now done_
  | "close" ->
    Lwt.map (fun () -> done_) (Documents.close t.documents d)
  | _ -> now (refused `Not_found "there is no such request")

let post t path body =
  match String.split_on_char '/' path with
  | [ "ask" ] -> ask_helper t body
  | [ "open" ] -> now (open_document t body)
  | [ "save" ] -> now (save t body)
  | [ "view"; id; what ] -> (
      match Documents.find t.documents id with
      | Some d -> of_document t d what body
      | None -> now no_document)
  | _ -> now (refused `Not_found "there is no such request")

let in_time ~late f =
  Lwt.catch
    (fun () -> Lwt_unix.with_timeout seconds_to_read f)
    (function Lwt_unix.Timeout -> Lwt.return late | e -> Lwt.fail e)

let too_large = refused `Request_entity_too_large "the request is too large"

(* What is sent of a body that is too large is read, as many a client hears nothing before it has said all, and is
   not kept. *)
let read_body body =
  let b = Buffer.create 4096 and size = ref 0 in
  let add part =
    size := !size + String.length part;
    if !size <= most_bytes then Buffer.add_string b part
  in
  in_time ~late:(Error (refused `Request_timeout "the request took too long to come")) (fun () ->
      let* () = Lwt_stream.iter add (Cohttp_lwt.Body.to_stream body) in
      if !size > most_bytes then Lwt.return_error too_large else Lwt.return_ok (Buffer.contents b))

let is_json request =
  match Header.get (Request.headers request) "content-type" with
  | Some kind -> String.equal (List.hd (String.split_on_char ';' kind)) "application/json"
  | None -> false

let granted t request =
  let header = Header.get (Request.headers request) in
  Access.granted t.access ~resource:(Request.resource request) ~host:(header "host") ~origin:(header "origin")

(* Of two values, other programs may have looked at another one than is looked at here. *)
let repeated request =
  let is_repeated name = List.compare_length_with (Header.get_multi (Request.headers request) name) 1 > 0 in
  List.find_opt is_repeated [ "Host"; "Origin"; "Content-Type"; "Content-Length"; "Transfer-Encoding" ]

let has_a_length request =
  let is_digit c = c >= '0' && c <= '9' in
  match Header.get (Request.headers request) "content-length" with
  | Some text -> String.length text > 0 && String.for_all is_digit text
  | None -> true

let admitted t request =
  match (repeated request, granted t request) with
  | Some name, _ -> Error (refused `Bad_request (Printf.sprintf "the request has more than one header `%s`" name))
  | None, Error why -> Error (refused `Forbidden why)
  | None, Ok _ when not (has_a_length request) ->
    Error (refused `Bad_request "the header `Content-Length` is no number")
  | None, Ok path -> Ok path

let answer t request path body =
  match Request.meth request with
  | `GET -> get t path
  | `POST when not (is_json request) -> now (refused `Unsupported_media_type "a request is JSON")
  | `POST -> (
      let* body = read_body body in
      match body with Ok body -> post t path body | Error a -> now a)
  | _ -> now (refused `Method_not_allowed "GET and POST are what can be asked")

let guarded f =
  Lwt.catch f (fun e ->
      match Scc_system.Resources.refused e with
      | Some what -> now (refused `Service_unavailable what)
      | None -> now (refused `Internal_server_error ("a fault of scc: " ^ Printexc.to_string e)))

(* Each connection is for one request, so that none stays open for nothing: it hears no more. The body of a request
   that is not admitted is not waited for. *)
let callback t (connection, _) request body =
  let* a =
    match admitted t request with
    | Error a -> now a
    | Ok path ->
      Connections.hear_body connection;
      let* a = guarded (fun () -> answer t request path body) in
      let* () = in_time ~late:() (fun () -> Cohttp_lwt.Body.drain_body body) in
      now a
  in
  Connections.hear_no_more connection;
  respond a

(* {1 Listening} *)

let listen port =
  let address = Unix.ADDR_INET (Unix.inet_addr_loopback, Option.value port ~default:0) in
  Lwt.catch
    (fun () ->
       let socket = Lwt_unix.socket ~cloexec:true PF_INET SOCK_STREAM 0 in
       Lwt_unix.setsockopt socket SO_REUSEADDR true;
       let* () = Lwt_unix.bind socket address in
       Lwt_unix.listen socket 1024;
       Lwt.return_ok socket)
    (function
      | Unix.Unix_error (e, _, _) -> Lwt.return_error (Unix.error_message e)
      | e -> Lwt.fail e)

let port_of socket = match Lwt_unix.getsockname socket with ADDR_INET (_, port) -> port | ADDR_UNIX _ -> 0

let until_signalled () =
  let stop, wake = Lwt.wait () in
  let once _ = if Lwt.is_sleeping stop then Lwt.wakeup_later wake () in
  List.iter (fun s -> ignore (Lwt_unix.on_signal s once)) Scc_system.Interruption.signals;
  stop

let serve how socket access =
  let t = { how; access; documents = Documents.create (); helper = None } in
  let stop = until_signalled () in
  how.listening (Access.address access);
  let* () =
    Connections.serve ~stop ~most:most_connections ~head_seconds:seconds_to_read ~seconds:seconds_of_connection
      socket
      (Server.callback (Server.make ~callback:(callback t) ()))
  in
  let* () = Documents.close_all t.documents in
  Option.fold t.helper ~none:Lwt.return_unit ~some:Child.discard

let run how =
  Lwt_main.run
    (let* socket = listen how.port in
     match socket with
     | Error why -> Lwt.return_error why
     | Ok socket -> (
         match Access.make ~port:(port_of socket) with
         | Error why -> Lwt.return_error why
         | Ok access -> Lwt.map Result.ok (serve how socket access)))
