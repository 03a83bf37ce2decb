let utf_8 s = match Scc_json.Json.text s with `String s -> s | _ -> s

let quoted s =
  let b = Buffer.create (String.length s + 2) in
  let add = function
    | '\'' -> Buffer.add_string b "&apos;"
    | ('\t' | '\n' | '\r') as c -> Buffer.add_string b (Printf.sprintf "&#%d;" (Char.code c))
    | c when c < ' ' -> Buffer.add_string b "\xef\xbf\xbd"
    | c -> Scc_base.Markup.add b c
  in
  Buffer.add_char b '\'';
  String.iter add (utf_8 s);
  Buffer.add_char b '\'';
  Buffer.contents b

let name s =
  String.map (function ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '-') as c -> c | _ -> '_') s
