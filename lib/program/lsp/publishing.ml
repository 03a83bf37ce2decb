open Scc_base
open Scc_json

type t = {
  session : Session.t;
  send : Json.t -> unit;
  origins : (string, (string * Diag.t) list) Hashtbl.t;  (* by the document they are of: where, and what *)
}

let create session ~send = { session; send; origins = Hashtbl.create 16 }

(* {1 Where a diagnostic belongs} *)

let at_start (d : Diag.t) file = { d with span = Span.of_file file }

(* What is in a module of the library, or nowhere, is shown at the beginning of the document. *)
let placed t (d : Workspace.document) (x : Diag.t) =
  let own = Source.name d.reading.source in
  if String.equal x.span.file own && not x.span.whole then (d.uri, x)
  else if Span.is_none x.span || x.span.whole || String.equal x.span.file own then (d.uri, at_start x own)
  else
    match Workspace.target t.session.workspace ~base:d.path ~file:x.span.file with
    | Some (uri, _) -> (uri, x)
    | None -> (d.uri, { (at_start x own) with message = Printf.sprintf "%s (in %s)" x.message x.span.file })

(* {1 Sending} *)

let same (a : Diag.t) (b : Diag.t) =
  Int.equal a.span.start b.span.start && String.equal a.code b.code && String.equal a.message b.message

let add kept x = if List.exists (fun (_, y) -> same (snd x) y) kept then kept else (fst x, snd x) :: kept

(* All that is known at an address, each with the document that it was found for. *)
let at t uri =
  let of_origin origin found kept =
    List.fold_left (fun kept (u, x) -> if String.equal u uri then add kept (origin, x) else kept) kept found
  in
  let all = Hashtbl.fold of_origin t.origins [] in
  List.sort (fun (_, a) (_, b) -> Diag.compare a b) all

let base origin = Uri.path origin

let verdicts t uri =
  match Workspace.find t.session.workspace uri with
  | None -> []
  | Some d -> List.filter_map (Findings.of_verdict d) (Session.verdicts t.session d)

let publish t uri =
  let places =
    match Workspace.find t.session.workspace uri with
    | Some d -> Some (Lazy.force d.positions)
    | None -> Option.bind (Uri.path uri) (fun p -> Option.map snd (Workspace.reading_of t.session.workspace p))
  in
  let list =
    match places with
    | None -> []
    | Some places ->
      List.map (fun (origin, x) -> Findings.diagnostic t.session ~base:(base origin) places x) (at t uri)
      @ verdicts t uri
  in
  let version =
    match Workspace.find t.session.workspace uri with
    | Some d -> [ ("version", `Int d.version) ]
    | None -> []
  in
  t.send
    (Rpc.notification "textDocument/publishDiagnostics"
       (`Assoc ([ ("uri", Json.text uri) ] @ version @ [ ("diagnostics", `List list) ])))

let targets found = List.sort_uniq String.compare (List.map fst found)
let known t uri = Option.value (Hashtbl.find_opt t.origins uri) ~default:[]

let found t (d : Workspace.document) (a : Analysis.t) =
  let before = targets (known t d.uri) in
  let now = List.map (placed t d) a.diagnostics in
  Hashtbl.replace t.origins d.uri now;
  List.iter (publish t) (List.sort_uniq String.compare ((d.uri :: before) @ targets now))

let again t (d : Workspace.document) = publish t d.uri

let forget t uri =
  let before = targets (known t uri) in
  Hashtbl.remove t.origins uri;
  List.iter (publish t) (List.sort_uniq String.compare (uri :: before))
