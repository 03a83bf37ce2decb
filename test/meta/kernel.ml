let folder = "lib/kernel/semantics"

let modules () =
  Tree.files folder
  |> List.filter (fun file -> Filename.check_suffix file ".ml")
  |> List.map (fun file -> Filename.chop_suffix (Filename.basename file) ".ml")

(* {1 Purity} *)

(* Comments and texts become spaces; lines stay. *)
let code_of text =
  let b = Bytes.of_string text and n = String.length text in
  let blank i = if Bytes.get b i <> '\n' then Bytes.set b i ' ' in
  let at i part = Tree.starts_with part (String.sub text i (Int.min (String.length part) (n - i))) in
  let rec code i =
    if i < n then
      if at i "(*" then comment 0 i
      else if at i "'\"'" then code (i + 3)
      else if text.[i] = '"' then (blank i; quoted (i + 1))
      else code (i + 1)
  and quoted i =
    if i < n then begin
      blank i;
      if text.[i] = '\\' && i + 1 < n then (blank (i + 1); quoted (i + 2))
      else if text.[i] = '"' then code (i + 1)
      else quoted (i + 1)
    end
  and comment depth i =
    if i < n then begin
      blank i;
      if at i "(*" then (blank (i + 1); comment (depth + 1) (i + 2))
      else if at i "*)" then (blank (i + 1); if depth = 1 then code (i + 2) else comment (depth - 1) (i + 2))
      else comment depth (i + 1)
    end
  in
  code 0;
  Bytes.to_string b

let words = [ "mutable"; "ref"; "Hashtbl"; "Stack"; "Queue"; "Buffer"; "Bytes"; "Float"; "float";
              "float_of_int"; "Float_box";
              "Random"; "Sys"; "Unix"; "Scc_graph_search" ]

let symbols = [ ":="; "<-"; "+."; "-."; "*."; "/." ]

let is_word_character = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | _ -> false

let names line word =
  Tree.places line word
  |> List.exists (fun i ->
      let after = i + String.length word in
      (i = 0 || not (is_word_character line.[i - 1]))
      && (after = String.length line || not (is_word_character line.[after])))

let is_digit = function '0' .. '9' -> true | _ -> false

(* A number with a point: digits, by themselves, before a point. *)
let has_float line =
  Tree.places line "."
  |> List.exists (fun i ->
      let rec before j = if j >= 0 && is_digit line.[j] then before (j - 1) else j in
      let j = before (i - 1) in
      j < i - 1 && (j < 0 || not (is_word_character line.[j])))

let impure () =
  let of_file file =
    String.split_on_char '\n' (code_of (Tree.read file))
    |> List.mapi (fun i line ->
        List.filter (names line) words @ List.filter (Tree.contains line) symbols
        @ (if has_float line then [ "a number with a point" ] else [])
        |> List.map (Printf.sprintf "%s:%d: %s" file (i + 1)))
    |> List.concat
  in
  let is_source file = Filename.check_suffix file ".ml" || Filename.check_suffix file ".mli" in
  List.concat_map of_file (List.filter is_source (Tree.files folder))

(* {1 The reading list} *)

let listed () =
  let text = Tree.read "DEVEL.md" in
  match (Tree.places text "## The kernel, in reading order", Tree.places text "\n## ") with
  | [ first ], headings ->
    let last = Option.value (List.find_opt (fun i -> i > first) headings) ~default:(String.length text) in
    String.split_on_char '\n' (String.sub text first (last - first))
    |> List.filter (Tree.starts_with "| `")
    |> List.concat_map (fun row ->
        let cell = List.nth (String.split_on_char '|' row) 1 in
        List.filteri (fun i _ -> i mod 2 = 1) (String.split_on_char '`' cell))
  | _ -> []

let unlisted () =
  let there = modules () and listed = listed () in
  let missing from = List.filter (fun name -> not (List.mem name from)) in
  missing listed there @ List.map (fun name -> name ^ ", which is not there") (missing there listed)
