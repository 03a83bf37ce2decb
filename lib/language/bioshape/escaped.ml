(* What a terminal does not show as it is ({!Scc_base.Visible}) is written as a reference, as it may have been
   read. *)
let escaped ~quoted s =
  let b = Buffer.create (String.length s + 2) in
  (* `]]>` may stand nowhere but at the end of a marked section. *)
  let ends_section i = i >= 2 && s.[i - 1] = ']' && s.[i - 2] = ']' in
  let reference code = Printf.bprintf b "&#%d;" code in
  let add i = function
    | '>' when not (ends_section i) -> Buffer.add_char b '>'
    | '"' when not quoted -> Buffer.add_char b '"'
    | c -> Scc_base.Markup.add b c
  in
  let rec from i =
    if i < String.length s then
      match Scc_base.Visible.at s i with
      | Some (code, length) when quoted || not (s.[i] = '\t' || s.[i] = '\n') ->
        reference code;
        from (i + length)
      | Some _ | None ->
        add i s.[i];
        from (i + 1)
  in
  from 0;
  Buffer.contents b

let attribute s = "\"" ^ escaped ~quoted:true s ^ "\""
let content s = escaped ~quoted:false s

(* The length of what no character of XML is, at [i]; U+FFFE and U+FFFF are EF BF BE and EF BF BF. *)
let foreign s i =
  let last c = c = '\xBE' || c = '\xBF' in
  match s.[i] with
  | '\x09' | '\x0A' | '\x0D' -> 0
  | c when c < ' ' -> 1
  | '\xEF' when i + 2 < String.length s && s.[i + 1] = '\xBF' && last s.[i + 2] -> 3
  | _ -> 0

let only_characters s =
  let b = Buffer.create (String.length s) in
  let rec go i =
    if i < String.length s then
      match foreign s i with
      | 0 ->
        Buffer.add_char b s.[i];
        go (i + 1)
      | n ->
        Buffer.add_char b ' ';
        go (i + n)
  in
  go 0;
  Buffer.contents b

let is_text s = String.equal (only_characters s) s
