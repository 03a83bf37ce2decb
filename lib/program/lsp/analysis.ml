open Scc_base
open Scc_loading

type t = {
  diagnostics : Diag.t list;
  files : string list;
  values : (Span.t * string) list;
  known : Scc_assist.Known.t;
}

(* A text that declares nothing but what others import need not use it. *)
let is_module (d : Workspace.document) =
  let of_module (i : Scc_syntax.Ast.item) =
    match i.it with
    | Import _ | Param _ | Param_in _ | Let _ | Shape _ | Compound _ | Decomposed _ | Behaviour _ -> true
    | _ -> false
  in
  match Lazy.force d.reading.model with [] -> false | items -> List.for_all of_module items

let matters ~of_module (d : Diag.t) =
  let is (code : Code.t) = String.equal d.code (code :> string) in
  not (of_module && (is Code.unused || is Code.empty_model))

let known_of workspace (d : Workspace.document) =
  if Scc_describe.Reading.is_plain d.reading.source then
    Scc_assist.Known.of_text (Workspace.imported workspace ~base:d.path) d.reading
  else Scc_assist.Known.empty

let of_document workspace (d : Workspace.document) =
  let files = ref [] in
  let read_file name =
    Option.iter (fun path -> files := path :: !files) (Workspace.resolved ~base:d.path name);
    Workspace.reader workspace d name
  in
  let of_module = is_module d in
  let diagnostics, values =
    match Loaded.load ~read_file ~overrides:[] d.reading.source with
    | Error found -> (found, [])
    | Ok l ->
      let initial = match Loaded.initial l with Ok _ -> [] | Error found -> found in
      (l.warnings @ Scc_verdicts.Vacuity.impossible l @ initial, l.values)
  in
  {
    diagnostics = List.filter (matters ~of_module) diagnostics;
    files = List.sort_uniq String.compare !files;
    values;
    known = known_of workspace d;
  }
