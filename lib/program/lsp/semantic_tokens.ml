open Scc_assist
open Scc_json

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
  let is_end c = c = '\n' || c = '\r' in
  let rec line_end i = if i < w.stop && not (is_end text.[i]) then line_end (i + 1) else i in
  let rec split from found =
    if from >= w.stop then List.rev found
    else
      let stop = line_end from in
      split (stop + 1) (if stop > from then (from, stop) :: found else found)
  in
  split w.start []

let data (d : Workspace.document) words =
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
  Array.of_list (List.rev !data)

let integers data : Json.t = `List (List.map (fun n -> `Int n) (Array.to_list data))
let all id data : Json.t = `Assoc [ ("resultId", `String id); ("data", integers data) ]
let none () : Json.t = `Null

let sent (s : Session.t) (d : Workspace.document) =
  let words = lazy (data d (Colours.of_text d.reading)) in
  (Sent_tokens.add s.sent_tokens ~uri:d.uri words, words)

let full s params =
  match Session.plain_document s params with
  | None -> none
  | Some d ->
    let id, words = sent s d in
    fun () -> all id (Lazy.force words)

let delta (s : Session.t) params =
  let before = Rpc.string "previousResultId" params in
  match Session.plain_document s params with
  | None -> none
  | Some d -> (
      let before = Sent_tokens.find s.sent_tokens ~uri:d.uri before in
      let id, words = sent s d in
      match before with
      | None -> fun () -> all id (Lazy.force words)
      | Some before ->
        fun () ->
          let edit (start, taken, put) : Json.t =
            `Assoc [ ("start", `Int start); ("deleteCount", `Int taken); ("data", integers put) ]
          in
          let found = Sent_tokens.difference (Lazy.force before) (Lazy.force words) in
          `Assoc [ ("resultId", `String id); ("edits", `List (List.map edit (Option.to_list found))) ])

let within s params : Json.t =
  match Session.plain_document s params with
  | None -> `Null
  | Some d ->
    let from, upto = Session.offsets d params in
    let within (w : Colours.word) = w.stop > from && w.start < upto in
    `Assoc [ ("data", integers (data d (List.filter within (Colours.of_text d.reading)))) ]
