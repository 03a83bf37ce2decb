open Scc_ctl
open Scc_exact
open Scc_property
open Scc_semantics
open Scc_evaluate
open Scc_state_space
module Graph = State_graph

(** {2 Facts} *)

let facts_at ?real context graph temporal (at : Scc_ctl.Positions.position) p =
  let standing () = Catalogue.decode (Network_lts.catalogue context) (Graph.tuple graph at.node) in
  let state = match real with Some state -> state | None -> standing () in
  let extent =
    if not (Scc_ctl.Positions.is_inside at) then Timeline.Instant
    else
      match Temporal.flow_choice temporal at.node with
      | None -> Timeline.Forever
      | Some k -> Lasts (Graph.duration graph (Graph.edges graph at.node).(k))
  in
  let tuple = Graph.tuple graph at.node in
  let arrived event = Network_lts.arrived context event tuple in
  let time_seen = Catalogue.time_seen (Network_lts.catalogue context) in
  let later_than = Option.bind state.time (Time_seen.beyond time_seen) in
  let known = Network_lts.keeps context (Graph.tuple graph at.node) in
  Facts.at ?later_than ~known ~arrived (Network_lts.semantics context) state extent at.offset
    (Temporal.predicate temporal p)

let rec given (e : Explanation.t) =
  match (e.formula, e.because) with
  | Predicate p, Given -> [ (p, e.position) ]
  | _, Parts parts -> List.concat_map given parts
  | _, (Given | Run _ | Everywhere _ | Likelihood _) -> []

let rec is_state (f : Scc_ctl.Timed_formula.t) =
  match f with
  | Predicate _ -> true
  | Not f -> is_state f
  | And fs | Or fs -> List.for_all is_state fs
  | Next _ | Finally _ | Globally _ | Until _ -> false

let has_run e = Option.is_some (Explanation.chain e)
let leads_on e = match Explanation.chain e with Some run -> Explanation.goes_on run | None -> false

(* The last run of the chain, and the explanations where it leads. *)
let rec last_run (e : Explanation.t) =
  match e.because with
  | Given | Everywhere _ | Likelihood { run = None; _ } -> None
  | Likelihood { run = Some (run, _); parts; _ } -> Some (run, parts, None)
  | Parts parts -> Option.bind (List.find_opt has_run parts) last_run
  | Run { run; parts; along; _ } -> (
      match (Scc_ctl.Run.goal run, List.find_opt has_run parts) with
      | Some _, Some part when leads_on part -> last_run part
      | _ -> Some (run, parts, along))

(* Where the run enters a state, rather than on the way to the next. *)
let last stretches =
  let entered, inside =
    List.partition
      (fun (s : Explanation.stretch) -> not (Scc_ctl.Positions.is_inside s.place.position))
      (List.rev stretches)
  in
  List.nth_opt (entered @ inside) 0

(* Of a run without a goal it is told what was so at its last position, if that is what it goes on without: of one
   that passes a bound, where the bound is met. *)
let on_the_way_of (run : Scc_ctl.Run.t) (along : Explanation.along option) =
  let at_bound left (p, (at : Scc_ctl.Positions.position)) =
    (p, if Scc_ctl.Positions.is_inside at then { at with offset = left } else at)
  in
  match along with
  | Some { claim; stretches; _ } when is_state claim -> (
      match (run.finish, last stretches, List.rev stretches) with
      | Passes left, _, { why; _ } :: _ -> List.map (at_bound left) (given (Lazy.force why))
      | _, Some { why; _ }, _ -> given (Lazy.force why)
      | _, None, _ -> [])
  | Some _ | None -> []

(* Where one run shows a probability, it leads to a real state, for which that of the graph stands. *)
let facts context graph temporal ~last e =
  let real =
    match e.Explanation.because with
    | Likelihood { parts; _ } when not (List.exists has_run parts) -> Some last
    | Given | Parts _ | Run _ | Everywhere _ | Likelihood _ -> None
  in
  let told = List.concat_map (fun (p, at) -> facts_at ?real context graph temporal at p) in
  match last_run e with
  | None -> []
  | Some (run, parts, along) ->
    (match Scc_ctl.Run.goal run with
     | None -> told (on_the_way_of run along)
     | Some _ ->
       let at_goal (part : Explanation.t) =
         match part.because with
         | Run { run; along; _ } -> on_the_way_of run along
         | Given | Parts _ | Everywhere _ | Likelihood _ -> given part
       in
       Scc_data.Lists.distinct String.equal (told (List.concat_map at_goal parts)))

(** {2 The tree} *)

(* The real state in which a run begins, if names differ between it and the state of the graph that stands for it.
*)
type here = Scc_calculus.State.t option

let steps_of temporal (run : Scc_ctl.Run.t) = List.map (Temporal.choice temporal) run.steps

(* The real state after so many steps of a run. *)
let after context graph temporal (here : here) (run : Scc_ctl.Run.t) count : here =
  let go state =
    let steps = List.filteri (fun i _ -> i < count) (steps_of temporal run) in
    (Followed.along context graph (Followed.from state) steps).last
  in
  Option.map go here

let at_end context graph temporal here (run : Scc_ctl.Run.t) =
  after context graph temporal here run (List.length run.steps)

let labels context graph temporal (here : here) (run : Scc_ctl.Run.t) =
  let steps = steps_of temporal run in
  match here with
  | None ->
    let catalogue = Network_lts.catalogue context in
    let labels (s : Graph.step) =
      match Catalogue.single catalogue (Graph.edges graph s.source).(s.choice).label with
      | Some label -> [ label ]
      | None ->
        let source = Catalogue.decode catalogue (Graph.tuple graph s.source) in
        let draws = (Followed.along context graph (Followed.from source) [ s ]).steps in
        List.rev_map (fun (s : Witness.step) -> s.transition.label) draws
    in
    List.concat_map labels steps
  | Some state ->
    List.rev_map
      (fun (s : Witness.step) -> s.transition.label)
      (Followed.along context graph (Followed.from state) steps).steps

(* Passing time is told by the clock alone. *)
let event context (label : Transition.label) =
  match label with
  | Time _ -> None
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ ->
    Some (Transition.label_to_string (Network_lts.model context) label)

(* What happens on a run, seen from where it starts. *)
let story context graph temporal here (run : Scc_ctl.Run.t) =
  let start = Algebraic.to_rat run.start.offset in
  let clock, events =
    List.fold_left
      (fun (clock, events) label ->
         let clock = Rat.add clock (Transition.duration_of label) in
         match event context label with
         | None -> (clock, events)
         | Some e -> (clock, Printf.sprintf "%s after %s" e (Rat.to_string clock) :: events))
      (Rat.neg (Option.value start ~default:Rat.zero), [])
      (labels context graph temporal here run)
  in
  (clock, List.rev events)

let most = 12

let listed events =
  let shown = List.filteri (fun i _ -> i < most) events in
  let more = List.length events - List.length shown in
  let rest = if more > 0 then [ Printf.sprintf "%d events more" more ] else [] in
  match shown @ rest with [] -> [] | lines -> [ String.concat "; " lines ]

(* A run that repeats its steps from [k] on, at a time since it began; [silent]: of these none is an event. *)
let going_round k ~silent clock =
  match (k, silent) with
  | 0, true -> "nothing else happens, for ever"
  | 0, false -> "the run then repeats all of this, for ever"
  | _, true -> Printf.sprintf "nothing else happens after time %s from here, for ever" (Rat.to_string clock)
  | _, false ->
    Printf.sprintf "the run then repeats what happens after time %s from here, for ever" (Rat.to_string clock)

let again context graph temporal here (run : Scc_ctl.Run.t) k =
  let first = { run with steps = List.filteri (fun i _ -> i < k) run.steps } in
  let clock, before = story context graph temporal here first and _, all = story context graph temporal here run in
  going_round k ~silent:(List.compare_lengths before all = 0) clock

let finish_text context graph temporal here (run : Scc_ctl.Run.t) clock =
  let at offset = Algebraic.to_string (Algebraic.add_rat clock offset) in
  match run.finish with
  | At_state when run.steps = [] -> "here"
  | At_state -> Printf.sprintf "in the state after time %s from here" (Rat.to_string clock)
  | During { moment; _ } when moment.attained -> Printf.sprintf "after time %s from here" (at moment.offset)
  | During { moment; sample } ->
    Printf.sprintf "right after time %s from here, for example after %s" (at moment.offset) (at sample)
  | Rests -> "the run then rests for ever"
  | Stops -> "the run then is over"
  | Repeats k -> again context graph temporal here run k
  | Passes left ->
    Printf.sprintf "the run then passes the bound of time, which ends after time %s from here" (at left)

(* Where something is on the way of a run, from where the run begins. *)
let instant_of (course : Course.t) (place : Course.place) offset =
  let start = Option.value (Algebraic.to_rat course.run.start.offset) ~default:Rat.zero in
  Algebraic.add_rat (Rat.sub place.clock start) offset

let time_of course place offset = Algebraic.to_string (instant_of course place offset)

let width = Rat.make Z.one (Z.pow (Z.of_int 10) 12)

let rational instant =
  match Algebraic.to_rat instant with
  | Some r -> r
  | None -> fst (Algebraic.enclose instant ~width)

let onward (course : Course.t option) (place : Course.place option) =
  match (course, place) with
  | None, _ | _, None -> "as this run goes on"
  | Some course, Some place ->
    let recurs = match course.again with Some k -> place.step >= course.places.(k).step | None -> false in
    let right = if Course.is_interval place then "right " else "" in
    Printf.sprintf "as this run goes on, %safter time %s of it%s" right (time_of course place place.low)
      (if recurs then ", and each time round" else "")

(* [course] is the run on whose way it is explained. *)
let because context graph temporal ~shown here course (e : Explanation.t) =
  match e.because with
  | Given -> (
      match e.formula with
      | Predicate p -> facts_at context graph temporal e.position p
      | _ -> [])
  | Parts _ -> []
  | Everywhere _ when Option.is_some course -> [ "all runs from there were looked at" ]
  | Everywhere (lazy 0) -> [ "nothing on the way says otherwise" ]
  | Everywhere (lazy 1) -> [ "the one state that counts from here on was looked at" ]
  | Everywhere (lazy n) -> [ Printf.sprintf "all %d states that count from here on were looked at" n ]
  | Likelihood { side; measured; _ } when shown -> [ Likelihoods.known side measured ]
  | Likelihood { side; measured; run; _ } ->
    Likelihoods.known side measured
    :: List.concat_map
      (fun (run, chance) ->
         let clock, events = story context graph temporal here run in
         Likelihoods.of_run chance :: (listed events @ [ finish_text context graph temporal here run clock ]))
      (Option.to_list run)
  | Run { way = Onward place; _ } -> [ onward course place ]
  | Run { run; _ } ->
    let clock, events = story context graph temporal here run in
    listed events @ [ finish_text context graph temporal here run clock ]

(* That "not p" fails is told as that p holds. *)
let affirmed temporal (e : Explanation.t) =
  match (Skeleton.to_temporal (Temporal.predicate temporal) e.formula, e.because) with
  | State (Not p), Given -> (Property.State p, not e.holds)
  | formula, _ -> (formula, e.holds)

(* What a fact says that a claim does not. *)
let beyond claim holds fact =
  let start = claim ^ if holds then " holds" else " fails" in
  let n = String.length start and m = String.length fact in
  if m < n || not (String.equal (String.sub fact 0 n) start) then Some fact
  else if m = n then None
  else if m > n + 2 && fact.[n] = ':' then Some (String.sub fact (n + 2) (m - n - 2))
  else Some fact

(* How many reasons are looked for on the way of a run, and how many are told: of a run on the way of another it
   is one. *)
let searched = 8
let told depth = if depth = 0 then 3 else 1

let rec is_searched (e : Explanation.t) =
  match e.because with
  | Run { way = Own; _ } -> true
  | Parts parts -> List.exists is_searched parts
  | Given | Everywhere _ | Likelihood _ | Run { way = Onward _; _ } -> false

(* When a run is where it leads, by the time since its start, if it leads somewhere. *)
let end_of context graph temporal here (run : Scc_ctl.Run.t) =
  let clock, _ = story context graph temporal here run in
  match run.finish with
  | At_state -> Some clock
  | During { moment; sample } ->
    let offset = if moment.attained then moment.offset else sample in
    Some (rational (Algebraic.add_rat clock offset))
  | Rests | Stops | Repeats _ | Passes _ -> None

(* [shown]: a run of this claim is the one that the witness shows. [at]: the time on the shown run that the claim
   is about, if it is on that one. [here]: the real state at the position of the explanation, or before it in the
   flow. [course]: the run on whose way it is explained, with the real state in which that one begins. *)
let rec tree context graph temporal ~shown ~at ~depth here course (e : Explanation.t) : Witness.argument =
  let tree_of = tree context graph temporal ~shown:false ~depth in
  let end_ run = if shown then end_of context graph temporal here run else None in
  let parts =
    match e.because with
    | Given | Everywhere _ -> []
    | Parts parts -> List.map (tree_of ~at here course) parts
    | Likelihood { run; parts; _ } ->
      let there = Option.bind run (fun (run, _) -> end_ run) in
      let here = Option.fold ~none:here ~some:(fun (run, _) -> at_end context graph temporal here run) run in
      List.map (tree_of ~at:there here None) parts
    | Run { run; parts; along; way } ->
      let on = match way with Own -> None | Onward _ -> course in
      let told = Option.bind along (on_the_way context graph temporal ~shown ~depth here) in
      List.map (tree_of ~at:(end_ run) (at_end context graph temporal here run) on) parts @ Option.to_list told
  in
  let formula, holds = affirmed temporal e in
  let claim = Show.temporal (Network_lts.model context) formula in
  let because = because context graph temporal ~shown here (Option.map fst course) e in
  let because = List.filter_map (beyond claim holds) because in
  { where = None; time = at; claim; holds; because; parts }

(* What is so on the way of a run, when it takes more than a look at each position. *)
and on_the_way context graph temporal ~shown ~depth here (along : Explanation.along) =
  let tree_of ~at (place : Course.place) =
    let there = after context graph temporal here along.course.run place.step in
    tree context graph temporal ~shown:false ~depth:(depth + 1) there (Some (along.course, here)) ~at
  in
  (* Reasons that differ, each with the first place that it is told of: without times, so that they are seen to be
     the same. *)
  let rec reasons found left = function
    | [] -> (List.rev found, 0)
    | rest when left = 0 -> (List.rev found, List.length rest)
    | (s : Explanation.stretch) :: rest ->
      let why = Lazy.force s.why in
      let found = note (s.place, why) (tree_of ~at:None s.place why) found in
      reasons found (if is_searched why then left - 1 else left) rest
  and note place argument = function
    | [] -> [ (place, argument) ]
    | ((_, a) :: _) as found when Witness.equal_arguments a argument -> found
    | first :: rest when List.exists (fun (_, a) -> Witness.equal_arguments a argument) rest -> first :: rest
    | found -> (place, argument) :: found
  in
  match along.stretches with
  | [] -> None
  | _ when is_state along.claim -> None
  | stretches -> (
      match reasons [] (if depth = 0 then searched else 1) stretches with
      | [ (_, argument) ], 0 -> Some { argument with where = Some (everywhere along) }
      | reasons, _ ->
        let formula = Skeleton.to_temporal (Temporal.predicate temporal) along.claim in
        let part (((place : Course.place), why), _) =
          let at = time_of along.course place in
          let where =
            if Course.is_interval place then
              Printf.sprintf "right after time %s of this run, for example after %s" (at place.low)
                (at place.position.offset)
            else Printf.sprintf "after time %s of this run" (at place.low)
          in
          let instant = instant_of along.course place place.position.offset in
          let at = if shown then Some (rational instant) else None in
          { (tree_of ~at place why) with where = Some where }
        in
        let first = List.filteri (fun i _ -> i < told depth) reasons in
        Some
          {
            where = Some (everywhere along);
            time = None;
            claim = Show.temporal (Network_lts.model context) formula;
            holds = along.claimed;
            because = [ "each place has its reason, for example" ];
            parts = List.map part first;
          })

and everywhere (along : Explanation.along) =
  match (along.course.run.finish, along.course.places) with
  | (At_state | During _), _ -> "all the way"
  | (Rests | Stops | Repeats _ | Passes _), places ->
    let some = List.compare_length_with along.stretches (Array.length places) < 0 in
    if some then "everywhere on this run in that time"
    else "everywhere on this run"

let rec is_plain (e : Explanation.t) =
  match e.because with
  | Given -> true
  | Everywhere _ | Run _ | Likelihood _ -> false
  | Parts parts -> List.for_all is_plain parts

(* Of the initial state. *)
let argument context graph temporal (e : Explanation.t) =
  let here = if Network_lts.names_differ context then Some (Network_lts.start context) else None in
  let tree = tree context graph temporal ~at:(Some Rat.zero) ~depth:0 here None in
  let is_told (a : Explanation.along) = is_state a.claim || a.stretches = [] in
  match e.because with
  | Run { parts; along; _ }
    when List.for_all is_plain parts && Option.fold ~none:true ~some:is_told along -> None
  | Run _ | Likelihood _ -> Some (tree ~shown:true e)
  | Given | Parts _ | Everywhere _ -> Some (tree ~shown:false e)
