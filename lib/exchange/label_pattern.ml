type t = { source : string; pieces : string list }
(** What stands between the stars, in order. *)

let of_string source =
  if String.equal source "" then Error "an empty pattern matches no label"
  else
    let is_kind = not (String.exists (function '(' | '*' -> true | _ -> false) source) in
    let pattern = if is_kind then source ^ "(*" else source in
    Ok { source; pieces = String.split_on_char '*' pattern }

let to_string p = p.source

let found_at text piece i =
  i + String.length piece <= String.length text
  && String.equal (String.sub text i (String.length piece)) piece

let rec find text piece i =
  if i + String.length piece > String.length text then None
  else if found_at text piece i then Some (i + String.length piece)
  else find text piece (i + 1)

(* The first piece begins the text and the last one ends it; between them, the leftmost places will do. *)
let matches p text =
  let rec rest i = function
    | [] -> i = String.length text
    | [ last ] ->
      let at = String.length text - String.length last in
      at >= i && found_at text last at
    | piece :: later -> (
        match find text piece i with None -> false | Some i -> rest i later)
  in
  match p.pieces with
  | [] -> false
  | [ whole ] -> String.equal whole text
  | first :: later -> found_at text first 0 && rest (String.length first) later
