type entry = {
  id : string;
  line : int;
  chapter : string;
  code : (string * string) list;
  tests : (string * string) list;
  models : string list;
  malformed : string list;
}

let after prefix line =
  let n = String.length prefix in
  if String.length line >= n && String.equal (String.sub line 0 n) prefix then
    Some (String.trim (String.sub line n (String.length line - n)))
  else None

(* The first word and the rest. *)
let split text =
  match String.index_opt text ' ' with
  | None -> (text, "")
  | Some i -> (String.sub text 0 i, String.trim (String.sub text i (String.length text - i)))

let unquote text =
  let n = String.length text in
  if n > 2 && text.[0] = '"' && text.[n - 1] = '"' then Some (String.sub text 1 (n - 2)) else None

let read_line entry line =
  let malformed () = { entry with malformed = line :: entry.malformed } in
  match (after "- Code:" line, after "- Test:" line, after "- Model:" line) with
  | Some text, _, _ -> (
      match split text with
      | _, "" -> malformed ()
      | file, name -> { entry with code = (file, name) :: entry.code })
  | _, Some text, _ -> (
      let file, name = split text in
      match unquote name with
      | None -> malformed ()
      | Some name -> { entry with tests = (file, name) :: entry.tests })
  | _, _, Some "" -> malformed ()
  | _, _, Some path -> { entry with models = path :: entry.models }
  | None, None, None -> entry

let start chapter line text =
  { id = fst (split text); line; chapter; code = []; tests = []; models = []; malformed = [] }

(* The title of a chapter, "## 7. Laws", without its number. *)
let title text = match split text with _, "" -> text | _, name -> name

(* A heading of any kind ends the entry before it. *)
let entries text =
  let step (found, current, chapter) (number, line) =
    let found' = match current with Some entry -> entry :: found | None -> found in
    match (after "### " line, after "## " line, after "#" line) with
    | Some heading, _, _ -> (found', Some (start chapter number heading), chapter)
    | None, Some heading, _ -> (found', None, title heading)
    | None, None, Some _ -> (found', None, chapter)
    | None, None, None -> (found, Option.map (fun entry -> read_line entry line) current, chapter)
  in
  let lines = List.mapi (fun i line -> (i + 1, line)) (String.split_on_char '\n' text) in
  match List.fold_left step ([], None, "") lines with
  | found, Some entry, _ -> List.rev (entry :: found)
  | found, None, _ -> List.rev found
