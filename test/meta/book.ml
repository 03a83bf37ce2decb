type entry = {
  id : string;
  line : int;
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

let start line text =
  { id = fst (split text); line; code = []; tests = []; models = []; malformed = [] }

(* A heading of any kind ends the entry before it. *)
let entries text =
  let step (found, current) (number, line) =
    match (after "### " line, after "#" line, current) with
    | Some heading, _, Some entry -> (entry :: found, Some (start number heading))
    | Some heading, _, None -> (found, Some (start number heading))
    | None, Some _, Some entry -> (entry :: found, None)
    | None, Some _, None | None, None, None -> (found, None)
    | None, None, Some entry -> (found, Some (read_line entry line))
  in
  let lines = List.mapi (fun i line -> (i + 1, line)) (String.split_on_char '\n' text) in
  match List.fold_left step ([], None) lines with
  | found, Some entry -> List.rev (entry :: found)
  | found, None -> List.rev found
