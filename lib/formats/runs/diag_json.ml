open Scc_base
open Scc_json
open Json_format

type source = string -> Source.t option

let named name t = named ~file:Shared.file name t

let brief =
  fields
    [
      field "code" Shared.code (fun (d : Diag.t) -> (d.code :> string));
      field "message" some_text (fun (d : Diag.t) -> d.message);
    ]

(* An offset, with its line and column where the text is known. *)
let position =
  let place (s, offset) = Option.map (fun s -> Source.position s offset) s in
  let part side o = Option.map side (place o) in
  fields
    [
      field "offset" natural snd;
      maybe "line" Shared.from_one (part fst);
      maybe "column" Shared.from_one (part snd);
    ]
  |> about "A place in a text: offset in bytes from 0; line and column (in code points) from 1."
  |> named "position"

let place =
  let known ((source : source), (span : Span.t)) =
    if Span.is_none span then None else Some (source span.file, span)
  in
  fields
    [
      field "file" text (fun (_, (span : Span.t)) -> span.file);
      field "start" position (fun (s, (span : Span.t)) -> (s, span.start));
      field "end" position (fun (s, (span : Span.t)) -> (s, span.stop));
    ]
  |> nullable |> from known |> named "place"

let note =
  fields
    [
      field "message" some_text (fun (_, (_, message)) -> message);
      field "place" place (fun (source, (span, _)) -> (source, span));
    ]

let severity : Diag.severity -> string = function Error -> "error" | Warning -> "warning"

let format =
  fields
    [
      field "code" Shared.code (fun (_, (d : Diag.t)) -> (d.code :> string));
      field "severity" (word severity [ Error; Warning ]) (fun (_, (d : Diag.t)) -> d.severity);
      field "message" some_text (fun (_, (d : Diag.t)) -> d.message);
      field "place" place (fun (source, (d : Diag.t)) -> (source, d.span));
      field "notes" (list note) (fun (source, (d : Diag.t)) -> List.map (fun n -> (source, n)) d.notes);
      field "hint" (nullable text) (fun (_, (d : Diag.t)) -> d.hint);
    ]
  |> named "diagnostic"

let diagnostic ~source d = write format (source, d)
let formats = checked (from (fun (source, all) -> List.map (fun d -> (source, d)) all) (list format))

let stopped = 4

let document_format =
  let some (json : Json.t) =
    match (Json.member "exit" json, Json.member "diagnostics" json) with
    | Some (`Int exit), Some (`List []) when exit <> stopped -> Some "has no diagnostics"
    | _ -> None
  in
  let has name keyword value = `Assoc [ ("properties", `Assoc [ (name, `Assoc [ (keyword, value) ]) ]) ] in
  let when_ = has "exit" "not" (`Assoc [ ("const", `Int stopped) ]) in
  let then_ = has "diagnostics" "minItems" (`Int 1) in
  fields
    (Shared.head "scc-diagnostics" 1
     @ [
       field "exit" Shared.exit (fun (exit, _, _) -> exit);
       maybe "stopped" text (fun (_, why, _) -> why) ~about:"Why the work ended before there was a report.";
       field "diagnostics" formats (fun (_, _, diagnostics) -> diagnostics)
         ~about:"None only where work was stopped before there was a report, by a limit or somebody: exit 4.";
     ])
  |> constrained [ ("if", when_); ("then", then_) ] some

let document ?stopped ~source ~exit diagnostics = write document_format (exit, stopped, (source, diagnostics))
