open Scc_base
open Scc_exact

type word = { text : string; start : int }

let is_blank c = c = ' ' || c = '\t' || c = '\x0b' || c = '\x0c'
let is_end c = c = '\n' || c = '\r'

(* A backslash that only blanks part from the line end. *)
let joins text i =
  let n = String.length text in
  let rec go j = j >= n || is_end text.[j] || (is_blank text.[j] && go (j + 1)) in
  text.[i] = '\\' && go (i + 1)

let next_line ?(continued = false) text position =
  let n = String.length text in
  let rec skip_to_end i = if i < n && not (is_end text.[i]) then skip_to_end (i + 1) else i in
  let after_end i = if i + 1 < n && text.[i] = '\r' && text.[i + 1] = '\n' then i + 2 else min n (i + 1) in
  let rec word_end i =
    if i < n && not (is_blank text.[i] || is_end text.[i] || text.[i] = '#' || (continued && joins text i))
    then word_end (i + 1)
    else i
  in
  let rec scan words i =
    if i >= n then finish words n
    else
      let c = text.[i] in
      if is_blank c then scan words (i + 1)
      else if is_end c then finish words (after_end i)
      else if c = '#' then scan words (skip_to_end i)
      else if continued && joins text i then scan words (after_end (skip_to_end i))
      else
        let stop = word_end i in
        scan ({ text = String.sub text i (stop - i); start = i } :: words) stop
  and finish words next =
    match words with
    | _ :: _ -> Some (List.rev words, next)
    | [] -> if next >= n then None else scan [] next
  in
  if position >= n then None else scan [] position

let fail ~path start stop fmt =
  Printf.ksprintf
    (fun message -> Error (Diag.error Code.bad_mesh (Span.make ~file:path ~start ~stop) "%s" message))
    fmt

let error ~path word fmt = fail ~path word.start (word.start + String.length word.text) fmt
let error_at ~path offset fmt = fail ~path offset offset fmt

let quote s =
  (* Not within a character. *)
  let rec stop i = if i > 0 && Char.code s.[i] land 0xc0 = 0x80 then stop (i - 1) else i in
  let cut = if String.length s > 40 then String.sub s 0 (stop 40) ^ "..." else s in
  "`" ^ Visible.line cut ^ "`"

let max_digits = 1000
let is_digit c = c >= '0' && c <= '9'

(* [.5] and [5.] (with a sign or an exponent) as [0.5] and [5.0]. *)
let with_zeros s =
  let n = String.length s in
  match String.index_opt s '.' with
  | None -> s
  | Some i ->
    let before = i > 0 && is_digit s.[i - 1] and after = i + 1 < n && is_digit s.[i + 1] in
    if before = after then s
    else if after then String.sub s 0 i ^ "0" ^ String.sub s i (n - i)
    else String.sub s 0 (i + 1) ^ "0" ^ String.sub s (i + 1) (n - i - 1)

(* Digits and exponent together, so that a long number is refused before it is built. *)
let written_digits s =
  match String.index_opt (String.lowercase_ascii s) 'e' with
  | None -> String.length s
  | Some i -> (
      match int_of_string_opt (String.sub s (i + 1) (String.length s - i - 1)) with
      | Some e -> i + abs e
      | None -> String.length s)

let coordinate ~path w =
  let too_long () = error ~path w "a coordinate has more than %d digits" max_digits in
  let not_number () = error ~path w "expected a number, found %s" (quote w.text) in
  match String.lowercase_ascii w.text with
  | "nan" | "-nan" | "+nan" | "inf" | "-inf" | "+inf" | "infinity" | "-infinity" ->
    error ~path w "a coordinate must be a finite number, not %s" (quote w.text)
  | s when written_digits s > max_digits -> too_long ()
  | s -> (
      match Rat.of_literal (with_zeros s) with
      | Ok x -> Ok x
      | Error Rat.Too_large -> too_long ()
      | Error Rat.Zero_denominator -> error ~path w "a fraction with the denominator zero"
      | Error Rat.Malformed -> not_number ())

let is_number w =
  match String.lowercase_ascii w.text with
  | "nan" | "-nan" | "+nan" | "inf" | "-inf" | "+inf" | "infinity" | "-infinity" -> true
  | s -> ( match Rat.of_literal (with_zeros s) with Ok _ | Error Rat.Too_large -> true | Error _ -> false)

let coordinates ~path words =
  match words with
  | x :: y :: z :: _ ->
    let* x = coordinate ~path x in
    let* y = coordinate ~path y in
    let* z = coordinate ~path z in
    Ok (Vec.make x y z)
  | _ -> Bug.fail __POS__ "fewer than three coordinates"

let integer ~path ~what w =
  let n = String.length w.text in
  let sign = n > 0 && (w.text.[0] = '-' || w.text.[0] = '+') in
  let digits = if sign then String.sub w.text 1 (n - 1) else w.text in
  let whole = String.length digits > 0 && String.for_all is_digit digits in
  if not whole then error ~path w "expected %s, found %s" what (quote w.text)
  else if String.length digits > 9 then error ~path w "%s is too large: %s" what (quote w.text)
  else
    let value = String.fold_left (fun v c -> (10 * v) + Char.code c - Char.code '0') 0 digits in
    Ok (if w.text.[0] = '-' then -value else value)

let vertex ~path ~count w =
  let* i = integer ~path ~what:"the index of a vertex" w in
  if i >= 0 && i < count then Ok i
  else if count = 0 then error ~path w "a face names vertex %d, but there are no vertices" i
  else error ~path w "a face names vertex %d, but the vertices are 0 to %d" i (count - 1)

let labelled vertices faces =
  let in_order l = Array.of_list (List.rev l) in
  let vertices = Array.mapi (fun i x -> ("v" ^ string_of_int i, x)) (in_order vertices) in
  let faces = in_order faces in
  let names = Face_names.names ~vertices:(Array.map fst vertices) (Array.map fst faces) in
  {
    Scc_geometry.Polyhedron.ifs_vertices = vertices;
    ifs_faces = Array.map2 (fun name (_, f) -> (name, f)) names faces;
  }

let ifs vertices faces = labelled vertices (List.map (fun f -> (None, f)) faces)
