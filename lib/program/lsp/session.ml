open Scc_base
open Scc_describe
open Scc_json

type verdict = { name : string; kind : string; text : string; run : string; shown : bool }

type t = {
  client : Client.t;
  workspace : Workspace.t;
  analyses : (string, int * Analysis.t) Hashtbl.t;
  verdicts : (string, verdict list) Hashtbl.t;
  sent_tokens : Sent_tokens.t;
}

let create (client : Client.t) =
  {
    client;
    workspace = Workspace.create client.encoding;
    analyses = Hashtbl.create 16;
    verdicts = Hashtbl.create 16;
    sent_tokens = Sent_tokens.create ();
  }

let document t params =
  let uri = Rpc.(string "uri" (member "textDocument" params)) in
  match Workspace.find t.workspace uri with
  | Some d -> d
  | None -> Rpc.refuse Rpc.invalid_params "the document %s is not open" uri

let plain_document t params =
  let d = document t params in
  if Reading.is_plain d.reading.source then Some d else None

let offset (d : Workspace.document) params =
  Positions.offset (Lazy.force d.positions) (Rpc.position (Rpc.member "position" params))

let offsets (d : Workspace.document) params =
  let range = Rpc.member "range" params in
  let side name = Positions.offset (Lazy.force d.positions) (Rpc.position (Rpc.member name range)) in
  let a = side "start" and b = side "end" in
  (Int.min a b, Int.max a b)

(* Bytes up to which a text is read between two keystrokes. *)
let large = 60_000

let is_large (d : Workspace.document) = String.length d.text > large

let known t (d : Workspace.document) =
  if not (is_large d) then Analysis.known_of t.workspace d
  else
    match Hashtbl.find_opt t.analyses d.uri with
    | Some (_, found) -> found.known
    | None -> Scc_assist.Known.empty

let analysis t (d : Workspace.document) =
  match Hashtbl.find_opt t.analyses d.uri with
  | Some (version, found) when Int.equal version d.version -> Some found
  | Some _ | None -> None

let verdicts t (d : Workspace.document) = Option.value (Hashtbl.find_opt t.verdicts d.uri) ~default:[]

let range (d : Workspace.document) start stop =
  Workspace.place (Lazy.force d.positions) (Span.make ~file:"" ~start ~stop)

(* {1 Descriptions} *)

(* What Markdown would take for marks, outside of code. *)
let prose line =
  let b = Buffer.create (String.length line + 16) in
  let code = ref false in
  String.iter
    (fun c ->
       if c = '`' then code := not !code;
       if (not !code) && String.contains "\\*_{}[]<>#|~&" c then Buffer.add_char b '\\';
       Buffer.add_char b c)
    line;
  Buffer.contents b

let rec fence text marks = if String.length marks > 64 then marks else
    let n = String.length marks in
    let rec within i = i + n <= String.length text && (String.sub text i n = marks || within (i + 1)) in
    if within 0 then fence text (marks ^ "`") else marks

let markup t text : Json.t =
  let value =
    match String.index_opt text '\n' with
    | _ when not t.client.markdown -> text
    | None -> prose text
    | Some i ->
      let rest = String.sub text (i + 1) (String.length text - i - 1) in
      let marks = fence rest "```" in
      Printf.sprintf "%s\n\n%sscc\n%s\n%s" (prose (String.sub text 0 i)) marks rest marks
  in
  `Assoc [ ("kind", `String (if t.client.markdown then "markdown" else "plaintext")); ("value", Json.text value) ]
