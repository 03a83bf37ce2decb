open Scc_exact

type passing = For of Rat.t | Forever

let inside ~head s =
  let n = String.length s and h = String.length head in
  if n >= h + 2 && String.sub s 0 h = head && s.[h] = '(' && s.[n - 1] = ')' then
    Some (String.sub s (h + 1) (n - h - 2))
  else None

let passing s =
  match inside ~head:"time" s with
  | None -> None
  | Some "forever" -> Some Forever
  | Some d -> (
      match Rat.of_literal d with Ok d when Rat.sign d > 0 -> Some (For d) | Ok _ | Error _ -> None)

let of_passing = function For d -> "time(" ^ Rat.to_string d ^ ")" | Forever -> "time(forever)"

(* {1 Canonical form} *)

let opening = function '(' | '[' | '{' | '<' -> true | _ -> false
let closing = function ')' | ']' | '}' | '>' -> true | _ -> false

(* At the commas outside of brackets. *)
let arguments s =
  let rec cut i depth start acc =
    if i = String.length s then List.rev (String.sub s start (i - start) :: acc)
    else if s.[i] = ',' && depth = 0 then cut (i + 1) 0 (i + 1) (String.sub s start (i - start) :: acc)
    else
      let depth = if opening s.[i] then depth + 1 else if closing s.[i] then depth - 1 else depth in
      cut (i + 1) depth start acc
  in
  List.map String.trim (cut 0 0 0 [])

let sorted list = String.concat ", " (List.sort String.compare list)

let between s ~left ~right =
  let n = String.length s and l = String.length left and r = String.length right in
  if n >= l + r && String.sub s 0 l = left && String.sub s (n - r) r = right then
    Some (String.sub s l (n - l - r))
  else None

let is_at s i part =
  i + String.length part <= String.length s && String.equal part (String.sub s i (String.length part))

(* What stands behind the last bracket of a kind, with a space: a push or a chance, which ends in a round one. *)
let cut_behind ~bracket s =
  match String.rindex_opt s bracket with
  | Some i when i + 1 < String.length s && s.[i + 1] = ' ' ->
    (String.sub s 0 (i + 1), String.sub s (i + 1) (String.length s - i - 1))
  | _ -> (s, "")

(* The text and what is behind the word, in round brackets at its end. *)
let cut_number ~word s =
  let mark = Printf.sprintf " %s(" word in
  let rec last i = if i < 0 then None else if is_at s i mark then Some i else last (i - 1) in
  if not (String.length s > 0 && s.[String.length s - 1] = ')') then None
  else
    match last (String.length s - String.length mark) with
    | None -> None
    | Some i -> (
        let from = i + String.length mark in
        match Rat.of_literal (String.sub s from (String.length s - 1 - from)) with
        | Ok n -> Some (String.sub s 0 i, n)
        | Error _ -> None)

let chance = cut_number ~word:"chance"
let with_chance s c = Printf.sprintf "%s chance(%s)" s (Rat.to_string c)
let is_of head s = is_at s 0 (head ^ "(")

let canonical_bond s =
  let bond, push = cut_behind ~bracket:'>' s in
  match between bond ~left:"<" ~right:">" with
  | None -> s
  | Some inner -> (
      match arguments inner with
      | [ name; ends ] -> (
          match between ends ~left:"{" ~right:"}" with
          | Some ends -> Printf.sprintf "<%s, {%s}>%s" name (sorted (arguments ends)) push
          | None -> s)
      | _ -> s)

(* Of one transition, without a push and a chance. *)
let canonical_action s =
  let of_bond head =
    match Option.map arguments (inside ~head s) with
    | Some [ name; one; two ] -> Some (Printf.sprintf "%s(%s, %s)" head name (sorted [ one; two ]))
    | _ -> None
  in
  let of_bonds head =
    match between s ~left:(head ^ "({") ~right:"})" with
    | Some bonds -> Some (Printf.sprintf "%s({%s})" head (sorted (List.map canonical_bond (arguments bonds))))
    | None -> None
  in
  let bounce () =
    let told all = Printf.sprintf "bounce(%s)" (sorted (arguments all)) in
    Option.map told (inside ~head:"bounce" s)
  in
  let first list = List.find_map (fun f -> f ()) list in
  Option.value ~default:s
    (first
       ((bounce :: List.map (fun head () -> of_bonds head) [ "weak"; "strong" ])
        @ List.map
          (fun head () -> of_bond head)
          [ "bind"; "close"; "weak"; "release"; "keep"; "first"; "choose" ]))

let without_chance s =
  match cut_number ~word:"push" s with
  | Some (s, push) -> Printf.sprintf "%s push(%s)" (canonical_action s) (Rat.to_string push)
  | None -> (
      match between s ~left:"{" ~right:"}" with
      | Some all -> Printf.sprintf "{%s}" (sorted (List.map canonical_action (arguments all)))
      | None -> canonical_action s)

let canonical s =
  match chance s with
  | Some (s, c) -> with_chance (without_chance s) c
  | None -> without_chance s

(* {1 Patterns} *)

type pattern = string list  (* the texts between the stars *)

let pattern = String.split_on_char '*'
let stars s = List.length (pattern s) - 1

let rec find s i part =
  if i + String.length part > String.length s then None
  else if is_at s i part then Some i
  else find s (i + 1) part

(* The texts between stars are found from the left, each at its first place; the last one at the end. *)
let matches p s =
  let rec follow i acc = function
    | [] -> None
    | [ last ] ->
      let at = String.length s - String.length last in
      if at >= i && is_at s at last then Some (List.rev (String.sub s i (at - i) :: acc)) else None
    | part :: rest -> (
        match find s i part with
        | None -> None
        | Some at -> follow (at + String.length part) (String.sub s i (at - i) :: acc) rest)
  in
  match p with
  | [] -> None
  | [ whole ] -> if String.equal whole s then Some [] else None
  | head :: rest -> if is_at s 0 head then follow (String.length head) [] rest else None

(* {1 Renaming} *)

type rule = Whole of pattern * pattern | Name of string * string

let rule from into =
  if String.contains from '*' || String.contains from '(' then Whole (pattern from, pattern into)
  else Name (from, into)

let rec weave parts texts =
  match (parts, texts) with
  | [], _ -> []
  | [ last ], _ | last :: _, [] -> [ last ]
  | part :: parts, text :: texts -> part :: text :: weave parts texts

let is_name = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | c -> Char.code c >= 128

let starts_name s i = i = 0 || not (is_name s.[i - 1] || s.[i - 1] = '.')
let ends_name s i = i >= String.length s || not (is_name s.[i])

let rename_names names s =
  let b = Buffer.create (String.length s) in
  let rec at i =
    if i < String.length s then
      let fits (from, _) = is_at s i from && starts_name s i && ends_name s (i + String.length from) in
      match List.find_opt fits names with
      | Some (from, into) ->
        Buffer.add_string b into;
        at (i + String.length from)
      | None ->
        Buffer.add_char b s.[i];
        at (i + 1)
  in
  at 0;
  Buffer.contents b

let rename rules s =
  let whole = function
    | Whole (from, into) -> Option.map (fun texts -> String.concat "" (weave into texts)) (matches from s)
    | Name _ -> None
  in
  let renamed =
    match List.find_map whole rules with
    | Some s -> s
    | None ->
      let names = List.filter_map (function Name (f, i) -> Some (f, i) | Whole _ -> None) rules in
      let longer (a, _) (b, _) = Int.compare (String.length b) (String.length a) in
      rename_names (List.stable_sort longer names) s
  in
  canonical renamed
