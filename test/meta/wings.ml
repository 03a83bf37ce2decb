let lines text = String.split_on_char '\n' text
let readme wing = Printf.sprintf "lib/%s/README.md" wing

(* The first cell of each row of a table whose cells begin with a backquoted word. *)
let rows text =
  let row line =
    match String.split_on_char '`' line with
    | bar :: name :: _ :: _ when String.trim bar = "|" -> Some name
    | _ -> None
  in
  List.filter_map row (lines text)

let all () =
  let of_row name =
    match String.split_on_char '/' name with
    | [ "lib"; wing ] when Tree.exists (readme wing) -> Some wing
    | _ -> None
  in
  List.filter_map of_row (rows (Tree.read "DEVEL.md"))

let allowed wing =
  let text = Tree.read (readme wing) in
  List.filter (fun other -> Tree.contains text (Printf.sprintf "[%s](../%s/README.md)" other other)) (all ())

(* {1 Libraries} *)

(* The words of the field of a dune file that begins with this word, up to its closing parenthesis. *)
let field name text =
  match Tree.places text ("(" ^ name ^ " ") with
  | [] -> []
  | i :: _ ->
    let first = i + String.length name + 2 in
    let last = String.index_from text first ')' in
    String.sub text first (last - first) |> lines
    |> List.concat_map (String.split_on_char ' ')
    |> List.filter (fun word -> word <> "")

type room = { wing : string; folder : string; name : string; uses : string list; sources : string list }

let room wing path =
  let text = Tree.read path in
  match (String.split_on_char '/' path, field "name" text) with
  | [ _; _; folder; _ ], [ name ] ->
    let is_source file = Filename.check_suffix file ".ml" || Filename.check_suffix file ".mli"
                         || Filename.check_suffix file ".mly" || Filename.check_suffix file ".mll" in
    let sources = List.filter is_source (Tree.files (Filename.dirname path)) in
    Some { wing; folder; name; uses = List.filter (Tree.starts_with "scc_") (field "libraries" text); sources }
  | _ -> None

let rooms_of wing =
  Tree.files ("lib/" ^ wing)
  |> List.filter (fun file -> Filename.basename file = "dune")
  |> List.filter_map (room wing)

let every_room () = List.concat_map rooms_of (all ())

(* {1 Faults} *)

let upward wing =
  let every = every_room () and allowed = wing :: allowed wing in
  let of_edge room use =
    match List.find_opt (fun r -> r.name = use) every with
    | Some other when List.mem other.wing allowed -> None
    | Some other -> Some (Printf.sprintf "%s/%s uses %s/%s" wing room.folder other.wing other.folder)
    | None -> Some (Printf.sprintf "%s/%s uses %s, which is in no wing" wing room.folder use)
  in
  List.concat_map (fun room -> List.filter_map (of_edge room) room.uses) (rooms_of wing)

let unordered () =
  let rec from before = function
    | [] -> []
    | wing :: rest ->
      List.filter_map
        (fun other -> if List.mem other before then None else Some (Printf.sprintf "%s may use %s" wing other))
        (allowed wing)
      @ from (wing :: before) rest
  in
  from [] (all ())

(* lib/dune opens a module of it everywhere. *)
let opened_everywhere = "scc_base"

let unused wing =
  let of_room room =
    let text = String.concat "\n" (List.map Tree.read room.sources) in
    let is_named use = use = opened_everywhere || Tree.contains text (String.capitalize_ascii use) in
    List.filter (fun use -> not (is_named use)) room.uses
    |> List.map (Printf.sprintf "%s/%s does not name %s" wing room.folder)
  in
  List.concat_map of_room (rooms_of wing)

let reaches ~from ~wing =
  let every = every_room () in
  let rec visit seen = function
    | [] -> seen
    | name :: rest when List.exists (fun r -> r.name = name) seen -> visit seen rest
    | name :: rest -> (
        match List.find_opt (fun r -> r.name = name) every with
        | Some r -> visit (r :: seen) (r.uses @ rest)
        | None -> invalid_arg ("no room " ^ name))
  in
  let inside = List.filter_map (fun r -> if r.wing = wing then Some r.name else None) every in
  let of_room r =
    List.filter (fun use -> List.mem use inside) r.uses |> List.map (Printf.sprintf "%s uses %s" r.name)
  in
  List.concat_map of_room (visit [] from)

let unnamed wing =
  let named = rows (Tree.read (readme wing)) and there = List.map (fun room -> room.folder) (rooms_of wing) in
  let without what list others =
    List.filter (fun name -> not (List.mem name others)) list |> List.map (Printf.sprintf "%s: %s %s" wing what)
  in
  let twice = List.filter (fun name -> List.length (List.filter (String.equal name) named) > 1) named in
  without "no row for" there named @ without "no room" named there
  @ List.map (Printf.sprintf "%s: two rows for %s" wing) twice

let is_file word =
  List.exists (Filename.check_suffix word) [ ".ml"; ".mly"; ".mll"; ".messages"; ".md"; ".json"; ".t" ]
  && String.contains word '/'
  && not (Tree.contains word "NAME")

let misplaced wing =
  let text = Tree.read (readme wing) in
  List.filteri (fun i _ -> i mod 2 = 1) (String.split_on_char '`' text)
  |> List.filter is_file
  |> List.filter (fun path -> not (Tree.exists path || Tree.exists (Printf.sprintf "lib/%s/%s" wing path)))
  |> List.map (Printf.sprintf "%s: no file %s" wing)

let too_long wing =
  let count = List.length (lines (Tree.read (readme wing))) in
  if count > 60 then [ Printf.sprintf "%s: %d lines" wing count ] else []
