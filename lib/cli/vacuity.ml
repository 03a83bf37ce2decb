open Scc_base
open Scc_property
open Scc_verify

let questions (e : Scc_elaborate.Elaborate.t) = e.premises

let premise ((p : Property.check), (v : Verdict.t)) =
  match v with
  | Violated _ ->
    Some
      (Diag.warning Code.vacuous p.span "no run ever meets `%s`, so that what `%s` says of it is never asked"
         p.text p.name)
  | Holds _ | Undecided _ -> None

let holds (_, (v : Verdict.t)) =
  match v with
  | Holds _ -> true
  | Violated _ | Undecided _ -> false

let warnings (s : Check.stats) ~verdicts ~answers =
  let uneventful =
    if s.complete && (not s.eventful) && List.exists holds verdicts then
      [
        Diag.warning Code.uneventful Span.none
          "no event ever happens in this model: no two bodies collide, and nothing splits"
          ~hint:"`scc check --coverage` lists what never came to be";
      ]
    else []
  in
  uneventful @ List.filter_map premise answers
