open Scc_base
open Scc_session

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
  match (Front_end.of_source source).canonical source with
  | Ok text -> Reply.Value (`Assoc [ ("text", `String text) ])
  | Error diagnostics ->
    let named name = if String.equal name (Source.name source) then Some source else None in
    Fault.refuse (Model_refused (Fault.diagnostics ~source:named diagnostics))
