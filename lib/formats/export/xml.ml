let utf_8 s = match Scc_json.Json.text s with `String s -> s | _ -> s

let quoted s =
  let b = Buffer.create (String.length s + 2) in
  let add = function
    | '<' -> Buffer.add_string b "&lt;"
    | '>' -> Buffer.add_string b "&gt;"
    | '&' -> Buffer.add_string b "&amp;"
    | '\'' -> Buffer.add_string b "&apos;"
    | '"' -> Buffer.add_string b "&quot;"
    | ('\t' | '\n' | '\r') as c -> Buffer.add_string b (Printf.sprintf "&#%d;" (Char.code c))
    | c when c < ' ' -> Buffer.add_string b "\xef\xbf\xbd"
    | c -> Buffer.add_char b c
  in
  Buffer.add_char b '\'';
  String.iter add (utf_8 s);
  Buffer.add_char b '\'';
  Buffer.contents b

let name s =
  String.map (function ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '-') as c -> c | _ -> '_') s
