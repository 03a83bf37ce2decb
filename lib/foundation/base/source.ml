type t = { name : string; text : string; starts : int array }

let line_starts text =
  let acc = ref [ 0 ] in
  String.iteri (fun i c -> if c = '\n' then acc := (i + 1) :: !acc) text;
  Array.of_list (List.rev !acc)

let byte_order_mark = "\xEF\xBB\xBF"
let has_mark text = String.length text >= 3 && String.equal (String.sub text 0 3) byte_order_mark
let after_mark text = if has_mark text then 3 else 0
let blank_mark text = if has_mark text then "   " ^ String.sub text 3 (String.length text - 3) else text
let make ~name text = { name; text; starts = line_starts text }
let name s = s.name
let text s = s.text

(* The index of the last line that starts at or before [offset]. *)
let line_index s offset =
  let rec search lo hi =
    if hi - lo <= 1 then lo
    else
      let mid = (lo + hi) / 2 in
      if s.starts.(mid) <= offset then search mid hi else search lo mid
  in
  search 0 (Array.length s.starts)

let is_continuation c = Char.code c land 0xC0 = 0x80

let position s offset =
  let offset = max 0 (min offset (String.length s.text)) in
  let l = line_index s offset in
  let column = ref 1 in
  for i = (if l = 0 then after_mark s.text else s.starts.(l)) to offset - 1 do
    if not (is_continuation s.text.[i]) then incr column
  done;
  (l + 1, !column)

let line s n =
  if n < 1 || n > Array.length s.starts then ""
  else
    let start = if n = 1 then after_mark s.text else s.starts.(n - 1) in
    let stop =
      if n < Array.length s.starts then s.starts.(n) - 1
      else String.length s.text
    in
    let stop = if stop > start && s.text.[stop - 1] = '\r' then stop - 1 else stop in
    String.sub s.text start (stop - start)
