open Scc_base
open Scc_json

type work = {
  decide :
    read_file:(string -> (string, string) result) ->
    progress:(string -> unit) ->
    check:string option ->
    Source.t ->
    (Session.verdict list, Diag.t list) result;
  page :
    read_file:(string -> (string, string) result) ->
    progress:(string -> unit) ->
    check:string option ->
    Source.t ->
    string ->
    (unit, Diag.t list) result;
}

(* What is shown of the progress of a command: nothing, or under a token that the client may have to make first. *)
type shown = Nowhere | Under of { token : Json.t; mutable begun : bool; asked : int option }
type running = { id : Json.t; job : Job.t; shown : shown; title : string }

type t = {
  work : work;
  session : Session.t;
  send : Json.t -> unit;
  decided : Workspace.document -> unit;
  mutable running : running list;
  mutable serial : int;  (* of the last request to the client *)
  mutable folder : string option;  (* of pages *)
  mutable pages : string list;
}

let check_name = "scc.check"
let run_name = "scc.showRun"
let names = [ check_name; run_name ]
let most_running = 4

let create work session ~send ~decided =
  { work; session; send; decided; running = []; serial = 0; folder = None; pages = [] }

let jobs t = List.map (fun r -> r.job) t.running

let ask t name params =
  t.serial <- t.serial + 1;
  t.send (Rpc.request ~id:t.serial name params)

(* {1 Progress} *)

let progress t token (value : (string * Json.t) list) =
  t.send (Rpc.notification "$/progress" (`Assoc [ ("token", token); ("value", `Assoc value) ]))

let begin_ t token title =
  progress t token [ ("kind", `String "begin"); ("title", Json.text title); ("cancellable", `Bool true) ]

let shown t params title =
  match Json.member "workDoneToken" params with
  | Some ((`Int _ | `String _) as token) ->
    begin_ t token title;
    Under { token; begun = true; asked = None }
  | _ when t.session.client.progress ->
    let token = `String (Printf.sprintf "scc-%d" (t.serial + 1)) in
    ask t "window/workDoneProgress/create" (`Assoc [ ("token", token) ]);
    Under { token; begun = false; asked = Some t.serial }
  | _ -> Nowhere

let answered t id =
  let is_it r =
    match (r.shown, id) with
    | Under u, `Int n when u.asked = Some n && not u.begun ->
      u.begun <- true;
      begin_ t u.token r.title
    | _ -> ()
  in
  List.iter is_it t.running

let report t shown line =
  match shown with
  | Under { token; begun = true; _ } ->
    progress t token [ ("kind", `String "report"); ("message", Json.text line) ]
  | Under _ | Nowhere -> ()

let end_ t shown =
  match shown with
  | Under { token; begun = true; _ } -> progress t token [ ("kind", `String "end") ]
  | Under _ | Nowhere -> ()

(* {1 Running} *)

let is id r = Rpc.same_id r.id id

let leave t r =
  t.running <- List.filter (fun other -> not (is r.id other)) t.running;
  end_ t r.shown

let cancelled t r =
  Job.kill r.job;
  leave t r;
  t.send (Rpc.error ~id:r.id Rpc.cancelled "the command was cancelled")

let cancel t id =
  match List.find_opt (is id) t.running with
  | Some r ->
    cancelled t r;
    true
  | None -> false

let cancel_token t token =
  let has r = match r.shown with Under u -> Rpc.same_id u.token token | Nowhere -> false in
  Option.iter (cancelled t) (List.find_opt has t.running)

(* What a command is asked for, and what it writes, may be at fault as well as the text. *)
let refused (d : Workspace.document) (found : Diag.t list) =
  let is_of_output (x : Diag.t) = String.equal x.code (Code.cannot_write :> string) in
  let file = Filename.basename (Uri.name d.uri) in
  match found with
  | [] -> file ^ " cannot be read"
  | x :: _ when is_of_output x -> Printf.sprintf "%s: %s" x.span.file x.message
  | x :: _ when not (Span.equal x.span Span.command_line) ->
    Printf.sprintf "%s cannot be read: %s" file x.message
  | x :: _ -> Option.fold ~none:x.message ~some:(fun hint -> Printf.sprintf "%s (%s)" x.message hint) x.hint

(* Starts a process; [finish] makes the answer of its result. *)
let run t ~id params d title work finish =
  if List.length t.running >= most_running then Rpc.refuse Rpc.failed "%d commands run already" most_running;
  let shown = shown t params title in
  let ended result =
    Option.iter (leave t) (List.find_opt (is id) t.running);
    match result with
    | Some (Ok x) -> t.send (Rpc.answer ~id (finish x))
    | Some (Error found) -> t.send (Rpc.error ~id Rpc.failed (refused d found))
    | None ->
      let why = "the process that worked on it came to an end, as when memory runs out" in
      t.send (Rpc.error ~id Rpc.failed why)
  in
  match Job.start ~work ~progress:(report t shown) ~ended with
  | Some job -> t.running <- { id; job; shown; title } :: t.running
  | None ->
    end_ t shown;
    Rpc.refuse Rpc.failed "the system gives no process"

(* {1 Checks} *)

let verdict_json (v : Session.verdict) : Json.t =
  `Assoc
    [
      ("name", Json.text v.name); ("verdict", Json.text v.kind); ("text", Json.text v.text);
      ("run", `Bool v.shown); ("report", Json.text v.run);
    ]

(* New verdicts replace those of the same checks. *)
let keep t (d : Workspace.document) (found : Session.verdict list) =
  match Workspace.find t.session.workspace d.uri with
  | Some now when Int.equal now.version d.version && String.equal now.text d.text ->
    let is_new (v : Session.verdict) =
      List.exists (fun (w : Session.verdict) -> String.equal v.name w.name) found
    in
    let others = List.filter (fun v -> not (is_new v)) (Session.verdicts t.session now) in
    Hashtbl.replace t.session.verdicts d.uri (others @ found);
    t.decided now
  | Some _ | None -> ()

let decide t ~id params (d : Workspace.document) check =
  let read_file = Workspace.reader t.session.workspace d in
  let title = match check with None -> "scc check" | Some name -> "scc check: " ^ name in
  run t ~id params d title
    (fun progress -> t.work.decide ~read_file ~progress ~check d.reading.source)
    (fun found ->
       keep t d found;
       `Assoc [ ("verdicts", `List (List.map verdict_json found)) ])

(* {1 Pages} *)

let folder t =
  match t.folder with
  | Some folder -> folder
  | None ->
    let name = Printf.sprintf "scc-lsp-%d" (Unix.getpid ()) in
    let folder = Filename.concat (Filename.get_temp_dir_name ()) name in
    (match Unix.mkdir folder 0o700 with
     | () -> ()
     | exception Unix.Unix_error (e, _, _) ->
       Rpc.refuse Rpc.failed "the folder %s cannot be made: %s" folder (Unix.error_message e));
    t.folder <- Some folder;
    folder

let show t ~id params (d : Workspace.document) check =
  let read_file = Workspace.reader t.session.workspace d in
  let path = Filename.concat (folder t) (Printf.sprintf "run-%d.html" (List.length t.pages + 1)) in
  run t ~id params d "scc view"
    (fun progress -> t.work.page ~read_file ~progress ~check d.reading.source path)
    (fun () ->
       t.pages <- path :: t.pages;
       let uri = Uri.of_path path in
       if t.session.client.shows then
         ask t "window/showDocument" (`Assoc [ ("uri", `String uri); ("external", `Bool true) ]);
       `Assoc [ ("page", `String uri) ])

(* {1 The commands} *)

let start t ~id params =
  let name = Rpc.string "command" params in
  let arguments = match Json.member "arguments" params with Some (`List all) -> all | _ -> [] in
  let document uri =
    match Workspace.find t.session.workspace uri with
    | Some d -> d
    | None -> Rpc.refuse Rpc.invalid_params "the document %s is not open" uri
  in
  match (arguments, List.mem name names) with
  | _, false -> Rpc.refuse Rpc.invalid_params "there is no command `%s`" name
  | ([ `String uri ] | [ `String uri; `Null ]), true ->
    if String.equal name check_name then decide t ~id params (document uri) None
    else show t ~id params (document uri) None
  | [ `String uri; `String check ], true ->
    if String.equal name check_name then decide t ~id params (document uri) (Some check)
    else show t ~id params (document uri) (Some check)
  | _, true -> Rpc.refuse Rpc.invalid_params "`arguments` are the address of a document, and the name of a check"

let close t =
  List.iter (fun r -> Job.kill r.job) t.running;
  t.running <- [];
  List.iter (fun page -> try Sys.remove page with Sys_error _ -> ()) t.pages;
  Option.iter (fun folder -> try Unix.rmdir folder with Unix.Unix_error _ -> ()) t.folder
