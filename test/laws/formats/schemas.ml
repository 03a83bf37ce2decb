(* schemas.exe: writes each schema that follows from formats to its file in this folder. *)

open Scc_json

(* {1 Layout} *)

let width = 115

let rec short : Json.t -> string = function
  | `List items -> "[" ^ String.concat ", " (List.map short items) ^ "]"
  | `Assoc members -> "{" ^ String.concat ", " (List.map (member short) members) ^ "}"
  | json -> Json.line json

and member : type a. (a -> string) -> string * a -> string =
  fun text (name, x) -> Json.line (`String name) ^ ": " ^ text x

let is_text : Json.t -> bool = function `String _ -> true | _ -> false

(* As many texts on each line as there is room for. *)
let filled indent texts =
  let add (lines, line) text =
    if line = "" then (lines, text)
    else if String.length indent + String.length line + String.length text + 3 > width then
      ((line ^ ",") :: lines, text)
    else (lines, line ^ ", " ^ text)
  in
  let lines, last = List.fold_left add ([], "") texts in
  String.concat "\n" (List.rev_map (fun line -> indent ^ line) (last :: lines))

(* What fits in the width is on one line; the name of a member does not count. *)
let rec layout indent (json : Json.t) =
  let deeper = indent ^ "  " in
  let block opening closing inside = opening ^ "\n" ^ inside ^ "\n" ^ indent ^ closing in
  let lines = List.map (fun line -> deeper ^ line) in
  let line = short json in
  if String.length line <= width - String.length indent then line
  else
    match json with
    | `List items when List.for_all is_text items -> block "[" "]" (filled deeper (List.map short items))
    | `List items -> block "[" "]" (String.concat ",\n" (lines (List.map (layout deeper) items)))
    | `Assoc members -> block "{" "}" (String.concat ",\n" (lines (List.map (member (layout deeper)) members)))
    | _ -> line

let () =
  let all = List.map (fun (f : Known.file) -> f.schema) Known.all in
  let write (f : Json_schema.file) =
    let out = open_out_bin (f.name ^ ".schema.json") in
    output_string out (layout "" (Json_schema.document ~all f) ^ "\n");
    close_out out
  in
  List.iter write all
