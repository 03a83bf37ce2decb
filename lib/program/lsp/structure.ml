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

(* {1 Colours} *)

let kinds =
  [
    (Colours.Keyword, "keyword"); (Comment, "comment"); (Text, "string"); (Number, "number");
    (Module, "namespace"); (Template, "class"); (Behaviour, "interface"); (Body, "variable");
    (Value, "property"); (Argument, "parameter"); (Feature, "enumMember"); (Channel, "event");
    (Function, "function"); (Choice, "modifier");
  ]

let number kind =
  let rec index i = function
    | [] -> 0
    | (k, _) :: rest -> if k = (kind : Colours.kind) then i else index (i + 1) rest
  in
  index 0 kinds

let legend : Json.t =
  `Assoc
    [
      ("tokenTypes", `List (List.map (fun (_, name) -> `String name) kinds));
      ("tokenModifiers", `List [ `String "declaration" ]);
    ]

(* A word on several lines is a piece on each of them. *)
let pieces text (w : Colours.word) =
  let rec split from found =
    if from >= w.stop then List.rev found
    else
      let stop = match String.index_from_opt text from '\n' with Some i when i < w.stop -> i | _ -> w.stop in
      split (stop + 1) (if stop > from then (from, stop) :: found else found)
  in
  split w.start []

let encoded (d : Workspace.document) words : Json.t =
  let places = Lazy.force d.positions in
  let line = ref 0 and character = ref 0 and data = ref [] in
  let add kind declares (start, stop) =
    let l, c = Positions.of_offset places start in
    let _, e = Positions.of_offset places stop in
    if e > c then begin
      let delta = if l = !line then c - !character else c in
      data := (if declares then 1 else 0) :: kind :: (e - c) :: delta :: (l - !line) :: !data;
      line := l;
      character := c
    end
  in
  List.iter (fun (w : Colours.word) -> List.iter (add (number w.kind) w.declares) (pieces d.text w)) words;
  `Assoc [ ("data", `List (List.rev_map (fun n -> `Int n) !data)) ]

let colours s params = plain s params (fun d -> encoded d (Colours.of_text d.reading))

let colours_within s params =
  plain s params (fun d ->
      let range = Rpc.member "range" params in
      let side name = Positions.offset (Lazy.force d.positions) (Rpc.position (Rpc.member name range)) in
      let from = side "start" and upto = side "end" in
      let within (w : Colours.word) = w.stop > from && w.start < upto in
      encoded d (List.filter within (Colours.of_text d.reading)))

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

let layout s params : Json.t =
  let d = Session.document s params in
  match Scc_notation.Notation.canonical d.reading.source with
  | Error _ -> `Null
  | Ok after when String.equal after d.text -> `List []
  | Ok after ->
    let start, stop, put = difference d.text after in
    `List [ `Assoc [ ("range", Session.range d start stop); ("newText", Json.text put) ] ]

