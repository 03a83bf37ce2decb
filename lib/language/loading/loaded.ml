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
  parameter : Open_number.t option;
  checks : Property.check list;
  premises : Property.check list;
  families : Scc_elaborate.Repeated.t;
  lattices : Scc_elaborate.Lattices.t list;
  warnings : Diag.t list;
  values : (Span.t * string) list;
  at_values : (string * Rat.t) list -> (t, Diag.t list) result;
  beside : Scc_syntax.Ast.model -> (t, Diag.t list) result;
}

type reader = string -> (string, string) result

(* The files that are read on the way are noted. *)
let noting read_file =
  let files = ref [] in
  let read_file name =
    let result = read_file name in
    let known = List.exists (fun (n, _) -> String.equal n name) !files in
    (match result with Ok text when not known -> files := (name, text) :: !files | Ok _ | Error _ -> ());
    result
  in
  (read_file, fun () -> List.rev !files)

let rec of_tree ~read_file ~overrides ?narrowed ?parametric source tree =
  let noted, files = noting read_file in
  let elaborated = Scc_elaborate.Elaborate.elaborate ~read_file:noted ~overrides ?narrowed ?parametric tree in
  let files = files () in
  let text (name, text) = Direction.warnings (Source.make ~name text) in
  let misleading = Direction.warnings source @ List.concat_map text files in
  let digest = Origin.digest ~text:(Source.text source) ~files in
  let rec loaded items elaborated =
    let* (e : Scc_elaborate.Elaborate.t) = Result.map_error (fun errors -> errors @ misleading) elaborated in
    let { Scc_elaborate.Elaborate.model; declared; uncertain; parameter; checks; premises; families; lattices;
          warnings; values; _ } = e
    in
    let warnings = misleading @ warnings in
    let settings =
      List.append (Scc_calculus.Parameters.listed model declared) (Scc_elaborate.Lattices.settings lattices)
    in
    let origin = { Origin.name = e.name; digest; parameters = e.parameters; settings } in
    let at_values values =
      of_tree ~read_file ~overrides:(overrides @ values) ?narrowed ?parametric source (List.append tree items)
    in
    let beside more = loaded (List.append items more) (Scc_elaborate.Elaborate.with_checks e more) in
    Ok
      {
        source; origin; semantics = Standard.of_model model; model; declared; uncertain; parameter; checks;
        premises; families; lattices; warnings; values; at_values; beside;
      }
  in
  loaded [] elaborated

let at l values = l.at_values values
let with_checks l items = l.beside items

let load ~read_file ~overrides ?narrowed ?parametric source =
  let* tree =
    Result.map_error (fun errors -> errors @ Direction.warnings source) (Scc_notation.Notation.model source)
  in
  of_tree ~read_file ~overrides ?narrowed ?parametric source tree

let initial l =
  let diagnostic = Transition.diagnostic l.model ~at:(Ranges.point l.model.ranges) in
  Result.map_error (fun fault -> [ diagnostic fault ]) (Network.initial l.semantics l.declared)
