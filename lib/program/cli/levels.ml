open Scc_base
open Scc_property
open Scc_loading
open Scc_estimate

let questions console l text =
  let* texts = Splitting.levels text in
  Observed.questions console l texts ~name:(fun i _ -> Printf.sprintf "<level %d>" (i + 1))
    (fun _ _ question ~refuse ->
       match question with
       | State p -> Ok p
       | Number _ | Temporal _ ->
         refuse Code.type_mismatch ~hint:"as in `--levels 'x(p) >= 1, 2, 3'`"
           "a level compares a number with a value")

let refused (c : Property.check) why =
  [ Diag.error Code.type_mismatch c.span "`%s` cannot be estimated: %s" c.name why ]

let plan console (loaded : Loaded.t) paths text ~effort ~steps =
  let refused_path (path : Path.t) why = Error (refused path.check why) in
  let* path, (goal, horizon) =
    match paths with
    | [ path ] -> (
        match Splitting.goal path with
        | Some goal -> Ok (path, goal)
        | None -> refused_path path "levels are passed on the way to f, in `P = ? [ eventually f ]`")
    | path :: _ -> refused_path path "levels are those of one property: choose it by `--check` or `--property`"
    | [] -> Bug.fail __POS__ "no property"
  in
  let* loaded, levels = questions console loaded text in
  let plan =
    {
      Splitting.semantics = loaded.semantics;
      declared = loaded.declared;
      goal;
      horizon;
      levels;
      effort;
      steps;
    }
  in
  match Splitting.holds_at_start plan with
  | Some i when i < List.length levels ->
    Error
      [
        Diag.error Code.type_mismatch Span.command_line "level %d is passed at the start" (i + 1)
          ~hint:"leave it out: levels are passed later, one after the other";
      ]
  | Some _ -> refused_path path "its goal is reached at the start"
  | None -> Ok (path, plan)
