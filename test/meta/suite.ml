open Yojson.Safe.Util

type case = { id : string; rules : string list; obtained : string }
type file = { path : string; count : int; cases : case list }

type t = {
  cases : int;
  files : file list;
  rules : (string * (int * string list)) list;
  diagnostics : (string * (string list * string list)) list;
}

let folder = "specs/conformance/"
let json path = Yojson.Safe.from_string (Tree.read (folder ^ path))
let strings value = List.map to_string (to_list value)

let case value =
  {
    id = to_string (member "id" value);
    rules = strings (member "rules" value);
    obtained = to_string (member "obtained" value);
  }

let file value =
  let path = to_string (member "file" value) in
  {
    path;
    count = to_int (member "cases" value);
    cases = List.map case (to_list (member "cases" (json path)));
  }

let read () =
  let manifest = json "manifest.json" in
  let rule (id, value) = (id, (to_int (member "cases" value), strings (member "files" value))) in
  let code (id, value) = (id, (strings (member "cases" value), strings (member "commands" value))) in
  {
    cases = to_int (member "cases" manifest);
    files = List.map file (to_list (member "suites" manifest));
    rules = List.map rule (to_assoc (member "rules" manifest));
    diagnostics = List.map code (to_assoc (member "diagnostics" manifest));
  }
