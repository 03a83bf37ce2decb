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

(* {1 Other separators} *)

let count c (w : word) = String.fold_left (fun n other -> if other = c then n + 1 else n) 0 w.text

let rec for_all_lines test text position =
  match next_line text position with
  | None -> true
  | Some (words, next) -> test words && for_all_lines test text next

let blanked c text = String.map (fun other -> if other = c then ' ' else other) text

(* A comma may be one of a decimal. If a line has three numbers with two commas between them, it is none. *)
let separated ~path text =
  let has c words = List.exists (fun w -> count c w > 0) (List.filteri (fun i _ -> i < 3) words) in
  let some c = not (for_all_lines (fun words -> not (has c words)) text 0) in
  let three words =
    let commas = List.fold_left (fun n w -> n + count ',' w) 0 words in
    let line = String.concat " " (List.map (fun (w : word) -> w.text) words) in
    let values = List.filter (fun v -> v <> "") (String.split_on_char ' ' (blanked ',' line)) in
    let between = List.for_all (fun v -> String.trim v <> "") (String.split_on_char ',' line) in
    (commas = 0 && List.compare_length_with words 1 = 0) || (commas = 2 && List.length values = 3 && between)
  in
  match (some ',', some ';') with
  | false, false -> Ok text
  | false, true -> Ok (blanked ';' text)
  | true, false when for_all_lines three text 0 -> Ok (blanked ',' text)
  | true, _ ->
    let rec first position =
      match next_line text position with
      | None -> Span.of_file path
      | Some (words, next) -> (
          match List.find_opt (fun w -> count ',' w > 0) words with
          | Some w -> Span.make ~file:path ~start:w.start ~stop:(w.start + String.length w.text)
          | None -> first next)
    in
    Error
      (Diag.error Code.bad_mesh (first 0) "commas may be parts of decimals or stand between numbers here"
         ~hint:"write blanks between numbers, and points in decimals")

let read_lines ~path text =
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

let read ~path text =
  let* text = separated ~path text in
  read_lines ~path text
