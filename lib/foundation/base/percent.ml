let digit c =
  match c with
  | '0' .. '9' -> Some (Char.code c - 48)
  | 'a' .. 'f' -> Some (Char.code c - 87)
  | 'A' .. 'F' -> Some (Char.code c - 55)
  | _ -> None

(* The byte that is written from [i] on, where a percent sign stands. *)
let byte text i =
  if i + 2 >= String.length text then None
  else
    match (digit text.[i + 1], digit text.[i + 2]) with
    | Some high, Some low -> Some (Char.chr ((16 * high) + low))
    | _ -> None

let decode text =
  let b = Buffer.create (String.length text) in
  let rec from i valid =
    if i >= String.length text then (Buffer.contents b, valid)
    else
      match if text.[i] = '%' then byte text i else None with
      | Some c ->
        Buffer.add_char b c;
        from (i + 3) valid
      | None ->
        Buffer.add_char b text.[i];
        from (i + 1) (valid && text.[i] <> '%')
  in
  from 0 true

let decoded text = fst (decode text)
let decoded_strictly text = match decode text with decoded, true -> Some decoded | _, false -> None
