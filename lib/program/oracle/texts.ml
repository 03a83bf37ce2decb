open Scc_base
open Scc_json.Json_format

let unnamed = "<model>"

let short limit most =
  let bounded p _ s =
    let most = most (Read.quotas p) in
    if String.length s > most then Fault.refuse (Limit (limit, most)) else s
  in
  Read.map bounded Read.text

let whole = Read.member "text" (short "model_bytes" (fun q -> q.model_bytes))
let name = Read.member "name" (short "name_bytes" (fun q -> q.name_bytes))

let source p =
  let text = Read.required p whole in
  Source.make ~name:(Option.value (Read.optional p name) ~default:unnamed) text

let format =
  let work _ p =
    let source = source p in
    match Scc_notation.Notation.canonical source with
    | Ok text -> text
    | Error diagnostics ->
      let named name = if String.equal name (Source.name source) then Some source else None in
      Fault.refuse (Model_refused (Fault.diagnostics ~source:named diagnostics))
  in
  let params = Read.[ needs whole; may name; Method.limits ] in
  Method.make "text.format" params (fields [ field "text" text Fun.id ]) work

(* {1 What stands somewhere} *)

let read_module read_file ~library name =
  if library then Scc_elaborate.Library.find name else Result.to_option (read_file name)

let at_offset p source offset =
  let offset = Read.required p offset in
  let length = String.length (Source.text source) in
  if offset > length then Fault.invalid (Member "offset") "the text has %d bytes" length;
  offset

let kinds =
  [
    "model"; "parameter"; "value"; "index"; "variable"; "argument"; "shape"; "compound"; "part"; "vertex"; "face";
    "feature"; "behaviour"; "process"; "fixed"; "leaf"; "channel"; "check"; "module"; "imported"; "keyword";
    "setting"; "quantity"; "predicate"; "event"; "function"; "component"; "name";
  ]

let found =
  let place =
    all
      [
        field "start" natural (fun (at : Span.t) -> at.start);
        field "stop" natural (fun (at : Span.t) -> at.stop);
      ]
  in
  fields
    [
      within (fun (d : Scc_describe.Describe.t) -> d.at) place;
      field "kind" (word Fun.id kinds) (fun (d : Scc_describe.Describe.t) -> d.kind);
      field "name" some_text (fun (d : Scc_describe.Describe.t) -> d.name);
      field "text" some_text (fun (d : Scc_describe.Describe.t) -> d.text);
      field "declared" (nullable (obj place)) (fun (d : Scc_describe.Describe.t) -> d.declared);
    ]

let describe =
  let offset = Read.member "offset" Read.natural ~about:"In bytes of UTF-8." in
  let work read_file p =
    let source = source p in
    let offset = at_offset p source offset in
    Scc_describe.Describe.find ~read_module:(read_module read_file) source offset
  in
  let params = Read.[ needs whole; may name; needs offset; Method.limits ] in
  Method.make "text.describe" params (fields [ field "found" (nullable found) Fun.id ]) work

(* {1 Help in writing} *)

let modules read_file (i : Scc_syntax.Ast.import) =
  read_module read_file ~library:i.library i.from.it
  |> Option.map (fun text -> Scc_describe.Reading.make (Source.make ~name:i.from.it text))

let offer =
  let open Scc_assist.Completion in
  fields
    [
      field "name" some_text (fun o -> o.name);
      field "kind" some_text (fun o -> o.kind);
      field "form" (nullable some_text) (fun o -> o.form);
      field "about" (nullable some_text) (fun o -> o.about);
    ]

let complete =
  let offset = Read.member "offset" Read.natural ~about:"In bytes of UTF-8." in
  let work read_file p =
    let source = source p in
    let offset = at_offset p source offset in
    let known = Scc_assist.Known.of_text (modules read_file) (Scc_describe.Reading.make source) in
    Scc_assist.Completion.at known (Source.text source) offset
  in
  let params = Read.[ needs whole; may name; needs offset; Method.limits ] in
  Method.make "text.complete" params (fields [ field "from" natural fst; field "offers" (list offer) snd ]) work

let place (at : Span.t -> int) = natural |> from at

let fix =
  let edit =
    fields
      [
        field "start" (place (fun at -> at.start)) fst;
        field "stop" (place (fun at -> at.stop)) fst;
        field "text" text snd;
      ]
  in
  fields
    [
      field "code" Scc_runs.Shared.code (fun ((d : Diag.t), _) -> d.code);
      field "start" natural (fun ((d : Diag.t), _) -> d.span.start);
      field "stop" natural (fun ((d : Diag.t), _) -> d.span.stop);
      field "title" some_text (fun (_, (f : Scc_assist.Fixes.t)) -> f.title);
      field "edits" (list ~least:1 edit) (fun (_, (f : Scc_assist.Fixes.t)) -> f.edits);
    ]

let fixes =
  let work read_file p =
    let source = source p in
    let reading = Scc_describe.Reading.make source in
    let found =
      match Scc_loading.Loaded.load ~read_file ~overrides:[] source with
      | Ok l -> l.warnings
      | Error found -> found
    in
    Scc_assist.Fixes.of_diagnostics reading found
  in
  let params = Read.[ needs whole; may name; Method.limits ] in
  Method.make "text.fixes" params (fields [ field "fixes" (list fix) Fun.id ]) work
