open Scc_base
open Scc_calculus
open Scc_property
open Scc_verify
open Scc_loading

(* Whether some behaviour that a body may come to has a summand that does this to bonds of this name. *)
let can_happen terms (change : Property.change) name =
  let is (c : Behaviour.channel) = match name with None -> true | Some a -> String.equal c.name a in
  let opened polarity (b : Behaviour.t) =
    match (b, polarity) with
    | Open (Name, c, _), Behaviour.Name | Open (Co_name, c, _), Behaviour.Co_name -> is c
    | _, _ -> false
  in
  let weak : Behaviour.t -> bool = function Weak (c, _, _) -> is c | _ -> false in
  let strong : Behaviour.t -> bool = function Strong (list, _, _) -> List.exists is list | _ -> false in
  let some f = List.exists f terms in
  match change with
  | Made -> some (opened Name) && some (opened Co_name)
  | Released_weakly -> some weak
  | Released_strongly -> some strong
  | Released -> some weak || some strong

let impossible (l : Loaded.t) =
  let counted = Coverage.create l.model ~initial:l.declared in
  let terms = List.map (fun (s : Coverage.summand) -> s.term) (Coverage.summands counted) in
  let impossible : Property.event -> bool = function
    | Bond (change, name, _) -> not (can_happen terms change name)
    | Absorbed _ -> not (Model.absorbs l.model)
    | Bounce _ | Hit _ -> false
  in
  let warning (c : Property.check) event =
    Diag.warning Code.impossible_event c.span "no behaviour can bring about `event %s`, of which `%s` speaks"
      (Show.event l.model event) c.name
  in
  List.concat_map
    (fun (c : Property.check) -> List.map (warning c) (List.filter impossible (Formula.events c.formula)))
    l.checks

let premise ({ check = p; verdict; _ } : Verdict.outcome) =
  match verdict with
  | Violated _ ->
    Some
      (Diag.warning Code.vacuous p.span "no run ever meets `%s`, so that what `%s` says of it is never asked"
         p.text p.name)
  | Holds _ | Measured _ | Depends _ | Undecided _ -> None

let holds (o : Verdict.outcome) =
  match o.verdict with
  | Holds _ -> true
  | Violated _ | Measured _ | Depends _ | Undecided _ -> false

let warnings (report : Check.report) ~verdicts ~answers =
  let uneventful =
    if report.uneventful && List.exists holds verdicts then
      [
        Diag.warning Code.uneventful Span.none
          "no event ever happens in this model: no two bodies collide, and nothing splits"
          ~hint:"`scc check --coverage` lists what never came to be";
      ]
    else []
  in
  Option.to_list report.stats.growth
  @ Option.to_list report.stats.shared
  @ uneventful
  @ List.filter_map premise answers
