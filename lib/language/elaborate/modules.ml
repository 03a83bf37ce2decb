open Scc_base
open Scc_syntax

type t = {
  known : (string, Env.scope option) Hashtbl.t;  (* by paths; nothing for a module with faults *)
  prefixes : (string, unit) Hashtbl.t;
  mutable reading : (string * Span.t) list;  (* the texts that are being read, and where they are imported *)
  mutable own : (string * Ast.imported) list;  (* what the model imports: paths, and how it calls them *)
}

let create () = { known = Hashtbl.create 8; prefixes = Hashtbl.create 8; reading = []; own = [] }

let rec may_hold (i : Ast.item) =
  match i.it with
  | Import _ | Param _ | Param_in _ | Let _ | Shape _ | Compound _ | Decomposed _ | Behaviour _ -> true
  | For (_, items) -> List.for_all may_hold items
  | Model _ | Timestep _ | Split_step _ | Dynamics _ | Collisions _ | Binding _ | Bonds _ | Blocked _
  | Resolution _
  | Round _ | Process _
  | Fixed _ | Bond _ | Network _ | Motion _ | Check _ -> false

(* {1 Names of modules} *)

(* A path without `.`, and without `..` after a folder. *)
let normal path =
  let step kept = function
    | "." | "" -> kept
    | ".." -> (match kept with up :: rest when not (String.equal up "..") -> rest | _ -> ".." :: kept)
    | folder -> folder :: kept
  in
  let joined = String.concat "/" (List.rev (List.fold_left step [] (String.split_on_char '/' path))) in
  if Filename.is_relative path then joined else "/" ^ joined

let is_letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
let is_part c = is_letter c || (c >= '0' && c <= '9') || c = '_' || c = '\''

let is_name text =
  String.length text > 0 && is_letter text.[0] && String.for_all is_part text

(* Of `<solids>`, a module of the library, what is between the marks. *)
let base path =
  let n = String.length path in
  if n > 2 && path.[0] = '<' then String.sub path 1 (n - 2)
  else Filename.remove_extension (Filename.basename path)

let file_path env (from : string Ast.loc) = normal (Env.beside env from.it)
let library_path (from : string Ast.loc) = "<" ^ from.it ^ ">"

let start t (scope : Env.scope) (model : Ast.model) =
  let import (i : Ast.item) =
    match i.it with
    | Import { from; library = true; names } -> Some (library_path from, names)
    | Import { from; library = false; names } -> Some (file_path (Env.root scope) from, names)
    | _ -> None
  in
  t.reading <- [ (scope.file, Span.none) ];
  t.own <- List.filter_map import model

let called t (scope : Env.scope) value =
  let names (path, imported) =
    match imported with
    | _ when not (String.equal path scope.file) -> []
    | Ast.Qualified None -> [ base path ^ "." ^ value ]
    | Qualified (Some (n : Ast.name)) -> [ n.it ^ "." ^ value ]
    | Chosen names ->
      let is_it ((n : Ast.name), _) = String.equal n.it value in
      List.map (fun (n, other) -> (Option.value ~default:n other : Ast.name).it) (List.filter is_it names)
  in
  List.concat_map names t.own

(* No two modules have one prefix. *)
let prefix t path =
  let base = if is_name (base path) then base path else "module" in
  let rec free i =
    let name = if i = 1 then base else Printf.sprintf "%s'%d" base i in
    if Hashtbl.mem t.prefixes name then free (i + 1) else name
  in
  let name = free 1 in
  Hashtbl.add t.prefixes name ();
  name ^ "."

(* {1 Reading} *)

let cycle t path = List.exists (fun (file, _) -> String.equal file path) t.reading

let report_cycle t report at path =
  let rec from = function
    | [] -> []
    | (file, _) :: rest when String.equal file path -> List.map fst rest
    | _ :: rest -> from rest
  in
  let between = List.map (Printf.sprintf "`%s`") (from (List.rev t.reading)) in
  let by = match between with [] -> "itself" | _ -> "itself, by " ^ String.concat " and " between in
  Report.error report Code.import_cycle at "`%s` imports %s" path by

let parse t report ~read path text at =
  let source = Source.make ~name:path text in
  match Scc_notation.Notation.model source with
  | Error faults ->
    List.iter (Report.add report) faults;
    None
  | Ok items ->
    let scope = Env.scope ~prefix:(prefix t path) ~file:path () in
    let depth = Report.create () in
    Limits.check_depth depth items;
    if Report.failed depth then begin
      List.iter (Report.add report) (Report.errors depth);
      None
    end
    else begin
      t.reading <- (path, at) :: t.reading;
      read scope items;
      t.reading <- List.tl t.reading;
      Some scope
    end

let of_library t report ~read (from : string Ast.loc) =
  let path = library_path from in
  match (Hashtbl.find_opt t.known path, Library.find from.it) with
  | Some found, _ -> found
  | None, Some text ->
    let scope = parse t report ~read path text from.at in
    Hashtbl.add t.known path scope;
    scope
  | None, None ->
    Report.error report Code.unknown_name from.at "there is no library `%s`; those that there are: %s" from.it
      (String.concat ", " Library.names)
      ~near:(from.it, fun () -> Library.names);
    None

let of_file t report ~read_file ~read env (from : string Ast.loc) =
  let path = file_path env from in
  match Hashtbl.find_opt t.known path with
  | Some found -> found
  | None when cycle t path ->
    report_cycle t report from.at path;
    None
  | None ->
    let scope =
      match read_file path with
      | Ok text -> parse t report ~read path text from.at
      | Error why ->
        Report.error report Code.cannot_read from.at "cannot read the import `%s`: %s" from.it why;
        None
    in
    Hashtbl.replace t.known path scope;
    scope

(* {1 What the importing text sees} *)

let taken report (here : Env.scope) (name : Ast.name) =
  let twice =
    Hashtbl.mem here.modules name.it || Hashtbl.mem here.chosen name.it || Hashtbl.mem here.declared name.it
    || Hashtbl.mem here.top name.it
  in
  if twice then
    Report.error report Code.duplicate_name name.at "the name `%s` is taken here" name.it
      ~hint:"import it under another one, with `as`";
  twice

let qualify report (here : Env.scope) (import : Ast.import) name (scope : Env.scope) =
  match name with
  | Some (n : Ast.name) -> if not (taken report here n) then Hashtbl.add here.modules n.it scope
  | None ->
    let n = { import.from with it = base import.from.it } in
    if not (is_name n.it) then
      Report.error report Code.bad_value n.at "`%s` cannot be a name here" n.it
        ~hint:(Printf.sprintf "say how it is called: `import \"%s\" as m`" import.from.it)
    else if not (taken report here n) then Hashtbl.add here.modules n.it scope

let exported (scope : Env.scope) =
  let keys table = Hashtbl.fold (fun name _ all -> name :: all) table [] in
  List.sort String.compare (keys scope.declared @ keys scope.top)

let choose report (here : Env.scope) (import : Ast.import) (scope : Env.scope) env ((name : Ast.name), other) =
  let local : Ast.name = Option.value ~default:name other in
  match (Hashtbl.mem scope.declared name.it, Hashtbl.find_opt scope.top name.it) with
  | false, None ->
    Report.error report Code.unknown_name name.at "`%s` declares no `%s`" import.from.it name.it
      ~near:(name.it, fun () -> exported scope);
    env
  | declared, value ->
    if taken report here local then env
    else begin
      if declared then Hashtbl.add here.chosen local.it (scope.prefix ^ name.it);
      match value with
      | Some binding -> Env.add local.it binding env
      | None -> env
    end

let import t report ~read_file ~read env (i : Ast.import) =
  let here = Env.scope_of env in
  let scope =
    if i.library then of_library t report ~read i.from else of_file t report ~read_file ~read env i.from
  in
  match (scope, i.names) with
  | None, Qualified name ->
    (* after an error what is qualified by it is not reported as well *)
    let n = match name with Some n -> n | None -> { i.from with it = base i.from.it } in
    Hashtbl.replace here.modules n.it (Env.scope ~missing:true ~prefix:(n.it ^ ".") ~file:i.from.it ());
    env
  | None, Chosen _ -> env
  | Some scope, Qualified name ->
    qualify report here i name scope;
    env
  | Some scope, Chosen names -> List.fold_left (choose report here i scope) env names
