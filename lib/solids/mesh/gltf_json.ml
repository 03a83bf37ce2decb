open Scc_base
open Text

type t = { path : string; at : string; value : Yojson.Raw.t }

let fail v fmt =
  let tell what = error_at ~path:v.path 0 "%s%s" (if String.equal v.at "" then "" else v.at ^ ": ") what in
  Printf.ksprintf tell fmt

let place v = v.at
let max_depth = 100

(* The deepest nesting of brackets outside of strings. *)
let depth text =
  let n = String.length text in
  let rec go i inside d deepest =
    if i >= n then deepest
    else
      match text.[i] with
      | '\\' when inside -> go (i + 2) inside d deepest
      | '"' -> go (i + 1) (not inside) d deepest
      | ('[' | '{') when not inside -> go (i + 1) inside (d + 1) (max deepest (d + 1))
      | (']' | '}') when not inside -> go (i + 1) inside (d - 1) deepest
      | _ -> go (i + 1) inside d deepest
  in
  go 0 false 0 0

(* A name that an object has twice: readers differ in which value they take. *)
let rec twice (value : Yojson.Raw.t) =
  match value with
  | `Assoc members -> (
      let names = List.sort String.compare (List.map fst members) in
      let rec pair = function
        | a :: (b :: _ as rest) -> if String.equal a b then Some a else pair rest
        | [ _ ] | [] -> None
      in
      match pair names with
      | Some name -> Some name
      | None -> List.find_map (fun (_, v) -> twice v) members)
  | `List values -> List.find_map twice values
  | _ -> None

(* What the parser reads beyond JSON: comments, names without quotes, numbers that are none. *)
let foreign text =
  let n = String.length text in
  let letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c = '_' in
  let digit c = c >= '0' && c <= '9' in
  let rec word_end i = if i < n && letter text.[i] then word_end (i + 1) else i in
  let rec go i inside =
    if i >= n then None
    else
      match text.[i] with
      | '\\' when inside -> go (i + 2) inside
      | '"' -> go (i + 1) (not inside)
      | _ when inside -> go (i + 1) inside
      | c when digit c || String.contains " \t\n\r{}[]:,+-." c -> go (i + 1) inside
      | c when letter c ->
        let stop = word_end i in
        let word = String.sub text i (stop - i) in
        let power = (word = "e" || word = "E") && i > 0 && (digit text.[i - 1] || text.[i - 1] = '.') in
        if power || List.mem word [ "true"; "false"; "null" ] then go stop inside else Some i
      | _ -> Some i
  in
  go 0 false

let parse ~path text =
  if depth text > max_depth then error_at ~path 0 "the JSON is nested more than %d deep" max_depth
  else
    match foreign text with
    | Some i ->
      let lines = List.length (String.split_on_char '\n' (String.sub text 0 i)) in
      let stop = Option.value (String.index_from_opt text i '\n') ~default:(String.length text) in
      let what = String.sub text i (min 10 (stop - i)) in
      error_at ~path 0 "this is not JSON: in line %d of it, %s is outside of strings" lines (quote what)
    | None ->
      match Yojson.Raw.from_string text with
      | `Assoc _ as value -> (
          match twice value with
          | None -> Ok { path; at = ""; value }
          | Some name -> error_at ~path 0 "an object has the member %s twice" (quote name))
      | _ -> error_at ~path 0 "expected a JSON object"
      | exception Yojson.Json_error why ->
        let line = String.map (fun c -> if c < ' ' || c > '~' then ' ' else c) why in
        error_at ~path 0 "this is not JSON: %s" (if String.length line > 100 then String.sub line 0 100 else line)

let shown name = if String.length name > 40 then String.sub name 0 40 else name

let member name v =
  match v.value with
  | `Assoc members -> (
      match List.assoc_opt name members with
      | None | Some `Null -> None
      | Some value ->
        Some { v with at = (if String.equal v.at "" then name else v.at ^ "." ^ shown name); value })
  | _ -> None

let is_object v =
  match v.value with
  | `Assoc _ -> Ok ()
  | _ -> fail v "expected an object"

let needed name v =
  match member name v with
  | Some found -> Ok found
  | None -> fail v "`%s` is missing" name

let elements v =
  match v.value with
  | `List values ->
    let one i value = { v with at = Printf.sprintf "%s[%d]" v.at i; value } in
    Ok (Array.mapi one (Array.of_list values))
  | _ -> fail v "expected an array"

let items name v =
  match member name v with
  | None -> Ok [||]
  | Some list -> elements list

let number v =
  match v.value with
  | `Intlit text | `Floatlit text ->
    Result.map_error
      (fun (d : Diag.t) -> { d with message = v.at ^ ": " ^ d.message })
      (coordinate ~path:v.path { text; start = 0 })
  | _ -> fail v "expected a number"

let numbers n v =
  let* list = elements v in
  if Array.length list <> n then fail v "expected %d numbers, not %d" n (Array.length list)
  else Result.map Array.of_list (Result.all number (Array.to_list list))

let truth name v =
  match member name v with
  | None -> Ok false
  | Some { value = `Bool b; _ } -> Ok b
  | Some other -> fail other "expected true or false"

let keys v = match v.value with `Assoc members -> List.map fst members | _ -> []

let index v =
  match v.value with
  | `Intlit text -> (
      match int_of_string_opt text with
      | Some i when i >= 0 && i < 1 lsl 31 -> Ok i
      | Some _ | None -> fail v "expected an integer from 0 to 2147483647, found %s" (quote text))
  | _ -> fail v "expected an integer"

let index_or default name v =
  match member name v with
  | None -> Ok default
  | Some found -> index found

let nth list ~what v =
  let* i = index v in
  if i < Array.length list then Ok (list.(i), i)
  else fail v "there is no %s %d: there are %d" what i (Array.length list)

let text v =
  match v.value with
  | `Stringlit literal -> (
      match Yojson.Safe.from_string literal with
      | `String s -> Ok s
      | _ -> fail v "expected a string"
      | exception Yojson.Json_error _ -> fail v "expected a string")
  | _ -> fail v "expected a string"

let of_index v i = { v with value = `Intlit (string_of_int i) }
