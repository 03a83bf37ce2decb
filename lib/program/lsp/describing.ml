open Scc_base
open Scc_describe
open Scc_assist
open Scc_json

(* {1 What is there} *)

let value_of (s : Session.t) (d : Workspace.document) (at : Span.t option) =
  let same (place : Span.t) =
    match at with
    | Some at -> Int.equal at.start place.start && String.equal at.file place.file
    | None -> false
  in
  match Session.analysis s d with
  | None -> []
  | Some found -> (
      match List.filter (fun (place, _) -> same place) found.values with
      | [] -> []
      | [ (_, value) ] -> [ "= " ^ value ]
      | (_, first) :: _ as several ->
        let count = List.length several in
        [ Printf.sprintf "= %s, … (%d values, one in each turn of the loops around it)" first count ])

let verdict_of s (d : Workspace.document) (found : Describe.t) =
  if not (String.equal found.kind "check") then []
  else
    let is_it (v : Session.verdict) = String.equal v.name found.name in
    List.map (fun (v : Session.verdict) -> v.run) (List.filter is_it (Session.verdicts s d))

let read_module (s : Session.t) (d : Workspace.document) ~library name =
  if library then Scc_elaborate.Library.find name
  else
    let text path = Result.to_option (Workspace.text_of s.workspace path) in
    Option.bind (Workspace.resolved ~base:d.path name) text

let hover s params : Json.t =
  match Session.plain_document s params with
  | None -> `Null
  | Some d -> (
      match Describe.at ~read_module:(read_module s d) d.reading (Session.offset d params) with
      | None -> `Null
      | Some found ->
        let more = value_of s d found.declared @ verdict_of s d found in
        `Assoc
          [
            ("contents", Session.markup s (String.concat "\n" (found.text :: more)));
            ("range", Session.range d found.at.start found.at.stop);
          ])

(* {1 What can be written} *)

let item_kind = function
  | "channel" -> 23
  | "feature" -> 5
  | "body" -> 6
  | "shape" -> 7
  | "behaviour" -> 8
  | "value" -> 21
  | "module" -> 9
  | "file" -> 17
  | "setting" -> 12
  | "quantity" | "predicate" | "function" -> 3
  | "event" -> 23
  | "component" -> 10
  | _ -> 14

(* A form with its names in capitals as places to be filled in. *)
let snippet form =
  let b = Buffer.create 64 and count = ref 0 in
  let capital c = c >= 'A' && c <= 'Z' in
  let n = String.length form in
  let rec word i = if i < n && (capital form.[i] || form.[i] = '_') then word (i + 1) else i in
  let rec from i =
    if i < n then begin
      let stop = word i in
      if stop - i >= 3 then begin
        incr count;
        Printf.bprintf b "${%d:%s}" !count (String.sub form i (stop - i));
        from stop
      end
      else begin
        if String.contains "\\$}" form.[i] then Buffer.add_char b '\\';
        Buffer.add_char b form.[i];
        from (i + 1)
      end
    end
  in
  from 0;
  Buffer.contents b

let is_declaration form = String.contains form ' '

let item (s : Session.t) d from upto rank (o : Completion.offer) : Json.t =
  let range = Session.range d from upto in
  let plain put format : (string * Json.t) list =
    ("textEdit", `Assoc [ ("range", range); ("newText", Json.text put) ]) :: format
  in
  let insert =
    match o.form with
    | Some form when s.client.snippets && is_declaration form && String.equal o.kind "word" ->
      plain (snippet form) [ ("insertTextFormat", `Int 2) ]
    | Some _ | None -> plain o.name []
  in
  let optional name f = function None -> [] | Some x -> [ (name, f x) ] in
  `Assoc
    ([ ("label", Json.text o.name); ("kind", `Int (item_kind o.kind)) ]
     @ [ ("detail", Json.text (Option.value o.form ~default:o.kind)) ]
     @ optional "documentation" (Session.markup s) o.about
     @ [ ("sortText", `String (Printf.sprintf "%05d" rank)); ("filterText", Json.text o.name) ]
     @ insert)

let most = 500

(* Files that can be imported, by what is written of their path. *)
let importable (d : Workspace.document) written =
  let folder = match String.rindex_opt written '/' with Some i -> String.sub written 0 (i + 1) | None -> "" in
  match Workspace.resolved ~base:d.path (folder ^ ".") with
  | None -> []
  | Some path ->
    let names = match Sys.readdir path with names -> Array.to_list names | exception Sys_error _ -> [] in
    let own = Option.map Filename.basename d.path in
    let is_model name = Filename.check_suffix name ".sc" in
    let is_folder name = try Sys.is_directory (Filename.concat path name) with Sys_error _ -> false in
    let fits name = name <> "" && name.[0] <> '.' && Some name <> own && (is_model name || is_folder name) in
    let offer name =
      let name = folder ^ if is_model name then name else name ^ "/" in
      { Completion.name; kind = "file"; form = None; about = None }
    in
    List.map offer (List.sort String.compare (List.filter fits names))

let offers s (d : Workspace.document) offset =
  match Completion.import d.text offset with
  | Some (from, `File written) -> (from, importable d written)
  | Some (from, `Library) ->
    let offer name = { Completion.name; kind = "module"; form = None; about = None } in
    (from, List.map offer Scc_elaborate.Library.names)
  | None -> Completion.at (Session.known s d) d.text offset

let completion s params : Json.t =
  match Session.plain_document s params with
  | None -> `Null
  | Some d ->
    let offset = Session.offset d params in
    let from, found = offers s d offset in
    let kept = Scc_data.Lists.take most found in
    `Assoc
      [
        ("isIncomplete", `Bool (List.compare_length_with found most > 0));
        ("items", `List (List.mapi (item s d from offset) kept));
      ]

(* {1 Calls} *)

let signature (s : Session.t) params : Json.t =
  let of_call (c : Signatures.t) : Json.t =
    let form text : Json.t =
      (* a name may stand several times: `bound(body, body)` *)
      let argument (start, stop) : Json.t =
        let units k = snd (Positions.of_offset (Positions.make Utf16 text) k) in
        let label : Json.t =
          if s.client.places then `List [ `Int (units start); `Int (units stop) ]
          else Json.text (String.sub text start (stop - start))
        in
        `Assoc [ ("label", label) ]
      in
      let about = match c.about with None -> [] | Some a -> [ ("documentation", Session.markup s a) ] in
      `Assoc
        ([
          ("label", Json.text text);
          ("parameters", `List (List.map argument (Signatures.arguments text)));
        ]
          @ about)
    in
    (* the first form with so many arguments *)
    let fits text = List.length (Signatures.arguments text) > c.argument in
    let rec index i = function [] -> 0 | text :: rest -> if fits text then i else index (i + 1) rest in
    `Assoc
      [
        ("signatures", `List (List.map form c.forms));
        ("activeSignature", `Int (index 0 c.forms));
        ("activeParameter", `Int c.argument);
      ]
  in
  match Session.plain_document s params with
  | None -> `Null
  | Some d ->
    let found = Signatures.at (Session.known s d) d.text (Session.offset d params) in
    Option.fold ~none:`Null ~some:of_call found
