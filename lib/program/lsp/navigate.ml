open Scc_base
open Scc_assist
open Scc_json

let location uri positions at : Json.t = `Assoc [ ("uri", Json.text uri); ("range", Workspace.place positions at) ]

(* {1 What is meant, and where its text is} *)

type meant =
  | In of Project.file * Names.target  (** a declaration, in its own file *)
  | Library of string
  | Missing of string  (** the file of an import cannot be read *)
  | Whole of Project.file  (** a module itself *)

let file_at (s : Session.t) path =
  Option.map
    (fun (reading, positions) : Project.file -> { path; reading; positions })
    (Workspace.reading_of s.workspace path)

let meant (s : Session.t) (f : Project.file) (target : Names.target) =
  match target with
  | Here _ | Several _ | Channel _ -> In (f, target)
  | There { library = true; file; _ } -> Library file
  | There { library = false; file; name } -> (
      match Option.bind (Workspace.resolved ~base:(Project.base f) file) (file_at s) with
      | None -> Missing file
      | Some m when name = "" -> Whole m
      | Some m -> (
          match Names.exported_target m.reading name with
          | Some target -> In (m, target)
          | None -> Missing file))

let occurrence s params =
  Option.bind (Session.plain_document s params) (fun (d : Workspace.document) ->
      Option.map (fun o -> (d, o)) (Names.at d.reading (Session.offset d params)))

(* {1 Places} *)

let places (s : Session.t) (f : Project.file) keep =
  List.filter keep (Names.all f.reading)
  |> List.map (fun (o : Names.occurrence) -> location (Project.address s.workspace f) f.positions o.at)

let is_declared offsets (o : Names.occurrence) =
  match o.target with Here h -> o.declares && List.mem h offsets | _ -> false

let definition s params : Json.t =
  match occurrence s params with
  | None -> `Null
  | Some (d, o) -> (
      match meant s (Project.of_document d) o.target with
      | In (f, Here offset) -> `List (places s f (is_declared [ offset ]))
      | In (f, Several offsets) -> `List (places s f (is_declared offsets))
      | In (f, (Channel _ as channel)) ->
        let opens (p : Names.occurrence) = p.declares && Names.same p.target channel in
        let other p = opens p && not (Span.equal p.at o.at) in
        `List (match places s f other with [] -> places s f opens | found -> found)
      | Whole f ->
        let start = Span.make ~file:"" ~start:0 ~stop:0 in
        `List [ location (Project.address s.workspace f) f.positions start ]
      | In (_, There _) | Library _ | Missing _ -> `Null)

(* The name under which a declaration can be imported. *)
let exported (f : Project.file) (target : Names.target) =
  let uses = Lazy.force f.reading.uses in
  match target with
  | Here offset -> (
      match Hashtbl.find_opt uses.all.items offset with
      | Some d -> (
          match Names.exported_target f.reading d.name.it with
          | Some other when Names.same other target -> Some d.name.it
          | Some _ | None -> None)
      | None -> None)
  | Several _ | Channel _ | There _ -> None

(* The places of the target in all files, each file with the target as it is called there. *)
let everywhere (s : Session.t) (f : Project.file) (target : Names.target) =
  let importers () = Project.importers s.workspace ~folders:s.client.folders f.path in
  match (target, exported f target) with
  | Channel _, _ ->
    let others = importers () @ Project.imports s.workspace [ f ] in
    List.map (fun f -> (f, target)) (f :: others)
  | _, Some name ->
    let of_importer (g : Project.file) =
      let names_it (o : Names.occurrence) =
        match o.target with
        | There { library = false; file; name = n } ->
          String.equal n name && Project.resolves ~base:g.path ~file f.path
        | _ -> false
      in
      List.find_opt names_it (Names.all g.reading) |> Option.map (fun (o : Names.occurrence) -> (g, o.target))
    in
    (f, target) :: List.filter_map of_importer (importers ())
  | _, None -> [ (f, target) ]

let references s params : Json.t =
  let declared =
    match Option.bind (Json.member "context" params) (Json.member "includeDeclaration") with
    | Some (`Bool b) -> b
    | _ -> true
  in
  match occurrence s params with
  | None -> `Null
  | Some (d, o) -> (
      let found (f, target) =
        let is_channel = match target with Names.Channel _ -> true | _ -> false in
        let keep (p : Names.occurrence) =
          Names.same p.target target && (declared || is_channel || not p.declares)
        in
        places s f keep
      in
      match meant s (Project.of_document d) o.target with
      | In (f, target) -> `List (List.concat_map found (everywhere s f target))
      | Whole _ | Library _ | Missing _ -> `List (found (Project.of_document d, o.target)))

let highlights s params : Json.t =
  match occurrence s params with
  | None -> `Null
  | Some (d, o) ->
    let range (p : Names.occurrence) : Json.t =
      let kind = if p.declares then 3 else 2 in
      `Assoc [ ("range", Workspace.place (Lazy.force d.positions) p.at); ("kind", `Int kind) ]
    in
    let same (p : Names.occurrence) = Names.same p.target o.target in
    `List (List.map range (List.filter same (Names.all d.reading)))

(* {1 New names} *)

let edit (s : Session.t) changes : Json.t =
  let text_edit positions (at, put) : Json.t =
    `Assoc [ ("range", Workspace.place positions at); ("newText", Json.text put) ]
  in
  let edits positions list : Json.t = `List (List.map (text_edit positions) list) in
  let version uri : Json.t =
    match Workspace.find s.workspace uri with Some d -> `Int d.version | None -> `Null
  in
  if s.client.versioned then
    let one (uri, positions, list) : Json.t =
      let document : Json.t = `Assoc [ ("uri", Json.text uri); ("version", version uri) ] in
      `Assoc [ ("textDocument", document); ("edits", edits positions list) ]
    in
    `Assoc [ ("documentChanges", `List (List.map one changes)) ]
  else
    let one (uri, positions, list) = (uri, edits positions list) in
    `Assoc [ ("changes", `Assoc (List.map one changes)) ]

let renamed s params =
  match occurrence s params with
  | None -> Rpc.refuse Rpc.failed "nothing that has a declaration is named here"
  | Some (d, o) -> (
      match meant s (Project.of_document d) o.target with
      | In (f, target) -> (d, o, f, target)
      | Library m -> Rpc.refuse Rpc.failed "this is a name of the library's module <%s>" m
      | Missing file -> Rpc.refuse Rpc.failed "`%s` declares nothing of this name, or cannot be read" file
      | Whole _ -> Rpc.refuse Rpc.failed "a module is called as its file: give it another name with `as`")

let prepare_rename s params : Json.t =
  let d, o, _, target = renamed s params in
  (match target with
   | Several _ -> Rpc.refuse Rpc.failed "several declarations may be meant here"
   | Here _ | Channel _ | There _ -> ());
  let placeholder = String.sub d.text o.at.start (o.at.stop - o.at.start) in
  `Assoc [ ("range", Workspace.place (Lazy.force d.positions) o.at); ("placeholder", Json.text placeholder) ]

let rename s params =
  let name = Rpc.string "newName" params in
  let d, _, f, target = renamed s params in
  let own_path = (Project.of_document d).path in
  let in_file ((g : Project.file), target) =
    match Rename.edits g.reading target name with
    | Ok [] -> None
    | Ok edits -> Some (Project.address s.workspace g, g.positions, edits)
    | Error why ->
      let is_own = String.equal g.path own_path in
      let where = if is_own then "" else Printf.sprintf " (in %s)" (Filename.basename g.path) in
      Rpc.refuse Rpc.failed "%s%s" why where
  in
  edit s (List.filter_map in_file (everywhere s f target))
