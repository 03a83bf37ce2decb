open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_json
open Scc_runs
open Json_format

type t = { given : Semantics.t; witness : Witness.t; full : bool }

let file = "check"

(* {1 Arguments} *)

let argument_format =
  recursive ~file "argument" (fun argument ->
      let part f (a : Witness.argument) = f a in
      about "A claim, why it is so, and the claims that this rests on."
        (fields
           [
             field "where" (nullable some_text) (part (fun a -> a.where))
               ~about:
                 "Of what is so on the way of a run: at which of its positions. null: where the run of the \
                  claim leads that this is a part of, or where that claim itself is made.";
             field "time" (nullable Shared.rational) (part (fun a -> a.time))
               ~about:
                 "The same as a time of the run of the witness, if it is on that one; of an irrational instant \
                  a rational within 10^-12 before it.";
             field "claim" some_text (part (fun a -> a.claim));
             field "holds" bool (part (fun a -> a.holds));
             field "because" Shared.texts (part (fun a -> a.because));
             field "parts" (list argument) (part (fun a -> a.parts));
           ]))

(* {1 Ends of runs} *)

let finish (w : Witness.t) =
  match w.finish with
  | At_state -> "state"
  | During _ -> "instant"
  | Rests _ -> "rests"
  | Stops -> "stops"
  | Repeats _ -> "repeats"
  | Passes _ -> "passes"
  | Goes_on _ -> "goes_on"

let finish_format =
  word Fun.id [ "state"; "instant"; "rests"; "stops"; "repeats"; "passes"; "goes_on" ]
  |> from finish
  |> about
    "state: to the state after the steps; instant: to an instant in a passing of time; rests: time passes for \
     ever; stops: nothing more can happen; repeats: the steps from `cycle` on, for ever; passes: to the end \
     of a bound of time, which it passes, or to the state before it if bodies turn too often until then; \
     goes_on: for ever as well, from a state that is like the one before the step `cycle` but for numbers, \
     but no run was found that comes back to a state."

let cycle (w : Witness.t) =
  match w.finish with
  | Repeats { cycle; _ } | Goes_on { cycle } -> Some cycle
  | At_state | During _ | Rests _ | Stops | Passes _ -> None

let moved (w : Witness.t) =
  match w.finish with
  | Repeats { moved; _ } -> Some moved
  | At_state | During _ | Rests _ | Stops | Passes _ | Goes_on _ -> None

let movement =
  let together w = match moved w with Some (Witness.Together by) -> Some by | Some (Apart _) | None -> None in
  let apart ((m : Model.t), w) =
    match moved w with
    | Some (Witness.Apart all) -> Some (List.map (fun (leaf, by) -> (m.leaves.(leaf).name, by)) all)
    | Some (Together _) | None -> None
  in
  let one =
    fields
      [ field "leaf" text fst ~about:"The first leaf of the process."; field "by" Shared.vector snd ]
  in
  all
    [
      field "moved" (nullable Shared.vector) (fun (_, w) -> together w)
        ~about:
          "By how much everything is moved each time the steps are repeated, for repeats; null where bodies \
           that never meet again are moved by different vectors.";
      maybe "moved_apart" (list one) apart
        ~about:
          "By how much each process is moved each time the steps are repeated, where that is not the same for \
           all.";
    ]

(* An irrational instant is told by an interval with rational ends around it. *)
let instant =
  let width = Rat.make Z.one (Z.pow (Z.of_int 10) 12) in
  let ends a =
    let low, high = Algebraic.enclose a ~width in
    (low, high, Algebraic.to_string a)
  in
  from ends
    (fields
       [
         field "low" Shared.rational (fun (low, _, _) -> low);
         field "high" Shared.rational (fun (_, high, _) -> high);
         field "text" text (fun (_, _, text) -> text);
       ])

(* {1 Steps} *)

let step =
  fields
    [
      field "choice" natural (fun (_, (s : Witness.step)) -> s.choice);
      field "label" State_json.label_format (fun (m, (s : Witness.step)) -> (m, s.transition.label));
      field "time" Shared.rational (fun (_, (s : Witness.step)) -> s.time) ~about:"Model time after it.";
      State_json.tie_chance (fun (_, (s : Witness.step)) -> (s.transition.label, s.transition.chance));
    ]

(* The first and the last steps, and how many are left out in between. *)
let most_steps = 100

let left_out t = if t.full then 0 else Int.max 0 (List.length t.witness.steps - (2 * most_steps))

let steps t =
  let more = left_out t in
  if more = 0 then t.witness.steps
  else List.filteri (fun i _ -> i < most_steps || i >= most_steps + more) t.witness.steps

let omitted =
  fields [ field "after" Shared.from_one (fun _ -> most_steps); field "count" Shared.from_one Fun.id ]

let format =
  let part f (_, _, t) = f t.witness in
  let made t =
    let c = Witness.semantics t.given t.witness in
    (c, Semantics.model c, t)
  in
  let values (w : Witness.t) =
    match w.fixed with None | Some { values = []; _ } -> None | Some f -> Some f.values
  in
  fields
    [
      field "initial" State_json.state_format (fun (_, m, t) -> (m, t.witness.initial));
      field "steps" (list step) (fun (_, m, t) -> List.map (fun s -> (m, s)) (steps t));
      maybe "omitted" omitted (fun (_, _, t) -> match left_out t with 0 -> None | more -> Some more)
        ~about:
          "Of the way to a state that was not explored: how many steps are left out, and after how many that \
           are there. With --full none are.";
      field "finish" finish_format (part Fun.id);
      field "cycle" (nullable (integer ())) (part cycle) ~about:"Index into the steps, for repeats and goes_on.";
      within (fun (_, m, t) -> (m, t.witness)) movement;
      field "instant" instant (part Witness.instant)
        ~about:
          "The model time that the run leads to: rational when low = high, and else an irrational number \
           between them.";
      field "offset" (nullable Shared.rational) (part Witness.offset)
        ~about:"Time to pass after the steps to replay it (within 10^-12 when irrational).";
      field "state" State_json.state_format (fun (c, m, t) -> (m, Witness.there c t.witness)) ~about:"There.";
      field "facts" (list some_text) (part (fun w -> w.facts));
      field "argument" (nullable argument_format) (part (fun w -> w.argument))
        ~about:"Of a formula with temporal operators inside others: why it holds or does not, claim by claim.";
      maybe "values" Origin_json.parameters_format (part values)
        ~about:"Of parameters that have ranges: those of this run.";
    ]
  |> from made |> about "A run: its steps, then where it leads." |> named ~file "witness"

(* {1 A run that does otherwise} *)

let contrast t =
  Option.map
    (fun (o : Witness.otherwise) -> (o.shared, { t with witness = o.run }))
    t.witness.Witness.otherwise

let otherwise =
  fields
    [
      field "shared" natural fst
        ~about:"The number of steps that it has in common with the witness, at its beginning.";
      field "witness" format snd;
    ]
