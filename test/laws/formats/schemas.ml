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

(* As many items on each line as there is room for. Those that are [alone] have lines of their own. *)
let filled indent ~alone items =
  let add (lines, line) item =
    if line = "" then (lines, item)
    else
      let longer = line ^ ", " ^ item in
      if alone line || alone item || String.length indent + String.length longer >= width then
        ((line ^ ",") :: lines, item)
      else (lines, longer)
  in
  let lines, last = List.fold_left add ([], "") items in
  String.concat "\n" (List.rev_map (fun line -> indent ^ line) (last :: lines))

let begins text line = String.length line > String.length text && String.sub line 0 (String.length text) = text
let texts = [ "\"description\""; "\"title\""; "\"$schema\""; "\"$id\"" ]
let is_alone line = String.contains line '\n' || List.exists (fun text -> begins text line) texts

(* What fits in the width is on one line; the name of a member does not count. Properties and definitions have
   lines of their own, and so have texts; other members share a line. *)
let rec layout ?(names = false) indent (json : Json.t) =
  let deeper = indent ^ "  " in
  let block opening closing inside = opening ^ "\n" ^ inside ^ "\n" ^ indent ^ closing in
  let one (name, json) =
    let names = (not names) && (name = "properties" || name = "$defs") in
    member (layout ~names deeper) (name, json)
  in
  let line = short json in
  if String.length line <= width - String.length indent then line
  else
    match json with
    | `List items when List.for_all is_text items ->
      block "[" "]" (filled deeper ~alone:(fun _ -> false) (List.map short items))
    | `List items -> block "[" "]" (filled deeper ~alone:(fun _ -> true) (List.map (layout deeper) items))
    | `Assoc members ->
      block "{" "}" (filled deeper ~alone:(fun line -> names || is_alone line) (List.map one members))
    | _ -> line

let () =
  let all = List.map (fun (f : Known.file) -> f.schema) Known.all in
  let write (f : Json_schema.file) =
    let out = open_out_bin (f.name ^ ".schema.json") in
    output_string out (layout "" (Json_schema.document ~all f) ^ "\n");
    close_out out
  in
  List.iter write all
