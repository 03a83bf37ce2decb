type verdict = Holds | Bounded | Violated | Measured of string | Undecided

let verdict_to_string = function
  | Holds -> "holds"
  | Bounded -> "bounded"
  | Violated -> "violated"
  | Measured text -> text
  | Undecided -> "undecided"

let verdict_of_string = function
  | "holds" -> Holds
  | "bounded" -> Bounded
  | "violated" -> Violated
  | "undecided" -> Undecided
  | "" -> failwith "no verdict"
  | other -> (
      match (other.[0], String.split_on_char ' ' other) with
      | ('0' .. '9' | '-'), _ | _, ("infinite" | "least" | "greatest") :: _ -> Measured other
      | _ -> failwith ("no verdict: " ^ other))

(* What follows a mark in a line, if it is there. *)
let after mark line =
  let n = String.length mark in
  let rec find i =
    if i + n > String.length line then None
    else if String.equal (String.sub line i n) mark then
      Some (String.trim (String.sub line (i + n) (String.length line - i - n)))
    else find (i + 1)
  in
  find 0

let starts_with prefix line =
  String.length line >= String.length prefix
  && String.equal (String.sub line 0 (String.length prefix)) prefix

let check_name line =
  let before_colon = List.hd (String.split_on_char ':' line) in
  match String.split_on_char ' ' before_colon |> List.filter (fun w -> w <> "") with
  | "check" :: name :: _ -> name
  | _ -> failwith ("no check: " ^ line)

let checks text =
  String.split_on_char '\n' text
  |> List.filter (starts_with "check ")
  |> List.map (fun line ->
      match after "// expect: " line with
      | Some verdict -> (check_name line, verdict_of_string verdict)
      | None -> failwith ("no expectation: " ^ line))

let refused text = List.find_map (after "// refused: ") (String.split_on_char '\n' text)
