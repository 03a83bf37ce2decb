type t =
  | Text of int * string
  | Closing of int * string
  | Cat of t list
  | Space
  | Fill of string
  | Line
  | Paragraph
  | Nest of int * t
  | Group of t

let width = 100
let text ~at s = Text (at, s)
let closing ~at s = Closing (at, s)
let cat ds = Cat ds
let space = Space
let fill s = Fill s
let line = Line
let paragraph = Paragraph
let nest n d = Nest (n, d)
let group d = Group d

(* What is to be written before the next piece. *)
type gap = Nothing | Spaces of string | Soft of string * int | Newline of { indent : int; keep : bool }

type writer = {
  buffer : Buffer.t;
  mutable column : int;
  mutable gap : gap;
  mutable empty_line : bool;  (* the source has one here *)
  mutable in_line_comment : bool;  (* whatever is written now would belong to it *)
  mutable trivia : Trivia.t list;  (* still to be written *)
}

let write w s =
  Buffer.add_string w.buffer s;
  match String.rindex_opt s '\n' with
  | None -> w.column <- w.column + String.length s
  | Some i -> w.column <- String.length s - i - 1

let write_newline w indent =
  if Buffer.length w.buffer > 0 then write w (if w.empty_line then "\n\n" else "\n");
  w.empty_line <- false;
  w.in_line_comment <- false;
  write w (String.make indent ' ')

let write_gap w next =
  (match w.gap with
   | Nothing -> ()
   | Spaces s -> write w s
   | Soft (s, indent) ->
     if w.column + String.length s + String.length next > width then write_newline w indent else write w s
   | Newline { indent; _ } -> write_newline w indent);
  w.gap <- Nothing

(* {1 Comments} *)

let write_comment w ~indent ~closing (c : Trivia.t) =
  let keep, inner =
    match w.gap with
    | Newline { indent; keep } -> (keep, if closing then indent + 2 else indent)
    | Nothing | Spaces _ | Soft _ -> (false, indent)
  in
  let after = match w.gap with Newline _ as g -> g | _ -> Newline { indent; keep } in
  if c.own_line || w.in_line_comment then begin
    write_newline w inner;
    write w c.text;
    w.gap <- after
  end
  else begin
    write w " ";
    write w c.text;
    match (c.kind, w.gap) with
    | Line, _ -> w.gap <- after
    | (Block | Blank), Nothing -> w.gap <- Spaces " "
    | (Block | Blank), _ -> ()
  end;
  w.in_line_comment <- (match c.kind with Line -> true | Block | Blank -> false)

let rec write_trivia w ~indent ~closing before =
  match w.trivia with
  | c :: rest when c.start < before ->
    w.trivia <- rest;
    (* an empty line within the piece before is no empty line behind it *)
    let is_next at = Int.equal c.stop at in
    let is_here = is_next before || (match rest with next :: _ -> is_next next.start | [] -> false) in
    (match (c.kind, w.gap) with
     | Blank, Newline { keep = true; _ } when is_here -> w.empty_line <- true
     | Blank, _ -> ()
     | (Line | Block), _ -> write_comment w ~indent ~closing c);
    write_trivia w ~indent ~closing before
  | _ -> ()

(* {1 Groups} *)

(* The columns of a document on one line, or more than [room]. *)
let flat_width room d =
  let rec add n d =
    if n > room then n
    else
      match d with
      | Text (_, s) | Closing (_, s) | Fill s -> n + String.length s
      | Space -> n + 1
      | Line | Paragraph -> room + 1
      | Nest (_, d) | Group d -> add n d
      | Cat ds -> List.fold_left add n ds
  in
  add 0 d

let rec first_offset = function
  | Text (at, _) | Closing (at, _) -> Some at
  | Space | Fill _ | Line | Paragraph -> None
  | Nest (_, d) | Group d -> first_offset d
  | Cat ds -> List.find_map first_offset ds

let rec last_offset = function
  | Text (at, _) | Closing (at, _) -> Some at
  | Space | Fill _ | Line | Paragraph -> None
  | Nest (_, d) | Group d -> last_offset d
  | Cat ds -> List.find_map last_offset (List.rev ds)

let has_comment_inside w d =
  match (first_offset d, last_offset d) with
  | Some first, Some last ->
    let rec look = function
      | (c : Trivia.t) :: rest when c.start < last ->
        (c.start > first && Trivia.is_comment c) || look rest
      | _ -> false
    in
    look w.trivia
  | _ -> false

let fits w d =
  let column =
    match w.gap with
    | Nothing -> w.column
    | Spaces s | Soft (s, _) -> w.column + String.length s
    | Newline { indent; _ } -> indent
  in
  let room = width - column in
  flat_width room d <= room && not (has_comment_inside w d)

(* {1 Rendering} *)

let piece w ~indent ~closing at s =
  write_trivia w ~indent ~closing at;
  write_gap w s;
  write w s

let rec render_in w ~indent ~flat = function
  | Text (at, s) -> piece w ~indent ~closing:false at s
  | Closing (at, s) -> piece w ~indent ~closing:true at s
  | Cat ds -> List.iter (render_in w ~indent ~flat) ds
  | Space -> w.gap <- (if flat then Spaces " " else Newline { indent; keep = false })
  | Fill s -> w.gap <- (if flat then Spaces s else Soft (s, indent))
  | Line -> w.gap <- Newline { indent; keep = false }
  | Paragraph -> w.gap <- Newline { indent; keep = true }
  | Nest (n, d) -> render_in w ~indent:(indent + n) ~flat d
  | Group d -> render_in w ~indent ~flat:(flat || fits w d) d

let render trivia d =
  let w =
    { buffer = Buffer.create 4096; column = 0; gap = Newline { indent = 0; keep = true };
      empty_line = false; in_line_comment = false; trivia }
  in
  render_in w ~indent:0 ~flat:false d;
  w.gap <- Newline { indent = 0; keep = true };
  write_trivia w ~indent:0 ~closing:false max_int;
  if Buffer.length w.buffer > 0 then Buffer.add_char w.buffer '\n';
  Buffer.contents w.buffer
