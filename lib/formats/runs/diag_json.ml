open Scc_base
open Scc_json

let position source offset =
  let place =
    match source with
    | None -> []
    | Some s ->
      let line, column = Source.position s offset in
      [ ("line", `Int line); ("column", `Int column) ]
  in
  `Assoc (("offset", `Int offset) :: place)

let place ~source (span : Span.t) =
  if Span.is_none span then `Null
  else
    let s = source span.file in
    `Assoc
      [
        ("file", Json.text span.file);
        ("start", position s span.start);
        ("end", position s span.stop);
      ]

let severity (d : Diag.t) = match d.severity with Error -> "error" | Warning -> "warning"

let diagnostic ~source (d : Diag.t) =
  let note (span, message) =
    `Assoc [ ("message", Json.text message); ("place", place ~source span) ]
  in
  `Assoc
    [
      ("code", `String d.code);
      ("severity", `String (severity d));
      ("message", Json.text d.message);
      ("place", place ~source d.span);
      ("notes", `List (List.map note d.notes));
      ("hint", Json.option Json.text d.hint);
    ]

let document ~source ~exit diagnostics =
  `Assoc
    [
      ("format", `String "scc-diagnostics");
      ("version", `Int 1);
      ("exit", `Int exit);
      ("diagnostics", `List (List.map (diagnostic ~source) diagnostics));
    ]
