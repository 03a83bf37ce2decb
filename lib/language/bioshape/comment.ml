open Scc_syntax

let unix_line_ends text =
  let b = Buffer.create (String.length text) in
  String.iteri
    (fun i c ->
       if c <> '\r' then Buffer.add_char b c
       else if i + 1 >= String.length text || text.[i + 1] <> '\n' then Buffer.add_char b '\n')
    text;
  Buffer.contents b

(* [f b count] between two hyphens with so many backslashes between them, and nothing else; the end counts as a
   hyphen. *)
let between_hyphens f s =
  let b = Buffer.create (String.length s) and n = String.length s in
  let backslashes count = Buffer.add_string b (String.make count '\\') in
  let rec go i =
    if i < n then begin
      Buffer.add_char b s.[i];
      if s.[i] = '-' then
        let rec stop j = if j < n && s.[j] = '\\' then stop (j + 1) else j in
        let j = stop (i + 1) in
        let count = j - i - 1 in
        backslashes (if j >= n || s.[j] = '-' then f count else count);
        go j
      else go (i + 1)
    end
  in
  go 0;
  Buffer.contents b

let written (c : Trivia.t) =
  let inside n m = String.sub c.text n (max 0 (String.length c.text - n - m)) in
  let as_xml s = "<!--" ^ between_hyphens succ (Escaped.only_characters s) ^ "-->" in
  match c.kind with
  | Blank -> c
  | Line -> { c with kind = Block; text = as_xml (inside 2 0 ^ " ") }
  | Block -> { c with text = as_xml (inside 2 2) }

(* Marks of comments in a comment would end it, or begin another one. *)
let rec unmarked s =
  let b = Buffer.create (String.length s) in
  let touching a c = (a = '*' && c = '/') || (a = '/' && c = '*') in
  String.iteri
    (fun i c ->
       if i > 0 && touching s.[i - 1] c then Buffer.add_char b ' ';
       Buffer.add_char b c)
    s;
  if Buffer.length b = String.length s then s else unmarked (Buffer.contents b)

let without_spaces_at_end s =
  let rec stop i = if i > 0 && (s.[i - 1] = ' ' || s.[i - 1] = '\t') then stop (i - 1) else i in
  String.sub s 0 (stop (String.length s))

let read inner =
  let inner = between_hyphens (fun count -> max 0 (count - 1)) (unix_line_ends inner) in
  let apart = if String.length inner > 0 && inner.[String.length inner - 1] = '/' then " " else "" in
  if String.contains inner '\n' then (Trivia.Block, "/*" ^ unmarked inner ^ apart ^ "*/")
  else (Line, without_spaces_at_end ("//" ^ inner))
