open Scc_chance
open Scc_property
open Scc_state_space
open Scc_explain
open Scc_verify

type t = { check : int; verdict : Verdict.t; unexplored : bool }

(* What is known of one property, while it is being evaluated. *)
type look = {
  formulas : Formulas.t;
  progress : Progress.t;
  most_states : int;
  mutable unexplored : bool;
}

let told what m = Verdict.Undefined (Printf.sprintf "the %s is %s" what (Likelihoods.measured m))

(* Nothing ends the work but the end of all: fractions are given up for their size, or their work. *)
let inexact l : Verdict.inexact option =
  let of_reason : Lifting.given_up -> Verdict.inexact = function
    | Too_long -> Too_long
    | Too_much | Interrupted -> Too_much
  in
  Option.map of_reason (Formulas.not_exact l.formulas)

let told_inexact l =
  List.map (fun why -> Verdict.Undefined (Verdict.inexact_to_string why)) (Option.to_list (inexact l))

let reasons l (d : Scc_ctl.Doubts.t) =
  if d.unexplored <> [] then l.unexplored <- true;
  List.map (fun (u : Scc_ctl.Doubts.undefined) -> u.reason) d.undefined
  |> List.sort_uniq String.compare
  |> List.map (fun text -> Verdict.Undefined text)

(* {1 Whether something holds} *)

let unclear = Verdict.Undefined "a probability within the formula is not known well enough to be compared"

let formula_doubts l i =
  let doubts = reasons l (Formulas.doubts l.formulas i) in
  let intervals () = List.map (told "probability") (Formulas.probabilities l.formulas i) in
  match doubts with
  | _ :: _ -> doubts
  | [] when l.unexplored -> []
  | [] -> ( match intervals () @ told_inexact l with [] -> [ unclear ] | reasons -> reasons)

(* What nothing within the bound of states refutes holds up to that bound, if there is no other doubt. *)
let bound l =
  let p = l.progress in
  if p.stop <> Some States || p.faults <> [] || p.too_long > 0 || p.too_deep > 0 then None
  else Some { Verdict.limit = States l.most_states; origin = By_user }

let holds : Verdict.t = Holds { bounds = []; witness = None }

(* The formulas of a plan are those of {!Plan.searches}: the index of the next one goes with the verdict. *)
let rec verdict l (plan : Plan.t) i : Verdict.t * int =
  match plan with
  | All plans ->
    let all, next = verdicts l plans i in
    (Verdict.conjunction all, next)
  | Any plans ->
    let all, next = verdicts l plans i in
    (Verdict.disjunction all, next)
  | Now _ | Possibly _ | Always _ | Formula _ -> (
      match Formulas.truth l.formulas i with
      | Some true -> (holds, i + 1)
      | Some false -> (Violated { witness = None }, i + 1)
      | None -> (undecided l plan i, i + 1))

and undecided l plan i : Verdict.t =
  let doubts = formula_doubts l i in
  match (plan, doubts, bound l) with
  | Always _, [], Some bound -> Holds { bounds = [ bound ]; witness = None }
  | _ -> Undecided doubts

and verdicts l plans i =
  let add (found, i) plan =
    let v, next = verdict l plan i in
    (v :: found, next)
  in
  let found, next = List.fold_left add ([], i) plans in
  (List.rev found, next)

(* {1 Numbers} *)

let of_sides l sides find =
  Likelihoods.of_sides ~is_chain:(fun () -> Formulas.is_chain l.formulas) sides find

let are_exact values = List.for_all (fun (_, m) -> Likelihoods.is_exact m) values

let measured l values doubts : Verdict.t =
  let reasons = if are_exact values then [] else reasons l (doubts ()) in
  let inexact = if reasons <> [] || l.unexplored || are_exact values then None else inexact l in
  Measured { values; reasons; inexact; witness = None; curve = []; starts = [] }

let probability l i sides =
  let values = of_sides l sides (Formulas.probability l.formulas i) in
  measured l values (fun () -> Formulas.possible_doubts l.formulas i)

let compared l i (bound : Answer.bound) m : Verdict.t =
  let { Scc_ctl.Eval.least; most } = m in
  match (Answer.holds least bound, Answer.holds most bound) with
  | Some true, Some true -> holds
  | Some false, Some false -> Violated { witness = None }
  | _ ->
    let doubts = if Likelihoods.is_exact m then [] else reasons l (Formulas.doubts_of_mean l.formulas i) in
    let not_exact = if doubts = [] && not l.unexplored then told_inexact l else [] in
    Undecided ((told "mean" m :: doubts) @ not_exact)

let mean l i sides mean test : Verdict.t =
  let find side = Formulas.mean ?bound:test l.formulas i side mean in
  let found = of_sides l sides find in
  let unknown (_, answer) =
    match (answer : Scc_ctl.Expectation.answer) with
    | Known _ -> []
    | Unknown { reason; unexplored } ->
      if unexplored <> [] then l.unexplored <- true;
      [ Option.map (fun text -> Verdict.Undefined text) reason ]
  in
  let known (side, answer) =
    match (answer : Scc_ctl.Expectation.answer) with Known m -> Some (side, m) | Unknown _ -> None
  in
  match (List.concat_map unknown found, List.filter_map known found, test) with
  | (_ :: _ as unknown), _, _ -> Undecided (List.filter_map Fun.id unknown)
  | [], [ (_, m) ], Some bound -> compared l i bound m
  | [], values, _ -> measured l values (fun () -> Formulas.doubts_of_mean l.formulas i)

(* {1 Whether more states matter} *)

let without_unexplored (d : Scc_ctl.Doubts.t) = d.unexplored = []

let is_settled formulas (c : Wanted.check) =
  match c.check.asked with
  | Whether ->
    let known k _ = Option.is_some (Formulas.truth formulas (c.first + k)) in
    List.for_all Fun.id (List.mapi known (Plan.searches c.plan))
  | How_likely _ -> without_unexplored (Formulas.possible_doubts formulas c.first)
  | Expected (_, (Time_until _ | Events_until _), _) ->
    without_unexplored (Formulas.doubts_of_mean formulas c.first)
  | Expected (sides, (Value_at _ as mean), _) ->
    let is_known side =
      match Formulas.mean formulas c.first side mean with
      | Known _ | Unknown { unexplored = []; _ } -> true
      | Unknown _ -> false
    in
    List.for_all is_known sides

let are_settled (w : Wanted.t) formulas = List.for_all (is_settled formulas) w.checks

(* {1 All of them} *)

let one formulas progress ~most_states (c : Wanted.check) =
  let l = { formulas; progress; most_states; unexplored = false } in
  let verdict =
    match c.check.asked with
    | Whether -> fst (verdict l c.plan c.first)
    | How_likely sides -> probability l c.first sides
    | Expected (sides, of_what, test) -> mean l c.first sides of_what test
  in
  List.iteri (fun k _ -> Formulas.done_with formulas (c.first + k)) (Plan.searches c.plan);
  { check = c.place; verdict; unexplored = l.unexplored }

let all (w : Wanted.t) formulas progress ~most_states =
  List.map (one formulas progress ~most_states) w.checks
