open Scc_base
open Scc_syntax

let tokens source =
  let name = Source.name source and text = Source.text source in
  let whole (t : Tokens.token) =
    match t.token with
    | PLUS | STAR | MINUS -> { t with stop = t.start + Signs.length text t.start }
    | _ -> t
  in
  let rewrite tokens = Words.rewrite ~file:name (Array.map whole tokens) in
  Tokens.read ~rewrite (Source.make ~name (Signs.spelt text))

let as_written source = Parse.with_trivia ~tokens source

let read source =
  let* items, trivia = as_written source in
  let* items, notes = To_refined.model items in
  let note ((at : Span.t), text) =
    { Trivia.kind = Line; text = "// " ^ text; start = at.start - 1; stop = at.start - 1; own_line = true }
  in
  let before (a : Trivia.t) (b : Trivia.t) = Int.compare a.start b.start in
  Ok (items, List.stable_sort before (List.append trivia (List.map note notes)))

let write (items, trivia) =
  let* items = Abstract.model items in
  Ok (Written.model ~trivia items)

let canonical source =
  let* items, trivia = as_written source in
  match List.sort_uniq Diag.compare (Region.faults items) with
  | [] -> Ok (Written.model ~trivia items)
  | faults -> Error faults

(* Without the names that hold what the language has not. *)
let readable source =
  let members e =
    match Region.read e with Ok x -> Option.value (Region.members x) ~default:[] | Error _ -> []
  in
  let channel (c : Ast.channel) =
    let member (m : Ast.member) = match Tree.region m.feature with Some e -> members e | None -> [ m ] in
    { c with features = List.concat_map member c.features }
  in
  let feature (f : Ast.feature) : Ast.feature =
    match Option.map members (Tree.region f) with
    | None -> f
    | Some [ m ] -> m.feature
    | Some _ -> { f with it = Tuple (None, []) }
  in
  let rec item (i : Ast.item) : Ast.item list =
    match (i.it, Tree.declared i) with
    | _, Some _ -> []
    | For (ranges, body), None -> [ { i with it = For (ranges, List.concat_map item body) } ]
    | _, None -> [ Walk.item { Walk.same with channel; feature } i ]
  in
  List.concat_map item (Parse.readable ~tokens source)
