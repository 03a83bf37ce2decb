open Scc_exact

type axis = { name : string; values : Rat.t array }
type t = axis list

let most = 1_000_000

let number text =
  match Rat.of_literal (String.trim text) with
  | Ok r -> Ok r
  | Error Too_large ->
    Error (Printf.sprintf "a number is too large: at most %d digits each above and below the line" Rat.max_digits)
  | Error (Malformed | Zero_denominator) -> Error (Printf.sprintf "`%s' is no number" text)

let steps text low high step =
  if Rat.sign step <= 0 then Error (Printf.sprintf "`%s' has no positive step" text)
  else if Rat.compare low high > 0 then Error (Printf.sprintf "`%s' ends before it begins" text)
  else
    let count = Z.succ (Rat.floor (Rat.div (Rat.sub high low) step)) in
    if Z.gt count (Z.of_int most) then
      Error (Printf.sprintf "`%s' has %s values: at most %d" text (Z.to_string count) most)
    else Ok (Array.init (Z.to_int count) (fun i -> Rat.add low (Rat.mul (Rat.of_int i) step)))

(* Where two dots are, or none. *)
let cut_dots text =
  let n = String.length text in
  let rec from i =
    if i + 1 >= n then None
    else if text.[i] = '.' && text.[i + 1] = '.' then
      Some (String.sub text 0 i, String.sub text (i + 2) (n - i - 2))
    else from (i + 1)
  in
  from 0

(* A range of all numbers between has no values to try one after the other. *)
let between text =
  let n = String.length text in
  let is_end c = match c with '[' | '(' | ']' | ')' -> true | _ -> false in
  if n > 0 && is_end text.[0] then
    let inner = String.sub text 1 (n - 1) in
    let inner = if n > 1 && is_end text.[n - 1] then String.sub text 1 (n - 2) else inner in
    match List.map String.trim (String.split_on_char ',' inner) with
    | [ low; high ] ->
      Error
        (Printf.sprintf
           "`%s' is a range of all numbers between, for scc check; the values of a sweep are %s..%s, or %s:%s:1/8 \
            with steps of 1/8"
           text low high low high)
    | _ -> Error (Printf.sprintf "`%s' is neither a value, nor a list 1,2,5, nor 1..10, nor 0:2:1/8" text)
  else Ok ()

let values text =
  let* () = between text in
  match (cut_dots text, String.split_on_char ':' text) with
  | Some (low, high), _ ->
    let* low = number low in
    let* high = number high in
    steps text low high Rat.one
  | None, [ low; high; step ] ->
    let* low = number low in
    let* high = number high in
    let* step = number step in
    steps text low high step
  | None, [ list ] ->
    let add found text =
      let* found = found in
      let* r = number text in
      if List.exists (Rat.equal r) found then Error (Printf.sprintf "`%s' is there twice" text)
      else Ok (r :: found)
    in
    let* found = List.fold_left add (Ok []) (String.split_on_char ',' list) in
    Ok (Array.of_list (List.rev found))
  | None, _ -> Error (Printf.sprintf "`%s' is neither a value, nor a list 1,2,5, nor 1..10, nor 0:2:1/8" text)

let size t = List.fold_left (fun n a -> Z.mul n (Z.of_int (Array.length a.values))) Z.one t

let place t k =
  let add a (places, k) =
    let n = Array.length a.values in
    ((k mod n) :: places, k / n)
  in
  fst (List.fold_right add t ([], k))

let point t k = List.map2 (fun a i -> (a.name, a.values.(i))) t (place t k)
