open Scc_system
open Scc_json

type ending = Shut | Broken_off

(* A session after [initialize]. *)
type live = {
  session : Session.t;
  publishing : Publishing.t;
  readings : Reading_jobs.t;
  commands : Commands.t;
  asked : Asked.t;
}

type phase = Fresh | Live of live | Over of live

type t = {
  version : string;
  work : Commands.work;
  frames : Frame.t;
  bytes : Bytes.t;  (* what is being read *)
  queue : Rpc.message Queue.t;
  cancelled : (string, unit) Hashtbl.t;  (* ids of requests that wait *)
  mutable phase : phase;
  mutable input_ended : bool;
  mutable exited : bool;
}

let most_bytes = 128 * Scc_base.Memory.mib
let most_waiting = 10_000
let send_text text = Standard.print (Frame.framed text)
let send json = send_text (Json.line json)

(* {1 Messages to the user} *)

let message name kind text =
  send (Rpc.notification name (`Assoc [ ("type", `Int kind); ("message", Json.text text) ]))

let log text = message "window/logMessage" 2 text
let say text = message "window/showMessage" 2 text

(* {1 The beginning} *)

let options members : Json.t = `Assoc members
let yes : Json.t = `Bool true

let capabilities encoding : Json.t =
  let texts all : Json.t = `List (List.map (fun s -> `String s) all) in
  let tokens = [ ("legend", Semantic_tokens.legend); ("full", options [ ("delta", yes) ]); ("range", yes) ] in
  options
    [
      ("positionEncoding", `String (Positions.name encoding));
      ("textDocumentSync", options [ ("openClose", yes); ("change", `Int 2); ("save", yes) ]);
      ("completionProvider", options [ ("triggerCharacters", texts [ "<"; "~"; "{"; "."; "\"" ]) ]);
      ("hoverProvider", yes);
      ("signatureHelpProvider", options [ ("triggerCharacters", texts [ "("; "," ]) ]);
      ("definitionProvider", yes);
      ("referencesProvider", yes);
      ("documentHighlightProvider", yes);
      ("documentSymbolProvider", yes);
      ("workspaceSymbolProvider", yes);
      ("codeActionProvider", options [ ("codeActionKinds", texts [ "quickfix" ]) ]);
      ("codeLensProvider", options []);
      ("documentFormattingProvider", yes);
      ("documentRangeFormattingProvider", yes);
      ("renameProvider", options [ ("prepareProvider", yes) ]);
      ("foldingRangeProvider", yes);
      ("executeCommandProvider", options [ ("commands", texts Commands.names); ("workDoneProgress", yes) ]);
      ("semanticTokensProvider", options tokens);
      ("inlayHintProvider", yes);
    ]

let refresh live name can = if can then Commands.ask live.commands name `Null

let initialize t params =
  let client = Client.read params in
  let session = Session.create client in
  let publishing = Publishing.create session ~send in
  let fresh (live : live) =
    refresh live "workspace/inlayHint/refresh" client.fresh_values;
    refresh live "workspace/codeLens/refresh" client.fresh_lenses
  in
  let now () = match t.phase with Live live -> fresh live | Fresh | Over _ -> () in
  let found d analysis =
    Publishing.found publishing d analysis;
    now ()
  in
  let decided d =
    Publishing.again publishing d;
    now ()
  in
  let readings = Reading_jobs.create session ~found ~say in
  let commands = Commands.create t.work session ~send ~decided in
  t.phase <- Live { session; publishing; readings; commands; asked = Asked.create ~send:send_text };
  options
    [
      ("capabilities", capabilities client.encoding);
      ("serverInfo", options [ ("name", `String "scc"); ("version", `String t.version) ]);
    ]

let watch live =
  if live.session.client.watches then
    let watcher pattern : Json.t = `Assoc [ ("globPattern", `String pattern) ] in
    let patterns = [ "**/*.{sc,osc,xml,off,obj,stl,ply,wrl,x3d,gltf,glb,3mf}" ] in
    let register : Json.t =
      `Assoc
        [
          ("id", `String "files");
          ("method", `String "workspace/didChangeWatchedFiles");
          ("registerOptions", `Assoc [ ("watchers", `List (List.map watcher patterns)) ]);
        ]
    in
    Commands.ask live.commands "client/registerCapability" (`Assoc [ ("registrations", `List [ register ]) ])

(* {1 Documents} *)

let opened live params =
  let document = Rpc.member "textDocument" params in
  let uri = Rpc.string "uri" document in
  Workspace.put live.session.workspace ~uri ~version:(Rpc.int "version" document) (Rpc.string "text" document);
  Option.iter (Reading_jobs.later live.readings) (Workspace.find live.session.workspace uri)

(* The text after a change of a range, or of all of it. *)
let changed encoding text change =
  let put = Rpc.string "text" change in
  match Json.member "range" change with
  | None -> put
  | Some range ->
    let places = Positions.make encoding text in
    let side name = Positions.offset places (Rpc.position (Rpc.member name range)) in
    let a = side "start" and b = side "end" in
    let from = Int.min a b and upto = Int.max a b in
    String.concat "" [ String.sub text 0 from; put; String.sub text upto (String.length text - upto) ]

let edited live params =
  let d = Session.document live.session params in
  let version = Rpc.int "version" (Rpc.member "textDocument" params) in
  let workspace = live.session.workspace in
  let text = List.fold_left (changed (Workspace.encoding workspace)) d.text (Rpc.list "contentChanges" params) in
  Asked.changed live.asked d.uri;
  Workspace.put workspace ~uri:d.uri ~version text;
  Option.iter (Reading_jobs.later live.readings) (Workspace.find workspace d.uri)

let closed live params =
  let d = Session.document live.session params in
  Asked.changed live.asked d.uri;
  Workspace.remove live.session.workspace d.uri;
  Sent_tokens.forget live.session.sent_tokens d.uri;
  Reading_jobs.forget live.readings d;
  Publishing.forget live.publishing d.uri

let files_changed live params =
  let path change = Option.bind (Option.bind (Json.member "uri" change) Json.string) Uri.path in
  List.iter (Reading_jobs.changed_file live.readings) (List.filter_map path (Rpc.list "changes" params))

let saved live params =
  let uri = Rpc.(string "uri" (member "textDocument" params)) in
  Option.iter (Reading_jobs.changed_file live.readings) (Uri.path uri)

(* {1 Methods} *)

(* Those that take no longer in a large document. *)
let quick =
  [
    ("textDocument/completion", Describing.completion); ("textDocument/signatureHelp", Describing.signature);
  ]

(* What a request is about is fixed at once; the answer may be computed in another process. *)
let methods =
  let later work session params () : Json.t = work session params in
  [
    ("textDocument/hover", later Describing.hover);
    ("textDocument/definition", later Navigate.definition);
    ("textDocument/references", later Navigate.references);
    ("textDocument/documentHighlight", later Navigate.highlights);
    ("textDocument/prepareRename", later Navigate.prepare_rename);
    ("textDocument/rename", later Navigate.rename);
    ("textDocument/documentSymbol", later Structure.symbols);
    ("textDocument/foldingRange", later Structure.folds);
    ("textDocument/semanticTokens/full", Semantic_tokens.full);
    ("textDocument/semanticTokens/full/delta", Semantic_tokens.delta);
    ("textDocument/semanticTokens/range", later Semantic_tokens.within);
    ("textDocument/formatting", later Structure.layout);
    ("textDocument/rangeFormatting", later Structure.layout_within);
    ("textDocument/codeAction", later Findings.actions);
    ("textDocument/codeLens", later Findings.lenses);
    ("textDocument/inlayHint", later Findings.values);
  ]

let close live =
  Asked.close live.asked;
  Reading_jobs.close live.readings;
  Commands.close live.commands

(* At once, or in a process that the next keystroke ends. *)
let answered live ~id work params =
  let d = Session.document live.session params in
  let answer = work live.session params in
  if Session.is_large d then begin
    Asked.ask live.asked ~id ~uri:d.uri answer;
    None
  end
  else Some (answer ())

let request t id name params =
  match (t.phase, name) with
  | Fresh, "initialize" -> Some (initialize t params)
  | Fresh, _ -> Rpc.refuse Rpc.not_initialized "the first request is `initialize`"
  | Over _, _ -> Rpc.refuse Rpc.invalid_request "after `shutdown` there is only `exit`"
  | Live _, "initialize" -> Rpc.refuse Rpc.invalid_request "`initialize` comes once"
  | Live live, "shutdown" ->
    close live;
    t.phase <- Over live;
    Some `Null
  | Live live, "workspace/executeCommand" ->
    Commands.start live.commands ~id params;
    None
  | Live live, "workspace/symbol" ->
    (* it may read many files, and is about no document *)
    Asked.ask live.asked ~id ~uri:"" (fun () -> Searching.symbols live.session params);
    None
  | Live live, _ -> (
      match (List.assoc_opt name quick, List.assoc_opt name methods) with
      | Some work, _ -> Some (work live.session params)
      | None, Some work -> answered live ~id work params
      | None, None -> Rpc.refuse Rpc.unknown_method "there is no method `%s`" name)

let id_text id = Json.line id

let cancel t params =
  let id = Rpc.member "id" params in
  let running =
    match t.phase with
    | Live live -> Commands.cancel live.commands id || Asked.cancel live.asked id
    | Fresh | Over _ -> false
  in
  let waits = function Rpc.Request r -> String.equal (id_text r.id) (id_text id) | _ -> false in
  if (not running) && Queue.fold (fun found m -> found || waits m) false t.queue then
    Hashtbl.replace t.cancelled (id_text id) ()

let notification t name params =
  match (t.phase, name) with
  | _, "exit" -> t.exited <- true
  | (Fresh | Over _), _ -> ()
  | Live live, "initialized" -> watch live
  | Live live, "textDocument/didOpen" -> opened live params
  | Live live, "textDocument/didChange" -> edited live params
  | Live live, "textDocument/didClose" -> closed live params
  | Live live, "textDocument/didSave" -> saved live params
  | Live live, "workspace/didChangeWatchedFiles" -> files_changed live params
  | Live live, "window/workDoneProgress/cancel" ->
    Commands.cancel_token live.commands (Rpc.member "token" params)
  | Live _, _ -> ()

(* {1 One message} *)

(* What ends the program is not the fault of a message. *)
let passes = function
  | Interruption.Interrupted _ | Standard.Closed | Standard.Failed _ | Reading.Failed _ -> true
  | _ -> false

let guarded f ~refused =
  match f () with
  | () -> ()
  | exception Rpc.Refused (code, why) -> refused code why
  | exception Out_of_memory -> refused Rpc.internal_error "the memory does not suffice"
  | exception e when not (passes e) ->
    refused Rpc.internal_error ("a fault of scc, please report it: " ^ Printexc.to_string e)

let handle t (m : Rpc.message) =
  match m with
  | Request { id; name; params } ->
    if Hashtbl.mem t.cancelled (id_text id) then begin
      Hashtbl.remove t.cancelled (id_text id);
      send (Rpc.error ~id Rpc.cancelled "the request was cancelled")
    end
    else
      guarded
        (fun () -> Option.iter (fun result -> send (Rpc.answer ~id result)) (request t id name params))
        ~refused:(fun code why -> send (Rpc.error ~id code why))
  | Notification { name; params } ->
    guarded (fun () -> notification t name params) ~refused:(fun _ why -> log (Printf.sprintf "%s: %s" name why))
  | Response { id; _ } -> (
      match t.phase with Live live -> Commands.answered live.commands id | Fresh | Over _ -> ())
  | Invalid { id; code; why } -> send (Rpc.error ~id code why)

(* {1 The loop} *)

(* A request to cancel overtakes what waits. *)
let take t (m : Rpc.message) =
  match m with
  | Notification { name = "$/cancelRequest"; params } ->
    guarded (fun () -> cancel t params) ~refused:(fun _ why -> log ("$/cancelRequest: " ^ why))
  | m -> Queue.add m t.queue

let rec unpack t =
  if Queue.length t.queue < most_waiting then
    match Frame.next t.frames with
    | More -> ()
    | Message text ->
      take t (Rpc.read text);
      unpack t
    | Fault why ->
      take t (Invalid { id = `Null; code = Rpc.parse_error; why });
      unpack t

let read t =
  match Reading.input t.bytes 0 (Bytes.length t.bytes) with
  | 0 -> t.input_ended <- true
  | n ->
    Frame.feed t.frames t.bytes n;
    unpack t

let jobs t =
  match t.phase with
  | Live live -> Reading_jobs.jobs live.readings @ Commands.jobs live.commands @ Asked.jobs live.asked
  | Fresh | Over _ -> []

(* Waits for the client and for processes, at most so many seconds (negative: for ever). *)
let wait t seconds =
  let working = jobs t in
  let input = if t.input_ended || Queue.length t.queue >= most_waiting then [] else [ Unix.stdin ] in
  match Unix.select (input @ List.map Job.source working) [] [] seconds with
  | ready, _, _ ->
    let is_ready job = List.memq (Job.source job) ready in
    List.iter (fun job -> if is_ready job then ignore (Job.heard job)) working;
    if List.memq Unix.stdin ready then read t
  | exception Unix.Unix_error (EINTR, _, _) -> Interruption.check ()

let seconds_to_wait t = match t.phase with Live live -> Reading_jobs.wait live.readings | Fresh | Over _ -> -1.
let go_on t =
  match t.phase with
  | Live live ->
    Asked.go_on live.asked;
    Reading_jobs.go_on live.readings
  | Fresh | Over _ -> ()


let rec loop t =
  if not t.exited then
    match Queue.take_opt t.queue with
    | Some m ->
      handle t m;
      unpack t;
      wait t 0.;
      loop t
    | None ->
      Standard.flush ();
      if not t.input_ended then begin
        go_on t;
        wait t (seconds_to_wait t);
        loop t
      end

let ending t = match t.phase with Over _ -> Shut | Fresh | Live _ -> Broken_off

let run ~version work =
  let t =
    {
      version; work;
      frames = Frame.make ~most:most_bytes;
      bytes = Bytes.create 65536;
      queue = Queue.create ();
      cancelled = Hashtbl.create 8;
      phase = Fresh;
      input_ended = false;
      exited = false;
    }
  in
  let finish () = match t.phase with Live live | Over live -> close live | Fresh -> () in
  Fun.protect ~finally:finish (fun () ->
      loop t;
      Standard.flush ());
  ending t
