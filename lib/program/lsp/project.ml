open Scc_syntax
open Scc_describe

type file = { path : string; reading : Reading.t; positions : Positions.t }

let most_files = 10_000

let of_document (d : Workspace.document) =
  { path = Option.value d.path ~default:d.uri; reading = d.reading; positions = Lazy.force d.positions }

let is_saved f = String.length f.path > 0 && f.path.[0] = '/'
let base f = if is_saved f then Some f.path else None

let address workspace f =
  match Workspace.find workspace f.path with
  | Some d -> d.uri
  | None -> if is_saved f then Uri.of_path f.path else f.path

let file workspace path =
  Option.map (fun (reading, positions) -> { path; reading; positions }) (Workspace.reading_of workspace path)

let resolves ~base ~file path =
  match Workspace.resolved ~base:(Some base) file with Some found -> String.equal found path | None -> false

let imported_paths f =
  let one (i : Ast.item) =
    match i.it with
    | Import { from; library = false; _ } -> Workspace.resolved ~base:(base f) from.it
    | _ -> None
  in
  List.filter_map one (Lazy.force f.reading.model)

let imports workspace roots =
  let seen = Hashtbl.create 8 in
  List.iter (fun f -> Hashtbl.replace seen f.path ()) roots;
  let rec collect found = function
    | [] -> List.rev found
    | path :: rest when Hashtbl.mem seen path || Hashtbl.length seen > most_files -> collect found rest
    | path :: rest -> (
        Hashtbl.add seen path ();
        match file workspace path with
        | None -> collect found rest
        | Some f -> collect (f :: found) (List.rev_append (imported_paths f) rest))
  in
  collect [] (List.concat_map imported_paths roots)

(* {1 Who imports a file} *)

let is_model name = List.exists (Filename.check_suffix name) [ ".sc"; ".osc" ]

let entries folder = match Sys.readdir folder with
  | names -> Array.sort String.compare names; Array.to_list names
  | exception Sys_error _ -> []

let kind path = match (Unix.lstat path).st_kind with kind -> Some kind | exception Unix.Unix_error _ -> None

let models folders =
  let rec walk left found = function
    | [] -> found
    | _ when left <= 0 -> found
    | path :: rest -> (
        let name = Filename.basename path in
        match kind path with
        | Some S_DIR when name <> "" && name.[0] <> '.' ->
          let inside = List.map (Filename.concat path) (entries path) in
          walk (left - 1) found (List.append inside rest)
        | Some S_REG when is_model name -> walk (left - 1) (path :: found) rest
        | _ -> walk (left - 1) found rest)
  in
  walk most_files [] folders

let contains text part =
  let n = String.length text and m = String.length part in
  let rec find i =
    if i + m > n then false
    else
      match String.index_from_opt text i part.[0] with
      | Some i when i + m <= n -> String.equal (String.sub text i m) part || find (i + 1)
      | Some _ | None -> false
  in
  m > 0 && find 0

let importers workspace ~folders path =
  let base = Filename.basename path in
  let opened = List.filter_map (fun (d : Workspace.document) -> d.path) (Workspace.all workspace) in
  let candidates = List.sort_uniq String.compare (opened @ models (List.map Uri.normal folders)) in
  let mentions candidate =
    match Workspace.text_of workspace candidate with
    | Ok text -> contains text base && contains text "import"
    | Error _ -> false
  in
  let importer candidate =
    if String.equal candidate path || not (mentions candidate) then None
    else
      match file workspace candidate with
      | Some f when List.mem path (imported_paths f) -> Some f
      | Some _ | None -> None
  in
  List.filter_map importer candidates

