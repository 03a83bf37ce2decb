open Scc_calculus

(* {1 Putting together} *)

type 'a discrete = { urgent : 'a list; weak : 'a list; collisions : 'a list }

let is_urgent d = match (d.urgent, d.collisions) with [], [] -> false | _ -> true

let rec before f later = function
  | [] -> later
  | last :: rest -> before f (f last :: later) rest

let in_order f d ~time =
  let later = if is_urgent d then [] else time () in
  before f (before f (before f later d.collisions) d.weak) d.urgent

let time_rules (c : Semantics.t) =
  let (module K) = c.kinematics in
  K.time_rules

(* {1 Steps} *)

let finish (c : Semantics.t) ?(fired = []) label rules target =
  let* settled = Steer.settle c target in
  Ok
    {
      Transition.label;
      rules = rules @ settled.rules;
      fired;
      target = settled.state;
      chance = (if Transition.is_drawn label then Some (Transition.chance label) else None);
      rounded = settled.rounded;
    }

(* A collision ends the movement step, unless this instant has been steered already, or steps keep their beat. *)
let after_collision m (step : State.step option) =
  let next : State.phase -> State.phase = function
    | Moving when Model.keeps_beat m -> Moving
    | Moving | Due -> Due
    | Steered -> Steered
  in
  Option.map (fun (s : State.step) -> { s with phase = next s.phase }) step

(* {1 Transitions} *)

(* An outcome as a transition of the whole network, with its deed where ties are drawn (rule Ties). *)
let happens c (s : State.t) ~step (o : Transition.outcome) =
  let target = State.at ~step ~time:s.time (State.exchange ~gone:o.gone ~come:o.come s) in
  let is_tied = Model.draws_ties (Semantics.model c) && Transition.is_urgent o.label in
  let deed = if is_tied then Some (Ties.deed o) else None in
  Result.map (fun t -> (deed, t)) (finish c ~fired:o.fired o.label (Transition.rules o) target)

let last_first lists = List.fold_left (fun all list -> List.rev_append list all) [] lists

let urgent (c : Semantics.t) p =
  c.memo.urgent p (fun () ->
      Transition.distinct (List.rev_append (List.rev (Splits.strong c p)) (Closings.all c p)))

let weak (c : Semantics.t) p = c.memo.weak p (fun () -> Transition.distinct (Splits.weak c p))

let collision (c : Semantics.t) processes (cluster : Collisions.cluster) =
  let look () = Result.map Transition.distinct (Collisions.outcomes c processes cluster) in
  match cluster.members with
  | [ i; j ] -> c.memo.collision processes.(i) processes.(j) look
  | _ -> look ()

let of_single c (s : State.t) kind =
  List.map (fun p -> List.map (happens c s ~step:s.step) (kind c p)) (Array.to_list s.processes) |> last_first

let collisions c (s : State.t) =
  let step = after_collision (Semantics.model c) s.step in
  let resolved cluster =
    match collision c s.processes cluster with
    | Error fault -> [ Error fault ]
    | Ok outcomes -> List.map (happens c s ~step) outcomes
  in
  List.map resolved (Collisions.clusters c s.processes) |> last_first

let passes c d s = finish c (Transition.Time d) (time_rules c) (Time.pass c d s)

let time c s () =
  match Time.delay c s with
  | None -> []
  | Some d -> [ passes c d s ]

let draw_rules = [ Rule.Draw ]

let drawn c s ~before p (given, chance) =
  let of_one q = if q == p then Some given else before q in
  finish c (Steer.draw_label p (given, chance)) draw_rules (Steer.drawn of_one s)

let draws c s p =
  let* chances = Steer.chances c s p in
  Result.all (drawn c s ~before:(fun _ -> None) p) chances

let lots c (s : State.t) due =
  let* outcomes = Splits.lots c due in
  Result.map (List.map snd) (Result.all (happens c s ~step:s.step) outcomes)

let tied transitions =
  let odds = Ties.odds (List.filter_map fst transitions) in
  let by_chance (deed, (t : Transition.t)) =
    match deed with None -> t | Some deed -> { t with chance = odds deed }
  in
  List.map by_chance transitions

let events_and_time c s =
  let time () = List.map (Result.map (fun t -> (None, t))) (time c s ()) in
  { urgent = of_single c s urgent; weak = of_single c s weak; collisions = collisions c s }
  |> in_order Fun.id ~time
  |> Result.all Fun.id
  |> Result.map tied

let successors c s =
  match (Lots.due (Semantics.model c) s, Steer.next_to_draw c s) with
  | Some due, _ -> lots c s due
  | None, Some p -> draws c s p
  | None, None -> events_and_time c s

let within c s d =
  match (Semantics.model c).splits with
  | Every _ -> false
  | Any_time -> (
      Scc_exact.Rat.sign d > 0
      && match Time.delay c s with None -> true | Some greatest -> Scc_exact.Rat.compare d greatest < 0)

let wait c s d =
  let urgent () = is_urgent { urgent = of_single c s urgent; weak = []; collisions = collisions c s } in
  let drawing () = Option.is_some (Steer.next_to_draw c s) in
  if (not (within c s d)) || drawing () || urgent () then Ok None else Result.map Option.some (passes c d s)

let together c processes =
  let sure = function
    | Ok outcomes -> outcomes
    | Error _ -> Scc_base.Bug.fail __POS__ "a persistent contact in translation"
  in
  List.concat_map (fun cluster -> sure (collision c processes cluster)) (Collisions.clusters c processes)

let quiescent c (s : State.t) =
  Option.is_none (Steer.next_to_draw c s)
  && (not (Lots.pending s))
  && Array.for_all (fun p -> urgent c p = [] && Option.is_none p.State.clock) s.processes
  && (not (Collisions.collides c s))
  && Option.is_none (Time.delay c s)

let started (c : Semantics.t) (declared : State.t) =
  let (module K) = c.kinematics in
  let m = c.setting.model in
  let step =
    if Model.of_all m then Some { State.remaining = m.timestep; phase = State.Due } else None
  in
  let time = if m.keeps_time then Some Scc_exact.Rat.zero else None in
  let start p = Lots.start m @@ Process.restart_step m (K.start c.setting (Process.restart_clock m p)) in
  let processes = List.map start (Array.to_list declared.processes) in
  State.make ~processes ~step ~time

let initial c declared = Result.map (fun (o : Steer.outcome) -> o.state) (Steer.settle c (started c declared))
