open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_ctl
open Scc_evaluate
open Scc_engine
open Scc_runs

type plan = {
  semantics : Semantics.t;
  declared : State.t;
  goal : Property.prop;
  horizon : Rat.t option;
  levels : Property.prop list;
  effort : int;
  steps : int;
}

type repetition = { passed : int list; undecided : int; interrupted : bool }

let rec state_formula : Property.temporal -> Property.prop option = function
  | State p -> Some p
  | Temporal_not f -> Option.map Formula.negate (state_formula f)
  | Temporal_and fs -> Option.map (fun ps -> Property.And ps) (Option.all state_formula fs)
  | Temporal_or fs -> Option.map (fun ps -> Property.Or ps) (Option.all state_formula fs)
  | Next _ | Finally _ | Globally _ | Until _ -> None

let goal (path : Path.t) =
  match (path.question, path.formula) with
  | Does, Finally (_, { low; high }, f) when Rat.sign low = 0 ->
    Option.map (fun goal -> (goal, high)) (state_formula f)
  | (Does | Amounts _), _ -> None

(* {1 From one level to the next} *)

(* Where a run has passed a level. *)
type place = { at : State.t; time : Rat.t; final : bool  (** the goal is reached *) }

type outcome = Passed of place | Failed | Left

let never _ = false

let truth_at plan ?(arrived = never) state p =
  (Trajectory.prop (Trajectory.make ~arrived plan.semantics state Timeline.Instant) p).start

let at_instant plan ?arrived state p = Truth.equal True (truth_at plan ?arrived state p)

(* Time that is left for the goal. *)
let left plan time = Option.map (fun h -> Rat.sub h time) plan.horizon
let in_time plan time = match left plan time with Some d -> Rat.sign d >= 0 | None -> true

(* Whether the goal comes while time passes, strictly after its start and before its end. *)
let on_the_way plan state time extent : Truth.t =
  let truth = Trajectory.prop (Trajectory.make plan.semantics state extent) plan.goal in
  match Timeline.first_after_start (fun t -> not (Truth.equal False t)) truth with
  | None -> False
  | Some ({ offset; attained } as moment) ->
    let too_late =
      match left plan time with
      | None -> false
      | Some d ->
        let c = Algebraic.compare_rat offset d in
        c > 0 || (c = 0 && not attained)
    in
    if too_late then False else Timeline.at truth (Timeline.sample truth moment)

let reached plan ?arrived state time : Truth.t =
  if in_time plan time then truth_at plan ?arrived state plan.goal else False

(* Follows a run until it passes [level], which may be the goal itself. *)
let follow plan run level place ~interrupted g =
  let at_goal at time = Passed { at; time; final = true } in
  let rec go time steps g =
    if steps >= plan.steps || interrupted () then (Left, g)
    else if not (in_time plan time) then (Failed, g)
    else
      match Run.labels run with
      | Error _ -> (Left, g)
      | Ok { count = 0; _ } ->
        let state = Run.state run in
        let for_ever : Truth.t = if Run.quiescent run then on_the_way plan state time Forever else False in
        ((match for_ever with True -> at_goal state time | False -> Failed | Undecided _ -> Left), g)
      | Ok labels -> take labels time steps g
  and take labels time steps g =
    let index, g = Replay.at_random labels g in
    let label = labels.label index and free = Replay.is_free labels index in
    let source = lazy (Run.state run) in
    (* By a draw nothing happens. *)
    if not (Transition.is_drawn label) then ignore (Lazy.force source);
    let d = Transition.duration_of label in
    let passing : Truth.t =
      if Rat.sign d > 0 && not free then on_the_way plan (Lazy.force source) time (Lasts d) else False
    in
    match passing with
    | _ when free -> (Left, g)
    | Undecided _ -> (Left, g)
    | True -> (at_goal (Lazy.force source) time, g)
    | False ->
      let taken = Run.take run index in
      let time = Rat.add time d in
      if Transition.is_drawn taken.label && Run.draws_on run then go time steps g
      else
        let state = Run.state run and drawn = Transition.is_drawn label in
        let arrived event = (not drawn) && Event.matches ~source:(Lazy.force source) label event in
        match reached plan ~arrived state time with
        | True -> (at_goal state time, g)
        | Undecided _ -> (Left, g)
        | False ->
          if Option.fold ~none:false ~some:(at_instant plan ~arrived state) level then
            (Passed { at = state; time; final = false }, g)
          else go time (steps + 1) g
  in
  go place.time 0 g

let targets plan = List.map Option.some plan.levels @ [ None ]

(* {1 Repetitions} *)

let from plan level places ~interrupted g =
  let start g =
    match places with
    | None -> (
        match Run.start plan.semantics plan.declared with
        | Error _ -> (Left, g)
        | Ok run ->
          let place = { at = plan.declared; time = Rat.zero; final = false } in
          follow plan run level place ~interrupted g)
    | Some places ->
      let i, g = Splitmix64.below (Array.length places) g in
      if places.(i).final then (Passed places.(i), g)
      else follow plan (Run.resume plan.semantics places.(i).at) level places.(i) ~interrupted g
  in
  let rec go n passed left g =
    if n = 0 then (List.rev passed, left, g)
    else
      match start g with
      | Passed place, g -> go (n - 1) (place :: passed) left g
      | Failed, g -> go (n - 1) passed left g
      | Left, g -> go (n - 1) passed (left + 1) g
  in
  go plan.effort [] 0 g

let repeat plan ~seed ~interrupted number =
  let rec go targets places counts left g =
    match targets with
    | [] -> (List.rev counts, left)
    | level :: rest ->
      let passed, more, g = from plan level places ~interrupted g in
      let counts = List.length passed :: counts and left = left + more in
      if passed = [] then (List.rev_append counts (List.map (fun _ -> 0) rest), left)
      else go rest (Some (Array.of_list passed)) counts left g
  in
  let g = Splitmix64.of_seed (Scc_simulate.Simulation.seed_of seed number) in
  let passed, undecided = go (targets plan) None [] 0 g in
  { passed; undecided; interrupted = interrupted () }

let estimate plan r =
  let share n = Rat.make (Z.of_int n) (Z.of_int plan.effort) in
  List.fold_left (fun product n -> Rat.mul product (share n)) Rat.one r.passed

let holds_at_start plan =
  match Network.initial plan.semantics plan.declared with
  | Error _ -> None
  | Ok state ->
    let rec first i = function
      | [] -> None
      | p :: rest -> if at_instant plan state p then Some i else first (i + 1) rest
    in
    first 0 (plan.levels @ [ plan.goal ])

(* {1 Together} *)

type summary = {
  repetitions : int;
  mean : Rat.t;
  low : Rat.t;
  high : Rat.t;
  assumed : Rat.t;
  likely : Rat.t;
  shares : (int * int) list;
  left : int;
}

(* Runs from a level are made in repetitions in which some have come there. *)
let shares plan repetitions =
  let add totals r =
    let come = plan.effort :: List.map (fun n -> if n > 0 then plan.effort else 0) r.passed in
    let come = List.filteri (fun i _ -> i < List.length r.passed) come in
    List.map2 (fun (passed, all) (n, of_all) -> (passed + n, all + of_all)) totals (List.combine r.passed come)
  in
  List.fold_left add (List.map (fun _ -> (0, 0)) (targets plan)) repetitions

(* A repetition that was cut off counts as 0 at the lower end, and as 1 at the upper one. Where a run was left, the
   estimate is that of a lesser probability, and there is no upper end. *)
let summary plan repetitions ~confidence =
  let whole, cut = List.partition (fun r -> not r.interrupted) repetitions in
  let found = List.map (estimate plan) whole and left = List.fold_left (fun n r -> n + r.undecided) 0 whole in
  if found = [] then None
  else begin
    let runs = List.length whole in
    let greatest = List.fold_left Rat.max Rat.zero found in
    let miss = Rat.mul Rat.half (Rat.sub Rat.one confidence) in
    let lower ~runs distance =
      let value x =
        let d = distance x in
        if Rat.sign d > 0 then Some (d, 1) else None
      in
      Betting.lower (List.filter_map value found) ~runs ~miss
    in
    let upper ~runs limit = if left > 0 then Rat.one else Rat.sub limit (lower ~runs (Rat.sub limit)) in
    let all = runs + List.length cut in
    let high = upper ~runs:all Rat.one in
    let assumed = Rat.min Rat.one (Rat.mul (Rat.of_int 2) greatest) in
    Some
      {
        repetitions = runs;
        mean = Rat.div (List.fold_left Rat.add Rat.zero found) (Rat.of_int runs);
        low = lower ~runs:all Fun.id;
        high;
        assumed;
        likely = (if Rat.sign assumed = 0 then high else Rat.min high (upper ~runs assumed));
        shares = shares plan whole;
        left;
      }
  end

(* {1 Levels} *)

let refused why =
  Error [ Diag.error Code.type_mismatch Span.command_line "%s" why ~hint:"as in `--levels 'x(p) >= 1, 2, 3'`" ]

let most_levels = 1_000

let too_many =
  Error [ Diag.error Code.type_mismatch Span.command_line "more than %d levels are given" most_levels ]

(* A range of integers stands for each of them; what is no such range is read as an expression, later. *)
let thresholds text =
  let whole (s : string) = int_of_string_opt (String.trim s) in
  let one part =
    let part = String.trim part in
    match String.index_opt part '.' with
    | Some i when i + 1 < String.length part && part.[i + 1] = '.' -> (
        match (whole (String.sub part 0 i), whole (String.sub part (i + 2) (String.length part - i - 2))) with
        | Some a, Some b when b < a -> refused (Printf.sprintf "the range %s of levels is empty" part)
        | Some a, Some b when b - a >= most_levels -> too_many
        | Some a, Some b -> Ok (List.init (b - a + 1) (fun k -> string_of_int (a + k)))
        | _ -> Ok [ part ])
    | _ -> Ok [ part ]
  in
  let* values = Result.map List.concat (Result.all one (String.split_on_char ',' text)) in
  if List.compare_length_with values most_levels > 0 then too_many else Ok values

let rec in_order relation = function
  | a :: (b :: _ as rest) -> (
      match (Rat.of_literal a, Rat.of_literal b) with
      | Ok x, Ok y ->
        let c = Rat.compare x y in
        if (if relation = '>' then c < 0 else c > 0) then in_order relation rest
        else if Rat.equal x y then refused (Printf.sprintf "level %s is given twice" (String.trim b))
        else refused (Printf.sprintf "levels are not in order: %s comes before %s" (String.trim a) (String.trim b))
      | _ -> in_order relation rest)
  | [ _ ] | [] -> Ok ()

let levels text =
  let rec last i = if i < 0 then None else match text.[i] with '<' | '>' -> Some i | _ -> last (i - 1) in
  match last (String.length text - 1) with
  | None -> refused "levels are a number, a comparison, and the values that it passes one after the other"
  | Some i ->
    let n = String.length text in
    let after = if i + 1 < n && text.[i + 1] = '=' then i + 2 else i + 1 in
    let* values = thresholds (String.sub text after (n - after)) in
    let* () = in_order text.[i] values in
    Ok (List.map (fun value -> String.sub text 0 after ^ " " ^ String.trim value) values)
