type encoding = Utf8 | Utf16 | Utf32

let name = function Utf8 -> "utf-8" | Utf16 -> "utf-16" | Utf32 -> "utf-32"

let known = function "utf-8" -> Some Utf8 | "utf-16" -> Some Utf16 | "utf-32" -> Some Utf32 | _ -> None
let chosen names = Option.value (List.find_map known names) ~default:Utf16

(* [units.(k)] is the number of units before the byte [k * stride]. Without them each byte is a unit. *)
type t = { encoding : encoding; text : string; starts : int array; units : int array option }

let stride = 64

(* What the byte adds to the units, as the first of a code point or as a part of one. *)
let weight encoding c =
  match encoding with
  | Utf8 -> 1
  | Utf16 -> if Char.code c land 0xC0 = 0x80 then 0 else if Char.code c >= 0xF0 then 2 else 1
  | Utf32 -> if Char.code c land 0xC0 = 0x80 then 0 else 1

let line_starts text =
  let n = String.length text in
  let rec collect i found =
    if i >= n then found
    else
      match text.[i] with
      | '\n' -> collect (i + 1) ((i + 1) :: found)
      | '\r' when i + 1 < n && text.[i + 1] = '\n' -> collect (i + 2) ((i + 2) :: found)
      | '\r' -> collect (i + 1) ((i + 1) :: found)
      | _ -> collect (i + 1) found
  in
  Array.of_list (List.rev (collect 0 [ 0 ]))

let is_ascii text = String.for_all (fun c -> Char.code c < 128) text

let make encoding text =
  let starts = line_starts text in
  let units =
    if is_ascii text || (match encoding with Utf8 -> true | Utf16 | Utf32 -> false) then None
    else begin
      let units = Array.make ((String.length text / stride) + 1) 0 and total = ref 0 in
      String.iteri
        (fun i c ->
           if i mod stride = 0 then units.(i / stride) <- !total;
           total := !total + weight encoding c)
        text;
      if String.length text mod stride = 0 then units.(String.length text / stride) <- !total;
      Some units
    end
  in
  { encoding; text; starts; units }

let lines t = Array.length t.starts

(* The last index at which [f] is at most [x]. *)
let last_at_most count f (x : int) =
  let rec search low high =
    if low >= high then low
    else
      let middle = (low + high + 1) / 2 in
      if f middle <= x then search middle high else search low (middle - 1)
  in
  search 0 (count - 1)

let units_before t offset =
  match t.units with
  | None -> offset
  | Some units ->
    let k = offset / stride in
    let rec add i total = if i >= offset then total else add (i + 1) (total + weight t.encoding t.text.[i]) in
    add (k * stride) units.(k)

let of_offset t offset =
  let offset = Int.max 0 (Int.min offset (String.length t.text)) in
  let line = last_at_most (lines t) (Array.get t.starts) offset in
  (line, units_before t offset - units_before t t.starts.(line))

(* The end of a line, before the marks that end it. *)
let end_of t line =
  if line + 1 >= lines t then String.length t.text
  else
    let stop = t.starts.(line + 1) in
    let both = stop >= 2 && t.text.[stop - 1] = '\n' && t.text.[stop - 2] = '\r' in
    if both && stop - 2 >= t.starts.(line) then stop - 2 else stop - 1

(* The offset before which there are so many units. *)
let offset_of t total ~from ~stop =
  let start =
    match t.units with
    | None -> Int.min stop total
    | Some units ->
      let k = last_at_most (Array.length units) (Array.get units) total in
      let rec go i count =
        if i >= stop then stop
        else
          let more = weight t.encoding t.text.[i] in
          let continues = Char.code t.text.[i] land 0xC0 = 0x80 in
          if continues || count + more <= total then go (i + 1) (count + more) else i
      in
      go (k * stride) units.(k)
  in
  let continues i = Char.code t.text.[i] land 0xC0 = 0x80 in
  let rec boundary i = if i > from && i < stop && continues i then boundary (i - 1) else i in
  Int.max from (boundary (Int.min start stop))

let offset t (line, character) =
  if line < 0 then 0
  else if line >= lines t then String.length t.text
  else
    let from = t.starts.(line) and stop = end_of t line in
    offset_of t (units_before t from + Int.max 0 (Int.min character (String.length t.text))) ~from ~stop
