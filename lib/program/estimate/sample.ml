open Scc_system
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_runs
open Scc_simulate

type free = Apart | Evenly

type plan = {
  semantics : Semantics.t;
  declared : State.t;
  paths : Path.t list;
  free : free;
  steps : int option;
  until : Rat.t option;
}

type bound = Steps | Time | Instant | Interruption
type choice = Walkers_bounce | Splits | Elsewhere
type outcome = Truth of bool | Number of Rat.t | Never | Free of choice | Too_long of bound | No_value of string

type run = { outcomes : outcome list; chosen : bool; interrupted : bool }

(* What was asked is looked for after so many states, half as many again, and so on. *)
let first_look = 8
let next_look n = n + (n / 2)
let default_steps = 10_000

(* Nothing that is asked depends on what comes a unit of time after all horizons. *)
let horizon plan =
  let later h (p : Path.t) = Option.map2 Rat.max h p.horizon in
  match plan.paths with
  | [] -> None
  | p :: rest -> Option.map (Rat.add Rat.one) (List.fold_left later p.horizon rest)

let until plan = Option.merge Rat.min (horizon plan) plan.until

(* A run that ends at a time needs no other bound. *)
let limit plan =
  match (plan.steps, until plan) with
  | (Some _ as given), _ -> given
  | None, Some _ -> None
  | None, None -> Some default_steps

(* Where bodies turn or velocities are rounded, walkers cannot wait (rule Blocked). *)
let choice (m : Model.t) : Transition.label -> choice = function
  | Bounce { firsts; _ } when m.blocked = Bounce && Option.is_none m.rigid && Option.is_none m.round_velocity ->
    if List.exists (fun leaf -> Law.draws m.leaves.(leaf).law) firsts then Walkers_bounce else Elsewhere
  | Weak_split _ -> Splits
  | _ -> if Model.draws_ties m then Splits else Elsewhere

let outcome ~bound ~over_for_ever stopped_by_choice : Chain.answer -> outcome = function
  | Truth b -> Truth b
  | Number r -> Number r
  | Never -> Never
  | No_value why -> No_value why
  | Open when bound = Interruption -> Too_long Interruption
  | Open when over_for_ever -> No_value "something that it asks for has no value there"
  | Open -> Option.fold ~none:(Too_long bound) ~some:(fun choice -> Free choice) stopped_by_choice

let run plan ~seed ~interrupted number =
  let questions = Chain.questions plan.semantics plan.paths and chain = ref None in
  let joined = List.for_all (fun (p : Path.t) -> Scc_state_space.Between_draws.unseen p.check) plan.paths in
  let next = ref first_look in
  let over = ref false and chosen = ref false in
  let look chain =
    Chain.look chain;
    if Chain.settled chain then over := true
  in
  (* Choices are told of up to where the answers are looked for. *)
  let look_on chain =
    if Chain.length chain >= !next then begin
      next := next_look !next;
      look chain
    end
    else if (plan.free = Apart || !chosen) && Chain.settled chain then over := true
  in
  let limit = limit plan and stopped_by_choice = ref None and steps = ref 0 and bound = ref Time in
  let note (event : Replay.event) =
    (match event with Step { draws_on; _ } -> if not draws_on then incr steps | Start _ | Instant _ | End _ -> ());
    match (event, !chain) with
    | Start state, _ -> chain := Some (Chain.start questions state)
    | Step { draws_on = true; _ }, _ when joined -> ()
    | Step { taken; free; state; part; _ }, Some chain when not !over ->
      if free && plan.free = Evenly then chosen := true;
      if free && plan.free = Apart then begin
        look chain;
        if not !over then stopped_by_choice := Some (choice (Semantics.model plan.semantics) taken.label);
        over := true
      end
      else begin
        Chain.step chain taken ~state ~part;
        look_on chain
      end
    | Instant { offset; state; _ }, Some chain -> if Rat.sign offset > 0 then Chain.pass chain offset state
    | End { ending = Quiescent; last; _ }, Some chain -> Chain.for_ever chain last
    | End { ending = Stuck _; last; _ }, Some chain -> Chain.dead_end chain last
    | End { ending = Open; _ }, _ -> if Some !steps = limit then bound := Steps
    | End { ending = Zeno; _ }, _ -> bound := Instant
    | (Step _ | Instant _ | End _), _ -> ()
  in
  let passing ~start:_ ~lasts state =
    if not !over then Option.iter (fun chain -> Chain.passing chain ~lasts state) !chain
  in
  let limits = { Replay.steps = limit; time = until plan; instant = Replay.default_instant } in
  let policy = Replay.Random (Simulation.seed_of seed number) and left () = !over || interrupted () in
  let go_on () =
    match Replay.run ~passing ~joint:true plan.semantics plan.declared policy limits ~interrupted:left note with
    | Ok _ | Error (Fault _) -> ()
    | Error (Interrupted _ | Refused _) -> if not !over then bound := Interruption
  in
  (try
     go_on ();
     if not !over then Option.iter look !chain
   with Interruption.Interrupted _ -> bound := Interruption);
  let over_for_ever = Option.fold ~none:false ~some:Chain.is_over !chain in
  let outcome = outcome ~bound:!bound ~over_for_ever !stopped_by_choice in
  let none_yet = List.map (fun _ -> Chain.Open) plan.paths in
  let found = Option.fold ~none:none_yet ~some:Chain.answers !chain in
  { outcomes = List.map outcome found; chosen = !chosen; interrupted = !bound = Interruption }
