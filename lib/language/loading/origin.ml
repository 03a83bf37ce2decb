open Scc_exact
open Scc_calculus

type t = {
  name : string option;
  digest : string;
  parameters : (string * Rat.t) list;
  settings : (string * string) list;
}

let digest ~text ~files =
  let b = Buffer.create (String.length text) in
  let add name bytes =
    Buffer.add_string b (Printf.sprintf "%d:%s%d:" (String.length name) name (String.length bytes));
    Buffer.add_string b bytes
  in
  add "" text;
  List.iter (fun (name, bytes) -> add name bytes) files;
  "md5:" ^ Digest.to_hex (Digest.string (Buffer.contents b))

let same_name (name, _) (name', _) = String.equal name name'
let changes o p = same_name o p && not (Rat.equal (snd o) (snd p))

let excludes (name, (low, high)) (name', value) =
  String.equal name name' && not (Ranges.mem { name; low; high } value)

let values ~recorded ~overrides ~narrowed =
  let given = List.find_opt (fun o -> List.exists (changes o) recorded) overrides in
  let outside = List.find_opt (fun n -> List.exists (excludes n) recorded) narrowed in
  match (given, outside) with
  | Some (name, _), _ | None, Some (name, _) -> Error name
  | None, None ->
    let is_new o = not (List.exists (same_name o) recorded) in
    Ok (recorded @ List.filter is_new overrides, List.filter is_new narrowed)
