open Scc_json
open Json_format

type ('o, 'row) t = {
  head : ('o, unit) members;
  rows : string;
  about : string;
  row : ('row, unit) Json_format.t;
  get : 'o -> int * (int -> 'row);
}

let format d =
  let all o =
    let count, get = d.get o in
    List.init count get
  in
  fields [ d.head; field d.rows (list ~least:1 d.row) all ~about:d.about ]

let write d o put =
  let member (name, json) = put (Json.line (`String name) ^ ": " ^ Json.line json ^ ",\n") in
  put "{\n";
  List.iter member (written_members d.head o);
  put (Json.line (`String d.rows) ^ ": [\n");
  let count, get = d.get o in
  for i = 0 to count - 1 do
    put (Json.line (Json_format.write d.row (get i)) ^ if i = count - 1 then "\n" else ",\n")
  done;
  put "]\n}\n"
