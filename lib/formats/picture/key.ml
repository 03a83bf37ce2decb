open Scc_exact
open Scc_svg

type sample = Swatch of { fill : string; stroke : string } | Hatch of string | Glyph of string list
type entry = { sample : sample; text : string }

let letter_wide = 7
let row_high = 20
let sample_wide = 24
let number = string_of_int
let ink = "#1f2328"

let sample = function
  | Glyph elements -> elements
  | (Swatch _ | Hatch _) as s ->
    let at = [ ("x", "-9"); ("y", "-6"); ("width", "18"); ("height", "12") ] in
    let fill, stroke = match s with Swatch { fill; stroke } -> (fill, stroke) | _ -> ("#ffffff", ink) in
    let rect fill = Svg.tag "rect" (at @ [ ("fill", fill); ("stroke", stroke); ("stroke-width", "1") ]) [] in
    rect fill @ (match s with Hatch id -> rect ("url(#" ^ id ^ ")") | _ -> [])

let entry x y e =
  let moved = Printf.sprintf "translate(%d %d)" (x + 9) y in
  Svg.tag "g" [ ("transform", moved) ] (sample e.sample)
  @ Svg.text [ ("x", number (x + sample_wide)); ("y", number (y + 4)); ("fill", ink) ] e.text

let rows ~left ~width ~top entries =
  let add (x, y, found) e =
    let wide = sample_wide + (letter_wide * String.length e.text) + 18 in
    let x, y = if x > left && x + wide > left + width then (left, y + row_high) else (x, y) in
    (x + wide, y, List.rev_append (entry x y e) found)
  in
  let _, y, found = List.fold_left add (left, top + (row_high / 2), []) entries in
  (List.rev found, match entries with [] -> 0 | _ :: _ -> y + (row_high / 2) - top)

type note = { badge : string list; text : string }

let line_high = 17

(* The words of a text in lines of at most so many letters, or of one word that is longer. *)
let wrapped letters text =
  let add (lines, line) word =
    if line = "" then (lines, word)
    else if String.length line + 1 + String.length word <= letters then (lines, line ^ " " ^ word)
    else (line :: lines, word)
  in
  let lines, last = List.fold_left add ([], "") (String.split_on_char ' ' text) in
  List.rev (last :: lines)

let notes ~left ~width ~top all =
  let letters = max 10 ((width - sample_wide - 8) / letter_wide) in
  let add (y, found) note =
    let moved = Printf.sprintf "translate(%d %d)" (left + 12) y in
    let badge = Svg.tag "g" [ ("transform", moved) ] note.badge in
    let line i text =
      let x = match note.badge with [] -> left | _ :: _ -> left + sample_wide + 8 in
      let at = [ ("x", number x); ("y", number (y + 4 + (i * line_high))) ] in
      Svg.text (at @ [ ("fill", ink) ]) text
    in
    let lines = wrapped letters note.text in
    let text = List.concat (List.mapi line lines) in
    (y + 5 + (line_high * List.length lines), List.rev_append (badge @ text) found)
  in
  let y, found = List.fold_left add (top + (row_high / 2), []) all in
  (List.rev found, y - (row_high / 2) - top)

let bar canvas ~left ~top =
  let length = Canvas.bar canvas ~most:160 in
  let wide = Rat.mul length canvas.unit_length in
  let x = Rat.of_int left and y k = Rat.of_int (top + k) in
  let right = Rat.add x wide in
  let data =
    Svg.segments [ ((x, y 12), (right, y 12)); ((x, y 8), (x, y 16)); ((right, y 8), (right, y 16)) ]
  in
  let label = Option.value ~default:(Rat.to_string length) (Decimal.exact length) in
  Svg.tag "path" [ ("d", data); ("stroke", ink); ("stroke-width", "1.5"); ("fill", "none") ] []
  @ Svg.text
    [ ("x", Svg.number (Rat.add right (Rat.of_int 8))); ("y", Svg.number (y 16)); ("fill", ink) ]
    label
