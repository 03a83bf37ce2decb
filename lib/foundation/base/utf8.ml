type fault = Invalid of int | Control of { at : int; size : int; code : int }

let byte s i = Char.code (String.unsafe_get s i)

(* The length of the well-formed sequence at [i], or 0 (Unicode, table 3-7). *)
let length s i =
  let n = String.length s in
  let within k low high = i + k < n && byte s (i + k) >= low && byte s (i + k) <= high in
  let tail k = within k 0x80 0xBF in
  match byte s i with
  | b when b < 0x80 -> 1
  | b when b >= 0xC2 && b <= 0xDF -> if tail 1 then 2 else 0
  | 0xE0 -> if within 1 0xA0 0xBF && tail 2 then 3 else 0
  | 0xED -> if within 1 0x80 0x9F && tail 2 then 3 else 0
  | b when b >= 0xE1 && b <= 0xEF -> if tail 1 && tail 2 then 3 else 0
  | 0xF0 -> if within 1 0x90 0xBF && tail 2 && tail 3 then 4 else 0
  | 0xF4 -> if within 1 0x80 0x8F && tail 2 && tail 3 then 4 else 0
  | b when b >= 0xF1 && b <= 0xF3 -> if tail 1 && tail 2 && tail 3 then 4 else 0
  | _ -> 0

let code_point_at s i =
  let tail k = byte s (i + k) land 0x3F in
  match length s i with
  | 2 -> ((byte s i land 0x1F) lsl 6) lor tail 1
  | 3 -> ((byte s i land 0x0F) lsl 12) lor (tail 1 lsl 6) lor tail 2
  | 4 -> ((byte s i land 0x07) lsl 18) lor (tail 1 lsl 12) lor (tail 2 lsl 6) lor tail 3
  | _ -> byte s i

let code_point s = code_point_at s 0
let is_control code = code < 0x20 || (code >= 0x7F && code < 0xA0)

(* Tab, line feed, form feed and carriage return. *)
let is_of_text code = code = 0x09 || code = 0x0A || code = 0x0C || code = 0x0D

let check s =
  let rec from i =
    if i >= String.length s then None
    else
      match length s i with
      | 0 -> Some (Invalid i)
      | size ->
        let code = code_point_at s i in
        if is_control code && not (is_of_text code) then Some (Control { at = i; size; code }) else from (i + size)
  in
  from 0

let rec boundary s i =
  if i <= 0 || i >= String.length s || byte s i land 0xC0 <> 0x80 then i else boundary s (i - 1)
