(* schemas.exe: writes each schema that follows from formats to its file in this folder. *)

open Scc_json

let () =
  let all = List.map (fun (f : Known.file) -> f.schema) Known.all in
  let write (f : Json_schema.file) =
    let out = open_out_bin (f.name ^ ".schema.json") in
    Json.pretty_pieces ~width:100 (output_string out) (Json_schema.document ~all f);
    close_out out
  in
  List.iter write all
