open Scc_data
open Scc_json
open Json_format

let named name ?text t = named ~file:"view" name (match text with None -> t | Some text -> about text t)
let number = named "number" ~text:"Of a row of a table, from 0." natural

type t = { numbers : (string, int) Hashtbl.t; rows : string Growable.t }

let create () = { numbers = Hashtbl.create 64; rows = Growable.create () }
let length t = Growable.length t.rows

let add t format x =
  let row = Json.line (Json_format.write format x) in
  match Hashtbl.find_opt t.numbers row with
  | Some n -> n
  | None ->
    let n = length t in
    Hashtbl.add t.numbers row n;
    Growable.push t.rows row;
    n

let since t n = List.init (Int.max 0 (length t - n)) (fun i -> Growable.get t.rows (n + i))

let write t put =
  put "[";
  for i = 0 to length t - 1 do
    put (if i = 0 then "\n" else ",\n");
    put (Growable.get t.rows i)
  done;
  put "]"
