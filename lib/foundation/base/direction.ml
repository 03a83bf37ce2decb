open Constant_stack

let most = 20

(* What no text has, as whoever reads models says. *)
let is_text s =
  not (String.exists (fun c -> (c < ' ' && c <> '\t' && c <> '\n' && c <> '\r' && c <> '\012') || c = '\127') s)

(* The offset after the line that an offset is in: lines end as {!Source} has them. *)
let after_line s i = match String.index_from_opt s i '\n' with Some j -> j + 1 | None -> String.length s

(* Which there are from an offset up to another, each once, in order. *)
let rec within s i stop found =
  match Bidirectional.next s i with
  | Some (j, code) when j < stop ->
    within s (j + Bidirectional.size) stop (if List.mem code found then found else code :: found)
  | Some _ | None -> List.rev found

let hint = "reports of scc show them by their numbers; take them out, or keep them if the text is meant so"

let warning source at codes =
  let span = Span.make ~file:(Source.name source) ~start:at ~stop:(at + Bidirectional.size) in
  let what, change = match codes with [ _ ] -> ("character", "changes") | _ -> ("characters", "change") in
  Diag.warning ~hint Code.direction span
    "the %s %s on this line %s the direction in which it is shown: what is read may not be what is seen" what
    (String.concat ", " (List.map Bidirectional.named codes))
    change

let more source at count =
  let span = Span.make ~file:(Source.name source) ~start:at ~stop:(at + Bidirectional.size) in
  Diag.warning ~hint Code.direction span
    "on %d more lines, of which this is the first, are characters that change the direction of the text" count

let warnings source =
  let s = Source.text source in
  (* [beyond]: the first place beyond the lines that are told, and how many lines there are from it on. *)
  let rec go i count found beyond =
    match (Bidirectional.next s i, beyond) with
    | None, None -> List.rev found
    | None, Some (at, lines) -> List.rev (more source at lines :: found)
    | Some (j, _), None when count = most -> go (after_line s j) count found (Some (j, 1))
    | Some (j, _), None ->
      let stop = after_line s j in
      go stop (count + 1) (warning source j (within s j stop []) :: found) None
    | Some (j, _), Some (at, lines) -> go (after_line s j) count found (Some (at, lines + 1))
  in
  if Option.is_some (Bidirectional.next s 0) && is_text s then go 0 0 [] None else []
