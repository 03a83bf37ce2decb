open Scc_base
open Scc_calculus
open Scc_state_space
open Scc_loading

let unfit (e : Check_extras.t) =
  let given =
    [
      ("--where", e.where); ("--smt", Option.is_some e.smt); ("--draw", Option.is_some e.draw);
      ("--prove", e.prove); ("--curve", Option.is_some e.curve); ("--curve-plot", Option.is_some e.plot);
      ("--witness", Option.is_some e.witness); ("--coverage", e.coverage); ("--hash-compact", e.compact);
      ("--store", Option.is_some e.store);
    ]
  in
  if Option.is_none e.parametric then None else Option.map fst (List.find_opt snd given)

let reductions kinds =
  let joins kind = Reduction.equal Draws kind || Reduction.equal Isometry kind in
  List.filter (fun kind -> not (joins kind)) kinds

let fitting (l : Loaded.t) =
  let refuse what hint = Error [ Diag.error Code.not_yet Span.none "%s" what ~hint ] in
  match (l.parameter, Scc_verdicts.Verdicts.over_zones l) with
  | Some { parameter; _ }, true ->
    if Array.length l.model.ranges > 0 then
      refuse
        (Printf.sprintf "`%s` is asked about, and other parameters have ranges, too" parameter.name)
        (Printf.sprintf "`-D %s=VALUE` gives the other one a value" (Ranges.name l.model.ranges 0))
    else
      refuse "with `--parametric` bonds are released at the instants of a grid" "give a `split_step`"
  | Some { parameter; _ }, false -> (
      match Coincidence.find l.model l.declared parameter with
      | None -> Ok ()
      | Some (at, p, q) ->
        Error
          [
            Diag.error Code.bad_value
              (Span.of_file (Source.name l.source))
              "`%s` and `%s` are equal for %s: there two summands are the same term, and a lot that was drawn by \
               one of them stays for the other" (Odds.to_string p) (Odds.to_string q) at
              ~hint:(Open_number.narrower parameter);
          ])
  | None, _ -> Ok ()

let at_value (l : Loaded.t) diagnostics =
  match l.parameter with
  | None -> diagnostics
  | Some { parameter; value; _ } ->
    let said (d : Diag.t) =
      let value = Scc_exact.Rat.to_string value in
      { d with message = Printf.sprintf "%s, for %s = %s" d.message parameter.name value }
    in
    List.map said diagnostics

let rec explored_at ~load attempt (l : Loaded.t) explore =
  match explore l with
  | result -> Result.map (fun r -> (l, r)) result
  | exception Edge_functions.Refused d -> Error [ Diag.of_file (Source.name l.source) d ]
  | exception Edge_functions.Ambiguous when attempt + 1 < Open_number.attempts ->
    let* l = load ~attempt:(attempt + 1) in
    explored_at ~load (attempt + 1) l explore
  | exception Edge_functions.Ambiguous ->
    Error
      [
        Diag.error Code.not_yet
          (Span.of_file (Source.name l.source))
          "some probabilities could not be told apart at any of %d values of the parameter" Open_number.attempts;
      ]

let explored ~load l explore = explored_at ~load 0 l explore
