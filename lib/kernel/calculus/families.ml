type t = { names : string array; of_leaf : int array }

let most_names = 10

let bare name =
  let until_index = match String.index_opt name '[' with None -> name | Some i -> String.sub name 0 i in
  let digit c = c >= '0' && c <= '9' in
  let rec last i = if i > 0 && digit until_index.[i - 1] then last (i - 1) else i in
  match String.sub until_index 0 (last (String.length until_index)) with "" -> name | bare -> bare

(* Each once, in order. *)
let distinct names =
  let known = Hashtbl.create 16 in
  let is_new (name : string) =
    (not (Hashtbl.mem known name))
    && begin
      Hashtbl.add known name (Hashtbl.length known);
      true
    end
  in
  (List.filter is_new names, known)

let of_model (m : Model.t) =
  let fixed, moving = List.partition (fun (l : Model.leaf) -> l.fixed) (Array.to_list m.leaves) in
  let by_name (l : Model.leaf) = bare l.name and by_template (l : Model.leaf) = l.template in
  let names, _ = distinct (List.map by_name moving) in
  let family = if List.length names <= most_names then by_name else by_template in
  let names, numbers = distinct (List.map family (moving @ fixed)) in
  { names = Array.of_list names; of_leaf = Array.map (fun l -> Hashtbl.find numbers (family l)) m.leaves }
