let lines text = String.split_on_char '\n' text

(* Lines outside of blocks of code, numbered from 1. *)
let prose text =
  let add (kept, number, fenced) line =
    let fence = Tree.starts_with "```" (String.trim line) in
    let code = fenced || fence || Tree.starts_with "    " line in
    ((if code then kept else (number, line) :: kept), number + 1, if fence then not fenced else fenced)
  in
  let kept, _, _ = List.fold_left add ([], 1, false) (lines text) in
  List.rev kept

(* {1 Anchors} *)

(* As the usual hosts make one of a heading: letters, digits, hyphens and underscores stay, in lower case, spaces
   become hyphens, all else goes. Bytes beyond ASCII are parts of letters. *)
let slug heading =
  let b = Buffer.create 32 in
  String.iter
    (function
      | ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '-' | '_' | '\128' .. '\255') as c ->
        Buffer.add_char b (Char.lowercase_ascii c)
      | ' ' -> Buffer.add_char b '-'
      | _ -> ())
    heading;
  Buffer.contents b

let heading line =
  let n = String.length line in
  let rec level i = if i < n && line.[i] = '#' then level (i + 1) else i in
  let k = level 0 in
  if k > 0 && k < n && line.[k] = ' ' then Some (String.trim (String.sub line k (n - k))) else None

(* A heading that comes again is told apart by a number. *)
let anchors text =
  let add found slug =
    let before = List.length (List.filter (String.equal slug) (List.map fst found)) in
    (slug, if before = 0 then slug else Printf.sprintf "%s-%d" slug before) :: found
  in
  prose text
  |> List.filter_map (fun (_, line) -> Option.map slug (heading line))
  |> List.fold_left add [] |> List.map snd

(* {1 Links} *)

(* What stands between two marks, each time, without what is within backquotes. *)
let rec between first last line from =
  let n = String.length first in
  let rec find i =
    if i + n > String.length line then None else if String.sub line i n = first then Some i else find (i + 1)
  in
  match find from with
  | None -> []
  | Some i -> (
      match String.index_from_opt line (i + n) last with
      | None -> []
      | Some j -> String.sub line (i + n) (j - i - n) :: between first last line (j + 1))

let without_code line =
  List.filteri (fun i _ -> i mod 2 = 0) (String.split_on_char '`' line) |> String.concat ""

let targets line = between "](" ')' (without_code line) 0

(* Without steps back and forth: "specs/../README.md" is "README.md". *)
let simplified path =
  let step kept part =
    match (part, kept) with
    | ("." | ""), _ -> kept
    | "..", up :: rest when up <> ".." -> rest
    | _, _ -> part :: kept
  in
  String.concat "/" (List.rev (List.fold_left step [] (String.split_on_char '/' path)))

let is_of_the_web target = List.exists (fun p -> Tree.starts_with p target) [ "http:"; "https:"; "mailto:" ]

let fault_of document target =
  if is_of_the_web target then None
  else
    let path, anchor =
      match String.index_opt target '#' with
      | None -> (target, None)
      | Some i -> (String.sub target 0 i, Some (String.sub target (i + 1) (String.length target - i - 1)))
    in
    let file = if path = "" then document else simplified (Filename.concat (Filename.dirname document) path) in
    match anchor with
    | _ when not (Tree.exists file) -> Some (Printf.sprintf "no file %s" file)
    | Some a when not (List.mem a (anchors (Tree.read file))) ->
      Some (Printf.sprintf "no heading #%s in %s" a file)
    | Some _ | None -> None

(* {1 Paths} *)

let folders = [ "bin/"; "clients/"; "editors/"; "lib/"; "scripts/"; "specs/"; "test/" ]

(* A path between backquotes, up to a space: what is behind it are arguments. *)
let paths line =
  List.filteri (fun i _ -> i mod 2 = 1) (String.split_on_char '`' line)
  |> List.filter_map (fun code -> List.nth_opt (String.split_on_char ' ' code) 0)
  |> List.filter (fun word ->
      List.exists (fun folder -> Tree.starts_with folder word) folders
      && String.for_all
        (function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '-' | '.' | '/' -> true | _ -> false)
        word)

let path_fault path =
  let path = simplified path in
  if Tree.exists path then None else Some (Printf.sprintf "no file or folder %s" path)

let faults document =
  let tell number why = Printf.sprintf "%s:%d: %s" document number why in
  prose (Tree.read document)
  |> List.concat_map (fun (number, line) ->
      List.map (tell number)
        (List.filter_map (fault_of document) (targets line) @ List.filter_map path_fault (paths line)))
