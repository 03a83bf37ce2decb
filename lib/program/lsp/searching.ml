open Scc_describe
open Scc_assist
open Scc_json

let most = 1_000

(* How well a name fits: 0 is best. *)
let rank query name =
  let name = String.lowercase_ascii name in
  if String.equal name query then Some 0
  else if String.starts_with ~prefix:query name then Some 1
  else if Project.contains name query then Some 2
  else None

(* A loop, an import and a motion declare no name of their own. *)
let is_declaration (n : Outline.node) =
  match n.kind with "loop" | "import" | "motion" -> false | _ -> n.name <> ""

let rec declarations within (n : Outline.node) =
  if is_declaration n then (within, n) :: List.concat_map (declarations (Some n.name)) n.inner
  else List.concat_map (declarations within) n.inner

let symbol address (f : Project.file) (within, (n : Outline.node)) : Json.t =
  let place : Json.t = `Assoc [ ("uri", Json.text address); ("range", Workspace.place f.positions n.name_at) ] in
  let container = Option.to_list (Option.map (fun name -> ("containerName", Json.text name)) within) in
  let kind : Json.t = `Int (Structure.symbol_kind n.kind) in
  `Assoc ([ ("name", Json.text n.name); ("kind", kind); ("location", place) ] @ container)

let symbols (s : Session.t) params : Json.t =
  let query = String.lowercase_ascii (Rpc.string "query" params) in
  let opened = List.map Project.of_document (Workspace.all s.workspace) in
  let is_plain (f : Project.file) = Reading.is_plain f.reading.source in
  let files = List.filter is_plain (List.append opened (Project.imports s.workspace opened)) in
  let fitting (f : Project.file) =
    let address = Project.address s.workspace f in
    let fits ((_, (n : Outline.node)) as d) = Option.map (fun r -> (r, address, f, d)) (rank query n.name) in
    List.filter_map fits (List.concat_map (declarations None) (Outline.of_text f.reading))
  in
  let by_rank (a, _, _, _) (b, _, _, _) = Int.compare a b in
  let found = Scc_data.Lists.take most (List.stable_sort by_rank (List.concat_map fitting files)) in
  `List (List.map (fun (_, address, f, d) -> symbol address f d) found)
