open Scc_base
open Scc_exact
open Scc_exchange

let ( let* ) = Result.bind
let one r = Result.map_error (fun d -> [ d ]) r

let read console path =
  let* source = one (Input.read path) in
  Console.add_source console source;
  one (Schedule.read source)

let same_value (name, value) (name', value') = String.equal name name' && not (Rat.equal value value')

let parameters (s : Schedule.t) overrides =
  let clash = List.find_opt (fun o -> List.exists (same_value o) s.parameters) overrides in
  match clash with
  | Some (name, _) ->
    Error
      [
        Diag.error Code.bad_schedule s.offset_at
          "the schedule was made with another value of `%s` than -D gives" name;
      ]
  | None ->
    let given (name, _) = List.exists (fun (name', _) -> String.equal name name') s.parameters in
    Ok (s.parameters @ List.filter (fun o -> not (given o)) overrides)

let check_digest (s : Schedule.t) (model : Input.model) =
  match s.digest with
  | Some d when not (String.equal d model.digest) ->
    Error
      [
        Diag.error Code.bad_schedule s.offset_at
          ~hint:"remove its `digest` to try it all the same: every choice is checked by its label"
          "the schedule was made for another model, or for another text of this one";
      ]
  | _ -> Ok ()

let model console (s : Schedule.t) ~overrides path =
  let* overrides = parameters s overrides in
  let* model = Input.model console ~overrides path in
  let* () = check_digest s model in
  Ok model
