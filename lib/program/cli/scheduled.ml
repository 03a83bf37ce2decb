open Scc_base
open Scc_loading
open Scc_runs

let read console path =
  let smaller =
    "`scc trace --states=ends` writes no states between the first and the last one: such a trace is small"
  in
  let* source = Input.text ~smaller console path in
  Result.listed (Schedule.read source)

let parameters (s : Schedule.t) (given : Options.definitions) =
  let clash name =
    [
      Diag.error Code.bad_schedule Span.command_line
        ~notes:[ (s.offset_at, "it is here") ]
        "the schedule was made with another value of `%s` than -D gives" name;
    ]
  in
  Origin.values ~recorded:s.parameters ~overrides:given.values ~narrowed:given.narrowed
  |> Result.map_error clash

let check_digest (s : Schedule.t) (origin : Origin.t) =
  match s.digest with
  | Some d when not (String.equal d origin.digest) ->
    Error
      [
        Diag.error Code.bad_schedule s.offset_at
          ~hint:"remove its `digest` to try it all the same: every choice is checked by its label"
          "the schedule was made for another model, or for another text of this one";
      ]
  | _ -> Ok ()

let model console (s : Schedule.t) ~(given : Options.definitions) path =
  let from = if given.values = [] && given.narrowed = [] then s.offset_at else Span.command_line in
  let* overrides, narrowed = parameters s given in
  let* model = Input.model ~given:from console ~overrides ~narrowed path in
  let* () = check_digest s model.origin in
  Ok model

let of_run (l : Loaded.t) path ?check (w : Scc_explain.Witness.t) =
  let choice (s : Scc_explain.Witness.step) =
    (s.choice, Scc_semantics.Transition.label_to_string l.model s.transition.label)
  in
  let path = if String.equal path "-" then None else Some path in
  let values = Option.fold ~none:[] ~some:(fun (f : Scc_explain.Witness.fixed) -> f.values) w.fixed in
  let origin = { l.origin with parameters = l.origin.parameters @ values } in
  Schedule.made ?model:path ?check origin
    (List.map choice w.steps)
    ~offset:(Scc_explain.Witness.offset w)

let of_witness l path (check : Scc_property.Property.check) w = of_run l path ~check:check.name w
