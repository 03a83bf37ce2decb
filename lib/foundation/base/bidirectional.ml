let size = 3

let at s i =
  if s.[i] <> '\xE2' || i + size > String.length s then None
  else
    match (s.[i + 1], s.[i + 2]) with
    | '\x80', ('\xAA' .. '\xAE' as c) -> Some (0x2000 + (Char.code c - 0x80))
    | '\x81', ('\xA6' .. '\xA9' as c) -> Some (0x2040 + (Char.code c - 0x80))
    | _ -> None

(* The first from an offset on, and what it is. *)
let rec next s i =
  match String.index_from_opt s i '\xE2' with
  | None -> None
  | Some i -> (match at s i with Some code -> Some (i, code) | None -> next s (i + 1))

let named = Printf.sprintf "U+%04X"
