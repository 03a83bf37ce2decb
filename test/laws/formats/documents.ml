(* documents.exe COUNT: for each format so many random documents, and changed ones, a line each as JSON:

   {"schema": its file, "change": the kind of the change or null, "read": whether the format reads it,
   "document"}

   A program of others tells which of them are of the schema (scripts/check_json.py). What a format writes of
   what it reads is read again, and written as before: that is decided here. *)

open Scc_json

let print schema change read document =
  let change = Json.option Json.text change in
  let members =
    [ ("schema", `String schema); ("change", change); ("read", `Bool read); ("document", document) ]
  in
  print_endline (Json.line (`Assoc members))

let again schema t back json =
  match Json_format.read t json with
  | Error _ -> ()
  | Ok x ->
    let once = Json_format.write t (back x) in
    let twice = Result.map (fun x -> Json_format.write t (back x)) (Json_format.read t once) in
    if twice <> Ok once then begin
      prerr_endline (schema ^ ": what is written is not read as it was: " ^ Json.line once);
      exit 1
    end;
    print schema None true once

let of_format r schema (Known.Format (t, back)) =
  let is_read json = Result.is_ok (Json_format.read t json) in
  let json = Samples.document r (Json_format.schema t) in
  print schema None (is_read json) json;
  Option.iter (fun back -> again schema t back json) back;
  for _ = 1 to 3 do
    let change, other = Samples.changed r json in
    print schema (Some change) (is_read other) other
  done

let () =
  let r = Random.State.make [| 1 |] in
  for _ = 1 to int_of_string Sys.argv.(1) do
    List.iter (fun (f : Known.file) -> Option.iter (of_format r f.schema.name) f.format) Known.all
  done
