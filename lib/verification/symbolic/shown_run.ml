open Scc_exact
open Scc_polyhedra
open Scc_property
open Timed_sets
open Run_search
open Scc_state_sets

type finish = Run_search.finish = There | Rests | Passes of Rat.t | Repeats of int | Goes_on of int

type spot = { steps : int; since : Rat.t option }

let equal_spots a b = Int.equal a.steps b.steps && Option.equal Rat.equal a.since b.since

type along = { what : Property.temporal; so : bool; bound : Property.bound }

type claim = { formula : Property.temporal; holds : bool; spot : spot; because : because }

and because =
  | Given
  | Everywhere
  | Parts of claim list
  | Run of { finish : finish; until : spot; goal : spot; along : along option; parts : claim list }

type t = { run : Concrete.t; finish : finish; claim : claim }

(* {1 Reasons}

   With forms for the times since the steps, until the run is chosen. *)

type 'time claimed = { formula : Property.temporal; holds : bool; spot : int * 'time option; why : 'time why }

and 'time why =
  | Known
  | All_runs
  | Of of 'time claimed list
  | By of {
      finish : finish;
      until : int * 'time option;
      goal : int * 'time option;
      along : along option;
      parts : 'time claimed list;
    }

let spot w = (steps w, Option.map snd w.inside)
let always = { Property.low = Rat.zero; high = None }
let is_state f = Option.is_some (Formula.state_formula f)

(* What is so on the way of a run of such a formula, and where it leads; the third way to break an until is where
   it is over on an open interval. *)
let told (f : Property.temporal) search =
  let along bound what so = Some { what; so; bound } in
  let stays bound what so = (along bound what so, [], bound) in
  match (f, (search : Branching.search)) with
  | Finally (Exists, _, g), _ -> (None, [ (g, true) ], always)
  | Globally (All, _, g), _ -> (None, [ (g, false) ], always)
  | Finally (All, b, g), _ -> stays b g false
  | Globally (Exists, b, g), _ -> stays b g true
  | Until (Exists, _, f, g), _ -> (along always f true, [ (g, true) ], always)
  | Until (All, b, _, g), Stays _ -> stays b g false
  | Until (All, b, f, g), (Comes _ | Leads _) -> (along b g false, [ (f, false) ], b)
  | Next (Exists, g), _ -> (None, [ (g, true) ], always)
  | Next (All, g), _ -> (None, [ (g, false) ], always)
  | ( ( State _ | Temporal_not _ | Temporal_and _ | Temporal_or _ | Next (Chance _, _) | Finally (Chance _, _, _)
      | Globally (Chance _, _, _) | Until (Chance _, _, _, _) ),
      _ ) ->
    Scc_base.Bug.fail __POS__ "no operator that a run decides"

(* A run that only waits in the stretch that it is in is not worth showing: the instant is. *)
let goes_on (from : walk) (to_ : walk) =
  from.inside = None || steps to_ > steps from

(* A walk, with all that was chosen for a longer one. *)
let as_far_as (w : walk) (longer : walk) =
  let way = Concrete.extend w.way (dimension longer - dimension w) in
  { w with way = { way with set = longer.way.set } }

let rec explain b ~outermost w (formula : Property.temporal) holds =
  let claim w0 why = { formula; holds; spot = spot w0; why } in
  match (Formula.state_formula formula, formula) with
  | Some _, _ -> (w, None, claim w Known)
  | None, Temporal_not f ->
    let next, finish, part = explain b ~outermost w f (not holds) in
    (next, finish, claim w (Of [ part ]))
  | None, (Temporal_and fs | Temporal_or fs) ->
    let conjunction = match formula with Temporal_and _ -> true | _ -> false in
    let is_so f w = among (Branching.truth b ~outermost f ~holds) w in
    if Bool.equal conjunction holds then
      let next, finish, parts = all b ~outermost w (List.map (fun f -> (f, holds)) fs) in
      (next, finish, claim w (Of parts))
    else
      let one f = match is_so f w with w :: _ -> Some (f, w) | [] -> None in
      (match List.find_map one fs with
       | None -> Scc_base.Bug.fail __POS__ "no part of what is so is so"
       | Some (f, w) ->
         let next, finish, part = explain b ~outermost w f holds in
         (next, finish, claim w (Of [ part ])))
  | None, _ -> (
      match Branching.quantified b ~outermost formula with
      | Some q when Bool.equal q.holds_if_any holds -> by_run b w formula holds q
      | Some _ | None -> (w, None, claim w All_runs))

(* All of them are so: the run is that of the first that has one. *)
and all b ~outermost w claims =
  let rec go w found = function
    | [] -> (w, None, List.rev found)
    | (f, holds) :: rest -> (
        let next, finish, first = explain b ~outermost w f holds in
        match finish with
        | None -> go w (first :: found) rest
        | Some _ ->
          let stated (f, holds) =
            { formula = f; holds; spot = spot w; why = (if is_state f then Known else All_runs) }
          in
          (next, finish, List.rev_append found (first :: List.map stated rest)))
  in
  go w [] claims

and by_run b w formula holds (q : Branching.quantified) =
  let m = Branching.model b in
  let of_search (search, win) =
    let along, parts, bound = told formula search in
    let from w = Option.map (fun r -> (search, along, parts, r)) (some_run m search ~win ~high:bound.high w) in
    List.find_map from (among win w)
  in
  match List.find_map of_search q.searches with
  | None -> (w, None, { formula; holds; spot = spot w; why = All_runs })
  | Some (search, along, parts, (reached, finish)) ->
    let last, more, parts =
      match search with
      | Branching.Comes _ | Leads _ -> goal_parts b reached formula parts
      | Stays _ -> (reached, None, [])
    in
    let goal = match parts with first :: _ -> first.spot | [] -> spot reached in
    let why = By { finish; until = spot reached; goal; along; parts } in
    let last, finish =
      match more with
      | None -> (last, finish)
      | Some more -> if goes_on reached last then (last, more) else (as_far_as reached last, finish)
    in
    (last, Some finish, { formula; holds; spot = spot w; why })

(* f U g broken: f fails at the goal, and g too, or it is no time for it; or g begins right after it, in time,
   while f does not hold. *)
and goal_parts b w formula parts =
  match formula with
  | Until (All, bound, f, g) -> (
      let m = Branching.model b in
      let fails f = Branching.truth b ~outermost:false f ~holds:false in
      match among (fails f) w with
      | over :: _ -> (
          match among (fails g) over with
          | both :: _ -> all b ~outermost:false both [ (f, false); (g, false) ]
          | [] -> all b ~outermost:false over [ (f, false) ])
      | [] -> (
          let in_time = Branching.truth b ~outermost:false (Branching.in_bound bound g) ~holds:true in
          let up_to = map2 inter (fails f) in_time in
          match right_after m up_to w with
          | after :: _ -> all b ~outermost:false after [ (f, false) ]
          | [] -> (w, None, [])))
  | _ -> all b ~outermost:false w parts

(* {1 One of them} *)

let rec concrete value count claimed =
  let spot (steps, since) = { steps = count steps; since = Option.map value since } in
  let because =
    match claimed.why with
    | Known -> Given
    | All_runs -> Everywhere
    | Of parts -> Parts (List.map (concrete value count) parts)
    | By { finish; until; goal; along; parts } ->
      let parts = List.map (concrete value count) parts in
      Run { finish = counted count finish; until = spot until; goal = spot goal; along; parts }
  in
  { formula = claimed.formula; holds = claimed.holds; spot = spot claimed.spot; because }

and counted count = function
  | (There | Rests | Passes _) as f -> f
  | Repeats k -> Repeats (count k)
  | Goes_on k -> Goes_on (count k)

let choose (root : Zone.t) (w : walk) finish claimed =
  let of_point point =
    let value f = Linear.eval (Concrete.extended (Array.length point) f) point in
    let step (step, time) : Concrete.step option =
      match ((step : Zone_steps.step), Option.map value time) with
      | Happens label, _ -> Some (Happens label)
      | Passes _, Some t -> Some (Passes t)
      | Passes_some, Some t -> if Rat.sign t > 0 then Some (Passes_some t) else None
      | (Passes _ | Passes_some), None -> Scc_base.Bug.fail __POS__ "time that passes is known"
    in
    let steps = List.rev_map step w.way.taken in
    let count k = List.length (List.filter_map Fun.id (List.filteri (fun i _ -> i < k) steps)) in
    let offset = match w.inside with Some (_, d) -> value d | None -> Rat.zero in
    let values = Array.map value root.parameters in
    {
      run = { values; steps = List.filter_map Fun.id steps; offset };
      finish = counted count finish;
      claim = concrete value count claimed;
    }
  in
  Option.map of_point (Concrete.sample w.way)

let make graph b formula ~holds =
  let sets = Branching.truth b ~outermost:true formula ~holds in
  let from (root : Zone_graph.node) =
    match Union.point sets.at.(root.number) with
    | None -> None
    | Some point -> (
        let way = Concrete.start root.zone (Polyhedron.of_point point) in
        match explain b ~outermost:true { way; node = root.number; inside = None } formula holds with
        | _, None, _ -> None
        | w, Some finish, claimed -> choose root.zone w finish claimed)
  in
  List.find_map from (Zone_graph.roots graph)
