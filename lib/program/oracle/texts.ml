open Scc_base
open Scc_json

let unnamed = "<model>"

let short limit most p at v =
  let s = Read.text p at v in
  if String.length s > most then Fault.refuse (Limit (limit, most)) else s

let source p =
  let q = Read.quotas p in
  let text = Read.required p "text" (short "model_bytes" q.model_bytes) in
  let name = Read.optional p "name" (short "name_bytes" q.name_bytes) in
  Source.make ~name:(Option.value name ~default:unnamed) text

let format p =
  Read.only p [ "text"; "name"; "limits" ];
  let source = source p in
  match Scc_notation.Notation.canonical source with
  | Ok text -> Reply.Value (`Assoc [ ("text", `String text) ])
  | Error diagnostics ->
    let named name = if String.equal name (Source.name source) then Some source else None in
    Fault.refuse (Model_refused (Fault.diagnostics ~source:named diagnostics))

(* {1 What stands somewhere} *)

let read_module read_file ~library name =
  if library then Scc_elaborate.Library.find name else Result.to_option (read_file name)

let found (d : Scc_describe.Describe.t) : Json.t =
  let place (at : Span.t) = [ ("start", `Int at.start); ("stop", `Int at.stop) ] in
  `Assoc
    (place d.at
     @ [
       ("kind", `String d.kind);
       ("name", Json.text d.name);
       ("text", Json.text d.text);
       ("declared", Json.option (fun at -> `Assoc (place at)) d.declared);
     ])

let describe ~read_file p =
  Read.only p [ "text"; "name"; "offset"; "limits" ];
  let source = source p in
  let offset = Read.required p "offset" Read.natural in
  let length = String.length (Source.text source) in
  if offset > length then Fault.invalid (Member "offset") "the text has %d bytes" length;
  let told = Scc_describe.Describe.find ~read_module:(read_module read_file) source offset in
  Reply.Value (`Assoc [ ("found", Json.option found told) ])
