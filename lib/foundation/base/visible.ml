let at s i =
  match s.[i] with
  | ('\x00' .. '\x1f' | '\x7f') as c -> Some (Char.code c, 1)
  | '\xC2' when i + 1 < String.length s && s.[i + 1] >= '\x80' && s.[i + 1] < '\xA0' ->
    Some (Char.code s.[i + 1], 2)
  | '\xE2' -> Option.map (fun code -> (code, Bidirectional.size)) (Bidirectional.at s i)
  | _ -> None

let begins s i part =
  let n = String.length part in
  i + n <= String.length s && String.equal (String.sub s i n) part

(* Most texts are plain. *)
let is_plain c = (c >= ' ' && c < '\x7f') || c = '\n' || c = '\t'

let written ~stays ~kept s =
  let b = Buffer.create (String.length s + 64) in
  let add_sub i length =
    Buffer.add_substring b s i length;
    i + length
  in
  let next i =
    match (if stays s.[i] then Some "" else List.find_opt (begins s i) kept) with
    | Some part -> add_sub i (Int.max 1 (String.length part))
    | None -> (
        match at s i with
        | Some (code, length) ->
          Buffer.add_string b ("<" ^ Bidirectional.named code ^ ">");
          i + length
        | None -> (
            match Utf8.length s i with
            | 0 ->
              Printf.bprintf b "<0x%02X>" (Char.code s.[i]);
              i + 1
            | length -> add_sub i length))
  in
  let rec from i = if i < String.length s then from (next i) in
  from 0;
  Buffer.contents b

let text ?(kept = []) s = if String.for_all is_plain s then s else written ~stays:is_plain ~kept s
let line s = written ~stays:(fun c -> c >= ' ' && c < '\x7f') ~kept:[] s
