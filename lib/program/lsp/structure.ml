open Scc_assist
open Scc_json

let plain s params (f : Workspace.document -> Json.t) : Json.t =
  match Session.plain_document s params with None -> `Null | Some d -> f d

(* {1 Symbols} *)

let symbol_kind = function
  | "model" | "module" | "import" -> 2
  | "parameter" | "value" -> 14
  | "shape" | "compound" -> 5
  | "part" | "leaf" -> 8
  | "vertex" | "face" -> 7
  | "behaviour" -> 11
  | "process" | "fixed" -> 19
  | "check" -> 17
  | "loop" -> 18
  | _ -> 13

let rec symbol d (n : Outline.node) : Json.t =
  let name = if n.name = "" then n.kind else n.name in
  `Assoc
    [
      ("name", Json.text name);
      ("detail", Json.text n.kind);
      ("kind", `Int (symbol_kind n.kind));
      ("range", Session.range d n.at.start n.at.stop);
      ("selectionRange", Session.range d n.name_at.start n.name_at.stop);
      ("children", `List (List.map (symbol d) n.inner));
    ]

let symbols s params = plain s params (fun d -> `List (List.map (symbol d) (Outline.of_text d.reading)))

(* {1 Folding} *)

let folds s params =
  plain s params (fun d ->
      let places = Lazy.force d.positions in
      let seen = Hashtbl.create 64 in
      let one (f : Outline.fold) : Json.t option =
        let first, _ = Positions.of_offset places f.from and last, _ = Positions.of_offset places f.upto in
        if last <= first || Hashtbl.mem seen first then None
        else begin
          Hashtbl.add seen first ();
          let kind = if f.comment then [ ("kind", `String "comment") ] else [] in
          Some (`Assoc ([ ("startLine", `Int first); ("endLine", `Int last) ] @ kind))
        end
      in
      `List (List.filter_map one (Outline.folds d.reading)))

(* {1 Layout} *)

(* The part of two texts that differs, by whole lines. *)
let difference before after =
  let n = String.length before and m = String.length after in
  let rec same i = if i < n && i < m && before.[i] = after.[i] then same (i + 1) else i in
  let rec line text i = if i > 0 && text.[i - 1] <> '\n' then line text (i - 1) else i in
  let start = line before (same 0) in
  let rec tail k =
    if n - k > start && m - k > start && before.[n - 1 - k] = after.[m - 1 - k] then tail (k + 1) else k
  in
  let rec whole k = if k = 0 || before.[n - k - 1] = '\n' then k else whole (k - 1) in
  let common = tail 0 in
  let k = if n - common > 0 && common > 0 then whole (Int.min common (n - 1)) else 0 in
  (start, n - k, String.sub after start (m - k - start))

let edits (d : Workspace.document) after : Json.t =
  if String.equal after d.text then `List []
  else
    let start, stop, put = difference d.text after in
    `List [ `Assoc [ ("range", Session.range d start stop); ("newText", Json.text put) ] ]

let layout s params : Json.t =
  let d = Session.document s params in
  match Scc_notation.Notation.canonical d.reading.source with
  | Error _ -> `Null
  | Ok after -> edits d after

let layout_within s params : Json.t =
  let d = Session.document s params in
  let from, upto = Session.offsets d params in
  match Formatting.within d.reading.source ~from ~upto with
  | Error _ -> `Null
  | Ok None -> `List []
  | Ok (Some { start; stop; put }) ->
    let rest = String.sub d.text stop (String.length d.text - stop) in
    edits d (String.concat "" [ String.sub d.text 0 start; put; rest ])

