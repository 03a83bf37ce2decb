open Scc_base
open Text

let is_letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')

(* A kind of atom and its place. *)
let is_atom = function
  | (w : word) :: ((_ :: _ :: _ :: _) as numbers) ->
    is_letter w.text.[0] && List.for_all Text.is_number (List.filteri (fun i _ -> i < 3) numbers)
  | _ -> false

let point ~path = function
  | [] -> Bug.fail __POS__ "a line without words"
  | (w : word) :: _ :: _ :: _ :: _ when is_letter w.text.[0] ->
    error ~path w "expected the three coordinates of a point, found %s: files of atoms are not read" (quote w.text)
  | _ :: _ :: _ :: _ as words -> coordinates ~path words
  | w :: _ -> error ~path w "expected the three coordinates of a point on this line"

let points ~path text position =
  let rec go acc count position =
    match next_line text position with
    | None -> Ok (acc, count)
    | Some (words, next) -> (
        match point ~path words with
        | Ok v -> go (v :: acc) (count + 1) next
        | Error _ as e -> e)
  in
  go [] 0 position

(* Files of chemistry have the number of atoms, then a line about them, which may be empty. *)
let is_of_atoms text position =
  let rec among lines position =
    lines > 0
    &&
    match next_line text position with
    | None -> false
    | Some (words, next) -> is_atom words || among (lines - 1) next
  in
  among 2 position

let read ~path text =
  match next_line text 0 with
  | None -> error_at ~path 0 "the file has no points"
  | Some ([ head ], next) when is_of_atoms text next ->
    error ~path head "files of atoms are not read: here each line is to have the three coordinates of a point"
  | Some ([ head ], next) ->
    let* promised = integer ~path ~what:"the coordinates of a point, or the number of points" head in
    let* list, count = points ~path text next in
    if promised <> count then error ~path head "the file promises %d points, but has %d" promised count
    else Ok (ifs list [])
  | Some _ ->
    let* list, _ = points ~path text 0 in
    Ok (ifs list [])
