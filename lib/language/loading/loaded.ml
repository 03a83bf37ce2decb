open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Scc_semantics
open Scc_engine

type t = {
  source : Source.t;
  origin : Origin.t;
  semantics : Semantics.t;
  model : Model.t;
  declared : State.t;
  uncertain : Uncertain.t option;
  checks : Property.check list;
  premises : Property.check list;
  warnings : Diag.t list;
  again : Scc_syntax.Ast.model -> (string * Rat.t) list -> (t, Diag.t list) result;
}

type reader = string -> (string, string) result

let ( let* ) = Result.bind

let rec of_tree ~read_file ~overrides ?narrowed source tree =
  let files = ref [] in
  let read_file name =
    let result = read_file name in
    let known = List.exists (fun (n, _) -> String.equal n name) !files in
    (match result with Ok text when not known -> files := (name, text) :: !files | Ok _ | Error _ -> ());
    result
  in
  let misleading () =
    let text (name, text) = Direction.warnings (Source.make ~name text) in
    Direction.warnings source @ List.concat_map text (List.rev !files)
  in
  let* (e : Scc_elaborate.Elaborate.t) =
    Scc_elaborate.Elaborate.elaborate ~read_file ~overrides ?narrowed tree
    |> Result.map_error (fun errors -> errors @ misleading ())
  in
  let digest = Origin.digest ~text:(Source.text source) ~files:(List.rev !files) in
  let { Scc_elaborate.Elaborate.model; declared; uncertain; checks; premises; warnings; _ } = e in
  let warnings = misleading () @ warnings in
  let settings = Scc_calculus.Parameters.listed model declared in
  let origin = { Origin.name = e.name; digest; parameters = e.parameters; settings } in
  let again items values =
    of_tree ~read_file ~overrides:(overrides @ values) ?narrowed source (List.append tree items)
  in
  Ok
    {
      source; origin; semantics = Standard.of_model model; model; declared; uncertain; checks; premises; warnings;
      again;
    }

let at l values = l.again [] values
let with_items l items = l.again items []

let load ~read_file ~overrides ?narrowed source =
  let* tree =
    Result.map_error (fun errors -> errors @ Direction.warnings source) (Scc_notation.Notation.model source)
  in
  of_tree ~read_file ~overrides ?narrowed source tree

let initial l =
  Result.map_error (fun f -> [ Transition.diagnostic l.model f ]) (Network.initial l.semantics l.declared)
