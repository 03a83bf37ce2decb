open Scc_base
open Scc_json

type t = Value of Json.t | Fields of (string * t) list | Printed of string list

let of_format format x = Value (Json_format.write format x)

let is_plain s i c = c <> '"' && c <> '\\' && Option.is_none (Visible.at s i)

let add_string b s =
  let n = String.length s in
  let rec go from i =
    if i = n then Buffer.add_substring b s from (n - from)
    else
      let c = String.unsafe_get s i in
      if is_plain s i c then go from (i + 1)
      else begin
        Buffer.add_substring b s from (i - from);
        (match c with
         | '"' -> Buffer.add_string b "\\\""
         | '\\' -> Buffer.add_string b "\\\\"
         | '\n' -> Buffer.add_string b "\\n"
         | '\t' -> Buffer.add_string b "\\t"
         | c -> Printf.bprintf b "\\u%04x" (Option.fold ~none:(Char.code c) ~some:fst (Visible.at s i)));
        let next = i + Option.fold ~none:1 ~some:snd (Visible.at s i) in
        go next next
      end
  in
  Buffer.add_char b '"';
  go 0 0;
  Buffer.add_char b '"'

let add_list b add items =
  let rec more = function
    | [] -> ()
    | x :: rest ->
      Buffer.add_char b ',';
      add x;
      more rest
  in
  match items with
  | [] -> ()
  | x :: rest ->
    add x;
    more rest

let add_member b add (name, x) =
  add_string b name;
  Buffer.add_char b ':';
  add x

let rec add_json b (json : Json.t) =
  match json with
  | `Null -> Buffer.add_string b "null"
  | `Bool x -> Buffer.add_string b (if x then "true" else "false")
  | `Int n -> Buffer.add_string b (string_of_int n)
  | `Float x -> Buffer.add_string b (Float_text.shortest x)
  | `String s -> add_string b s
  | `List items ->
    Buffer.add_char b '[';
    add_list b (add_json b) items;
    Buffer.add_char b ']'
  | `Assoc members ->
    Buffer.add_char b '{';
    add_list b (add_member b (add_json b)) members;
    Buffer.add_char b '}'

let rec add b = function
  | Value json -> add_json b json
  | Fields members ->
    Buffer.add_char b '{';
    add_list b (add_member b (add b)) members;
    Buffer.add_char b '}'
  | Printed texts ->
    Buffer.add_char b '[';
    add_list b (Buffer.add_string b) texts;
    Buffer.add_char b ']'

let head b (id : Wire.t) =
  Buffer.add_string b "{\"jsonrpc\":\"2.0\",\"id\":";
  match id with
  | Number s -> Buffer.add_string b s
  | Text s -> add_string b s
  | Null | Bool _ | List _ | Object _ -> Buffer.add_string b "null"

let result b ~id answer =
  head b id;
  Buffer.add_string b ",\"result\":";
  add b answer;
  Buffer.add_char b '}'

let error b ~id fault =
  head b id;
  Buffer.add_string b ",\"error\":";
  add_json b (Json_format.write Fault.format fault);
  Buffer.add_char b '}'
