open Scc_base
open Scc_property
open Scc_state_space
open Scc_verify
open Scc_loading
module Trajectory = Scc_evaluate.Trajectory

type goal = { within : Scc_exact.Rat.t option; prop : Property.prop }

type plan =
  | Now of Scc_ctl.Truth.t
  | Possibly of int
  | Always of int
  | All of plan list
  | Any of plan list
  | Other

type t = {
  loaded : Loaded.t;
  initial : Scc_calculus.State.t;
  reductions : Reduction.kind list;
  bits : int;
  number : int;
  count : int;
  exploration : Check.exploration;
  plans : (Property.check * plan) list;
  goals : goal array;
}

let reductions =
  let is k = not (List.exists (Reduction.equal k) [ Order; Draws; Isometry ]) in
  List.filter is Reduction.all

let options reductions : Setup.t = { Setup.default with reductions }
let semantics q = q.exploration.semantics

(* Goals are numbered as they come. *)
let plan (e : Check.exploration) goals (c : Property.check) =
  let add within prop =
    let within = Known_early.within (Scc_semantics.Semantics.model e.semantics) ~initial:e.start within prop in
    goals := { within; prop } :: !goals;
    List.length !goals - 1
  in
  let rec of_plan (p : Plan.t) =
    match p with
    | Now p -> Now (Trajectory.holds e.semantics e.start p)
    | Possibly (within, p) -> Possibly (add within p)
    | Always (within, p) -> Always (add within (Formula.negate p))
    | Formula _ -> Bug.fail __POS__ "a formula among searches"
    | All plans -> All (List.map of_plan plans)
    | Any plans -> Any (List.map of_plan plans)
  in
  let p = Joint_check.plan c in
  (c, if Plan.is_search p then of_plan p else Other)

let no_such fmt = Printf.ksprintf (fun text -> Error [ Diag.error Code.not_asked Span.command_line "%s" text ]) fmt

let named (l : Loaded.t) names =
  let has name (c : Property.check) = String.equal c.name name in
  let chosen (c : Property.check) = names = [] || List.exists (String.equal c.name) names in
  match List.find_opt (fun n -> not (List.exists (has n) l.checks)) names with
  | Some name -> no_such "the model has no property `%s`" name
  | None -> Ok (List.filter chosen l.checks @ List.filter chosen l.premises)

let make ~reductions ~bits ~names ~number l =
  let* l = Ordinary.refuse l in
  let* checks = named l names in
  let* initial = Loaded.initial l in
  let all = Check.explorations (options reductions) l.semantics ~initial checks in
  let count = List.length all in
  match List.nth_opt all (number - 1) with
  | None -> no_such "there is no exploration %d: these properties have %d" number count
  | Some exploration ->
    let goals = ref [] in
    let plans = List.map (plan exploration goals) exploration.members in
    let goals = Array.of_list (List.rev !goals) in
    Ok { loaded = l; initial; reductions; bits; number; count; exploration; plans; goals }

let is_premise q check = List.memq check q.loaded.premises

let horizon q =
  let e = q.exploration in
  Known_early.horizon (Scc_semantics.Semantics.model e.semantics) ~initial:e.start e.members

let context q =
  let e = q.exploration in
  let plans = List.map Joint_check.plan e.members in
  Joint_check.system (options q.reductions) e.semantics ~initial:e.start e.members plans

let predicates q context = Array.map (fun g -> Predicate.make context g.prop) q.goals
