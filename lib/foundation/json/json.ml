open Scc_base
open Scc_exact

type t =
  [ `Null
  | `Bool of bool
  | `Int of int
  | `Float of float
  | `String of string
  | `List of t list
  | `Assoc of (string * t) list ]

let utf_8 s =
  let b = Buffer.create (String.length s) in
  let rec from i =
    if i < String.length s then
      match Utf8.length s i with
      | 0 ->
        Buffer.add_string b "\xef\xbf\xbd";
        from (i + 1)
      | k ->
        Buffer.add_substring b s i k;
        from (i + k)
  in
  from 0;
  Buffer.contents b

let text s = `String (utf_8 s)
let fraction (q : Rat.t) = Z.to_string (Q.num q) ^ "/" ^ Z.to_string (Q.den q)
let rat q = `String (fraction q)
let vec (v : Vec.t) = `List [ rat v.x; rat v.y; rat v.z ]
let option encode = function None -> `Null | Some x -> encode x

(* The writer is our own, so that the bytes do not depend on the version of a library. *)
let add_string b s =
  let add = function
    | '"' -> Buffer.add_string b "\\\""
    | '\\' -> Buffer.add_string b "\\\\"
    | '\n' -> Buffer.add_string b "\\n"
    | '\t' -> Buffer.add_string b "\\t"
    | c -> Buffer.add_char b c
  in
  let rec from i =
    if i < String.length s then
      match (s.[i], Visible.at s i) with
      | ('\n' | '\t'), _ | _, None ->
        add s.[i];
        from (i + 1)
      | _, Some (code, length) ->
        Printf.bprintf b "\\u%04x" code;
        from (i + length)
  in
  Buffer.add_char b '"';
  from 0;
  Buffer.add_char b '"'

let between b separator write items =
  List.iteri
    (fun i x ->
       if i > 0 then Buffer.add_string b separator;
       write x)
    items

let rec add b ~comma ~colon (json : t) =
  match json with
  | `Null -> Buffer.add_string b "null"
  | `Bool x -> Buffer.add_string b (string_of_bool x)
  | `Int n -> Buffer.add_string b (string_of_int n)
  | `Float _ -> Bug.fail __POS__ "a float in JSON"
  | `String s -> add_string b s
  | `List items ->
    Buffer.add_char b '[';
    between b comma (add b ~comma ~colon) items;
    Buffer.add_char b ']'
  | `Assoc members ->
    Buffer.add_char b '{';
    between b comma
      (fun (key, value) ->
         add_string b key;
         Buffer.add_string b colon;
         add b ~comma ~colon value)
      members;
    Buffer.add_char b '}'

let written ~comma ~colon json =
  let b = Buffer.create 1024 in
  add b ~comma ~colon json;
  Buffer.contents b

let line json = written ~comma:"," ~colon:":" json

(* What fits in so many bytes is written on one line. *)
let width = 88

exception Too_long

(* The text on one line, if it has at most so many bytes; most of a longer one is never written. *)
let short_line ~most json =
  let b = Buffer.create 128 in
  let checked f x =
    f x;
    if Buffer.length b > most then raise_notrace Too_long
  in
  let rec add_checked (json : t) =
    match json with
    | `List items ->
      Buffer.add_char b '[';
      between b ", " (checked add_checked) items;
      Buffer.add_char b ']'
    | `Assoc members ->
      let member (key, value) =
        add_string b key;
        Buffer.add_string b ": ";
        add_checked value
      in
      Buffer.add_char b '{';
      between b ", " (checked member) members;
      Buffer.add_char b '}'
    | _ -> add b ~comma:"," ~colon:":" json
  in
  match checked add_checked json with
  | () -> Some (Buffer.contents b)
  | exception Too_long -> None

let rec add_pretty b ~written_some indent (json : t) =
  let deeper = indent ^ "  " in
  let block opening closing write items =
    Buffer.add_char b opening;
    List.iteri
      (fun i x ->
         Buffer.add_string b (if i > 0 then ",\n" else "\n");
         Buffer.add_string b deeper;
         write x;
         written_some ())
      items;
    Buffer.add_string b ("\n" ^ indent);
    Buffer.add_char b closing
  in
  match (short_line ~most:(width - String.length indent) json, json) with
  | Some short, _ -> Buffer.add_string b short
  | None, `List items -> block '[' ']' (add_pretty b ~written_some deeper) items
  | None, `Assoc members ->
    block '{' '}'
      (fun (key, value) ->
         add_string b key;
         Buffer.add_string b ": ";
         add_pretty b ~written_some deeper value)
      members
  | None, _ -> add b ~comma:"," ~colon:":" json

let piece = 65536

let pretty_pieces put json =
  let b = Buffer.create (2 * piece) in
  let send () =
    put (Buffer.contents b);
    Buffer.clear b
  in
  add_pretty b ~written_some:(fun () -> if Buffer.length b >= piece then send ()) "" json;
  Buffer.add_char b '\n';
  send ()

let pretty json =
  let b = Buffer.create 1024 in
  pretty_pieces (Buffer.add_string b) json;
  Buffer.contents b

let max_depth = 200

(* The parser is recursive: how deep the text would take it is found first. *)
let too_deep s start stop =
  let depth = ref 0 and quoted = ref false and escaped = ref false and deepest = ref 0 in
  for i = start to stop - 1 do
    if !escaped then escaped := false
    else
      match s.[i] with
      | '\\' when !quoted -> escaped := true
      | '"' -> quoted := not !quoted
      | ('[' | '{') when not !quoted ->
        incr depth;
        if !depth > !deepest then deepest := !depth
      | (']' | '}') when not !quoted -> decr depth
      | _ -> ()
  done;
  !deepest > max_depth

(* Yojson starts its messages with 'Line 3, bytes 10-12:'. *)
let fault_line message =
  try Scanf.sscanf message "Line %d," (fun l -> Some l)
  with Scanf.Scan_failure _ | End_of_file | Failure _ -> None

(* Two faults are of JSON that no value can hold. *)
let fault message =
  let n = String.length message in
  let has part =
    let m = String.length part in
    let rec at i = i + m <= n && (String.equal (String.sub message i m) part || at (i + 1)) in
    at 0
  in
  if has ":\nInt overflow" then "an integer has too many digits"
  else if has " low surrogate for code point" then "half of a surrogate pair stands alone, and is no character"
  else "this is not JSON"

let rec line_start s from n =
  if n <= 1 then from
  else
    match String.index_from_opt s from '\n' with
    | Some i when i + 1 < String.length s -> line_start s (i + 1) (n - 1)
    | _ -> from

let parse_line source ~start ~stop =
  let s = Source.text source in
  let span start stop = Span.make ~file:(Source.name source) ~start ~stop in
  if too_deep s start stop then
    Error (Diag.error Code.bad_schedule (span start (start + 1)) "values are nested deeper than %d" max_depth)
  else
    match Yojson.Basic.from_string (String.sub s start (stop - start)) with
    | json -> Ok json
    | exception Yojson.Json_error message ->
      let at = match fault_line message with Some l -> line_start s start l | None -> start in
      Error (Diag.error Code.bad_schedule (span at (at + 1)) "%s" (fault message))

let parse source =
  let s = Source.text source in
  parse_line source ~start:(Source.after_mark s) ~stop:(String.length s)

let member (key : string) = function
  | `Assoc members -> (
      match List.assoc_opt key members with None | Some `Null -> None | Some v -> Some v)
  | _ -> None

let string = function `String s -> Some s | _ -> None
let int = function `Int i -> Some i | _ -> None
let list = function `List l -> Some l | _ -> None

let rational = function
  | `Int i -> Some (Rat.of_int i)
  | `String s -> ( match Rat.of_literal s with Ok q -> Some q | Error _ -> None)
  | _ -> None
