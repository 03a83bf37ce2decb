open Scc_base
open Scc_syntax
open Scc_notation

type edit = { start : int; stop : int; put : string }

(* {1 Cuts}

   Between two lines a text can be cut into declarations and comments. The text in canonical layout has the same
   ones in the same order, so a cut is known by how many of each stand before it. *)

type cut = { items : int; comments : int; at : int }
type cuts = { starts : cut list; ends : cut list  (* in the order of the text *) }

let is_line_end c = c = '\n' || c = '\r'
let is_blank c = c = ' ' || c = '\t'

(* The beginning of the line, if nothing stands before the offset there. *)
let rec line_start text at =
  if at = 0 || is_line_end text.[at - 1] then Some at
  else if is_blank text.[at - 1] then line_start text (at - 1)
  else None

let rec line_stop text at =
  if at = String.length text || is_line_end text.[at] then Some at
  else if is_blank text.[at] then line_stop text (at + 1)
  else None

let cuts text (model : Ast.model) trivia =
  let add known items comments = function
    | None -> known
    | Some at -> { items; comments; at } :: known
  in
  let rec walk starts ends items comments (model : Ast.model) (trivia : Trivia.t list) =
    match (model, trivia) with
    | i :: _, c :: rest when c.start < i.at.start ->
      walk
        (add starts items comments (line_start text c.start))
        (add ends items (comments + 1) (line_stop text c.stop))
        items (comments + 1) model rest
    | i :: rest, _ ->
      let inside, after = List.partition (fun (c : Trivia.t) -> c.start < i.at.stop) trivia in
      let within = comments + List.length inside in
      walk
        (add starts items comments (line_start text i.at.start))
        (add ends (items + 1) within (line_stop text i.at.stop))
        (items + 1) within rest after
    | [], c :: rest ->
      walk
        (add starts items comments (line_start text c.start))
        (add ends items (comments + 1) (line_stop text c.stop))
        items (comments + 1) [] rest
    | [], [] -> { starts = List.rev starts; ends = List.rev ends }
  in
  walk [] [] 0 0 model (List.filter Trivia.is_comment trivia)

(* The first of these cuts that the other text has as well, with its place there. *)
let common others cuts =
  let known = Hashtbl.create 64 in
  List.iter (fun c -> Hashtbl.replace known (c.items, c.comments) c.at) others;
  let place c = Option.map (fun at -> (c.at, at)) (Hashtbl.find_opt known (c.items, c.comments)) in
  List.find_map place cuts

(* {1 A part} *)

let touches ~from ~upto (i : Ast.item) =
  if from = upto then i.at.start <= from && from <= i.at.stop else i.at.start < upto && i.at.stop > from

let replaced source (model, trivia) after (laid_out, comments) touched =
  let text = Source.text source in
  let old = cuts text model trivia and fresh = cuts after laid_out comments in
  let first = List.fold_left (fun least (i : Ast.item) -> Int.min least i.at.start) max_int touched in
  let last = List.fold_left (fun most (i : Ast.item) -> Int.max most i.at.stop) 0 touched in
  let before = List.filter (fun c -> c.at <= first) old.starts in
  let beyond = List.filter (fun c -> c.at >= last) old.ends in
  let whole = (String.length text, String.length after) in
  let start, fresh_start = Option.value (common fresh.starts (List.rev before)) ~default:(0, 0) in
  let stop, fresh_stop = Option.value (common fresh.ends beyond) ~default:whole in
  { start; stop; put = String.sub after fresh_start (fresh_stop - fresh_start) }

let within source ~from ~upto =
  let notation = Notation.of_source source in
  Result.bind (notation.as_written source) (fun ((model, _) as read) ->
      match List.filter (touches ~from ~upto) model with
      | [] -> Ok None
      | touched ->
        Result.bind (notation.canonical source) (fun after ->
            let again = notation.as_written (Source.make ~name:(Source.name source) after) in
            Result.map (fun laid_out -> Some (replaced source read after laid_out touched)) again))
