open Scc_data
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_broad_phase
open Scc_semantics
open Scc_engine
open Scc_property

(** {1 Formulas} *)

(* Whether a predicate can only become true, never false, by events that have just happened; or only false. *)
let rec favours positive (p : Property.prop) =
  match p with
  | Fact f -> positive || Option.is_none (Atom.fact f).event
  | Compare _ -> not (Formula.has_events (State p))
  | Not p -> favours (not positive) p
  | And ps | Or ps -> List.for_all (favours positive) ps
  | Bool _ -> true

let rec is_search (plan : Plan.t) =
  match plan with
  | Now _ -> true
  | Possibly (_, p) -> favours true p
  | Always (_, p) -> favours false p
  | Formula _ -> false
  | All plans | Any plans -> List.for_all is_search plans

(* A probability, or a mean, of what runs do as far as predicates tell. *)
let rec is_chance (f : Property.temporal) =
  let favours positive f = Option.fold ~none:false ~some:(favours positive) (Formula.state_formula f) in
  match f with
  | Temporal_not f -> is_chance f
  | Finally (Chance _, _, g) -> favours true g
  | Globally (Chance _, _, g) -> favours false g
  | Until (Chance _, _, f, g) ->
    Option.is_some (Formula.state_formula f) && (not (Formula.has_events f)) && favours true g
  | State _ | Temporal_and _ | Temporal_or _ | Next _ | Finally _ | Globally _ | Until _ -> false

let rec is_served (plan : Plan.t) =
  match plan with
  | Formula f -> is_chance f
  | All plans | Any plans -> List.for_all is_served plans
  | Now _ | Possibly _ | Always _ -> is_search plan

let favours_events f = is_search (Plan.of_formula f)
let is_local f = (not (Formula.global f)) && Formula.leaves f <> []
let can_be_sliced f = favours_events f && is_local f
let serves f = is_served (Plan.of_formula f) && is_local f

(** {1 Walls} *)

(* Whether an offer to bind is exposed, or will be once delays have expired. *)
let may_bind definitions (b : Behaviour.aged) =
  let opens : Behaviour.t -> bool = function
    | Open _ -> true
    | Nil | Weak _ | Strong _ | Delay _ | Wait _ | Sum _ | Call _ -> false
  in
  Behaviour.some_prefix definitions ~behind:Behaviour.is_delay opens b.term

let is_wall (m : Model.t) ~in_events (p : State.process) =
  match p.leaves with
  | [| l |] ->
    m.leaves.(l.leaf).fixed && (not (List.mem l.leaf in_events)) && not (may_bind m.definitions l.behaviour)
  | _ -> false

(** {1 Groups} *)

type swarm = {
  semantics : Semantics.t;
  model : Model.t;
  horizon : Rat.t option;
  processes : State.process array;
  parts : Part.t array;
  walls : bool array;  (** by process *)
  lines : Moving_boxes.t;  (** of parts, which do not collide *)
  present : Box_tree.t;  (** where parts may be until the horizon, those of walls apart *)
  still : Box_tree.t;  (** the parts of walls *)
  groups : Union_find.t;  (** of processes *)
  members : int list array;  (** the parts of a group, by representative *)
  paces : Pace.t array;  (** of a group, by representative *)
  stirred : bool array;  (** the group may have a collision, by representative *)
  unsteady : bool array;  (** its velocities are not known; so it is of all that are stirred *)
  grown : bool array;  (** and its boxes have been grown by what that may lead to *)
  restless : bool array;  (** a process may make transitions for ever at an instant, without a collision *)
}

let find s i = Union_find.find s.groups i

let stir s g =
  s.stirred.(g) <- true;
  s.unsteady.(g) <- true

(* Of two groups, by their representatives. *)
let join s g h =
  ignore (Union_find.union s.groups g h);
  let g, h = if find s g = g then (g, h) else (h, g) in
  let few, many = (s.members.(g), s.members.(h)) in
  let few, many = if List.compare_lengths few many <= 0 then (few, many) else (many, few) in
  s.members.(g) <- List.rev_append few many;
  s.members.(h) <- [];
  s.paces.(g) <- Pace.add s.paces.(g) s.paces.(h);
  stir s g;
  s.grown.(g) <- false

let is_fixed s i = s.model.leaves.(s.parts.(i).leaf.leaf).fixed

let create semantics ~horizon ~in_events (initial : State.t) =
  let model = Semantics.model semantics in
  let processes = initial.processes in
  let parts = Collisions.parts semantics processes in
  let n = Array.length processes in
  let lines = Moving_boxes.create (Array.length parts) in
  (* The ends of sweeps must be later than 0. *)
  let until =
    match horizon with None -> infinity | Some h -> Float.max Float.min_float (Float_box.up h)
  in
  let members = Array.make n [] and paces = Array.map (Pace.of_process model) processes in
  let releases = Array.map (Pace.may_release model) processes in
  let driven = Array.map Pace.driven paces in
  Array.iteri
    (fun i (p : Part.t) ->
       let placed : Scc_rigid.Placed.t = p.placed in
       Moving_boxes.set lines i placed.solid.box ~at:placed.at ~velocity:(Part.velocity p);
       Moving_boxes.set_until lines i until;
       members.(p.process) <- i :: members.(p.process))
    parts;
  {
    semantics; model; horizon; processes; parts; lines; members; paces;
    walls = Array.map (is_wall model ~in_events) processes;
    present = Box_tree.create ();
    still = Box_tree.create ();
    groups = Union_find.create n;
    (* Pieces that laws move meet each other. *)
    stirred = Array.map2 ( && ) driven releases;
    unsteady = driven;
    grown = Array.make n false;
    restless = Array.map (( && ) (Model.closes_rings model)) releases;
  }

(** {2 On their lines} *)

let collide s i j =
  let a = s.parts.(i) and b = s.parts.(j) in
  let w = Part.relative_velocity a b in
  (not (Vec.is_zero w))
  && Moving_boxes.may_meet s.lines i j ~from:0.
  &&
  match s.semantics.setting.geometry.first_time_of_contact a.placed b.placed w with
  | Never -> false
  | At t -> ( match s.horizon with None -> true | Some h -> Rat.compare t h <= 0)
  | Inside -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"

(* Puts the parts in the trees, and finds who collides with whom as long as nobody has collided. Where the boxes of
   groups will be grown (those then hold their lines), nothing is to be found. *)
let fly s =
  let everywhere = ref false in
  let is_calm g = not (s.unsteady.(g) || !everywhere) in
  (* Without a horizon, a group that may have a collision gets everywhere. *)
  let met () = if Option.is_none s.horizon then everywhere := true in
  let meet i j =
    let g = find s s.parts.(i).process and h = find s s.parts.(j).process in
    if g <> h && is_calm g && is_calm h && collide s i j then begin
      join s g h;
      met ()
    end
  in
  let hit wall i =
    let g = find s s.parts.(i).process in
    if is_calm g && collide s i wall then begin
      stir s g;
      met ()
    end
  in
  let enter i (p : Part.t) =
    let box = Moving_boxes.swept s.lines i ~from:0. in
    if s.walls.(p.process) then begin
      Box_tree.iter_meeting s.present box (hit i);
      Box_tree.insert s.still i box
    end
    else begin
      Box_tree.iter_meeting s.present box (meet i);
      Box_tree.iter_meeting s.still box (fun wall -> hit wall i);
      Box_tree.insert s.present i box
    end
  in
  Array.iteri enter s.parts

(** {2 On other ways} *)

let energy s g = Pace.energy s.model ~horizon:s.horizon ~collide:s.stirred.(g) s.paces.(g)

(* v^2 <= 2E/m, so that the way until h is at most the root of 2E h^2/m. The root of a float is rounded to the
   nearest, and so is below the next float. *)
let reach s ~energy i =
  let rests = match energy with Some energy -> Rat.sign energy = 0 | None -> false in
  if is_fixed s i || rests then 0.
  else
    match (energy, s.horizon) with
    | None, _ | _, None -> infinity
    | Some energy, Some h ->
      let mass = s.model.leaves.(s.parts.(i).leaf.leaf).mass in
      Next_float.succ (Float.sqrt (Float_box.up (Rat.div (Rat.mul energy (Rat.mul h h)) mass)))

(* Sums and differences are rounded to the nearest; none is infinity - infinity, as least coordinates are never
   +infinity, nor greatest ones -infinity. *)
let grown_box s ~energy i =
  let p = s.parts.(i) in
  let box = Float_box.at p.placed.at p.placed.solid.box and r = reach s ~energy i in
  let low k = Next_float.pred (Float_box.low box k -. r) in
  let high k = Next_float.succ (Float_box.high box k +. r) in
  Float_box.make ~low:(Array.init 3 low) ~high:(Array.init 3 high)

let withdraw s g =
  List.iter (fun i -> if Box_tree.mem s.present i then Box_tree.remove s.present i) s.members.(g)

(* The groups that a part of a group may meet, which is not in the tree itself. Two fixed leaves never meet, and
   what is on its line meets a fixed leaf or does not. *)
let found s box i =
  let groups = ref [] in
  Box_tree.iter_meeting s.present box (fun j ->
      let h = find s s.parts.(j).process in
      let may_meet =
        if not (is_fixed s i) then true
        else if is_fixed s j then false
        else s.unsteady.(h) || collide s i j
      in
      if may_meet then groups := h :: !groups);
  List.sort_uniq Int.compare !groups

let meets_wall s box =
  let met = ref false in
  Box_tree.iter_meeting s.still box (fun _ -> met := true);
  !met

(* Grows a group, joins it with those that it may meet, and grows the whole, until it meets nobody. That it may
   meet a wall, or somebody, may let it get farther. *)
let rec grow s g =
  withdraw s g;
  let energy = energy s g in
  let boxes = List.rev_map (fun i -> (i, grown_box s ~energy i)) s.members.(g) in
  let take_in whole h =
    withdraw s h;
    join s whole h;
    find s h
  in
  let whole = List.fold_left (fun whole (i, box) -> List.fold_left take_in whole (found s box i)) g boxes in
  if List.compare_lengths s.members.(whole) boxes <> 0 then grow s whole
  else if (not s.stirred.(whole)) && List.exists (fun (_, box) -> meets_wall s box) boxes then begin
    stir s whole;
    grow s whole
  end
  else begin
    List.iter (fun (i, box) -> Box_tree.insert s.present i box) boxes;
    s.grown.(g) <- true
  end

let is_group s i = find s i = i && not s.walls.(i)

let settle s =
  Array.iteri
    (fun i _ ->
       let g = find s i in
       if s.unsteady.(g) && not s.grown.(g) then grow s g)
    s.processes

(** {1 What is left out} *)

(* The walls that some groups may reach. *)
let reached s groups =
  let near = Array.make (Array.length s.processes) false in
  let note energy i =
    Box_tree.iter_meeting s.still (grown_box s ~energy i) (fun j -> near.(s.parts.(j).process) <- true)
  in
  List.iter (fun g -> if s.stirred.(g) then List.iter (note (energy s g)) s.members.(g)) groups;
  near

(* When those who had to draw first, or to collide, are not there, the movement step may begin at once. *)
let settled semantics state =
  match Steer.settle semantics state with
  | Ok outcome -> outcome.state
  | Error _ -> Scc_base.Bug.fail __POS__ "a bounded law that is in error"

(* How many transitions a group may make until the horizon. *)
let patience = 10_000

(* Whether time gets to the horizon when a group does at once what it must, and only that. *)
let lasts s initial g =
  let must label = Transition.is_urgent label || Transition.is_time label in
  let near = reached s [ g ] in
  let run = Event_run.start s.semantics (State.restricted initial (fun i -> find s i = g || near.(i))) in
  let over time = match s.horizon with None -> false | Some h -> Rat.compare h time <= 0 in
  let rec go fuel =
    fuel > 0
    &&
    let rec first k =
      if k = Event_run.count run then None
      else
        let label = Event_run.label run k in
        if must label then Some (k, label) else first (k + 1)
    in
    match first 0 with
    | None -> true
    | Some (k, label) ->
      over (Rat.add (Event_run.elapsed run) (Transition.duration_of label))
      || begin
        ignore (Event_run.take run k);
        go (fuel - 1)
      end
  in
  go patience

let owners (m : Model.t) (initial : State.t) =
  let owner = Array.make (Array.length m.leaves) (-1) in
  Array.iteri
    (fun i (p : State.process) -> Array.iter (fun (l : State.leaf) -> owner.(l.leaf) <- i) p.leaves)
    initial.processes;
  owner

(* Whether a group may be left out: time gets to the horizon in one run of it, or in all of them. *)
let goes_on s initial ~in_all g =
  if s.stirred.(g) || s.restless.(g) then (not in_all) && lasts s initial g else Pace.may_draw s.paces.(g)

let kept s initial named ~in_all =
  let n = Array.length s.processes in
  let wanted = Array.make n false in
  List.iter (fun p -> wanted.(find s p) <- true) named;
  for g = 0 to n - 1 do
    if is_group s g && (not wanted.(g)) && not (goes_on s initial ~in_all g) then wanted.(g) <- true
  done;
  let groups = List.filter (fun g -> is_group s g && wanted.(g)) (List.init n Fun.id) in
  let near = reached s groups in
  let stays = Array.init n (fun i -> wanted.(find s i) || near.(i)) in
  (* Walls that nobody reaches cost nothing: without them alone, an exploration of its own would not pay. *)
  if Array.for_all2 ( || ) stays s.walls then None
  else Some (settled s.semantics (State.restricted initial (fun i -> stays.(i))))

(* Bodies that come to touch and do not collide are not looked for (reading I-33). *)
let can_be_cut (m : Model.t) initial =
  not
    (Model.has_turns m || m.lots || Model.binds_on_contact m || Model.stops_walkers m
     || Parameters.may_push m initial)
  && Pace.allows m

(* Groups are looked for once for all formulas that look as far, and name the same leaves in events. *)
let make semantics ~(initial : State.t) =
  let m = Semantics.model semantics in
  let owner = lazy (owners m initial) and can_be_cut = lazy (can_be_cut m initial) and known = ref [] in
  let swarm ~horizon ~in_events =
    let is_same (h, leaves, _) = Option.equal Rat.equal h horizon && List.equal Int.equal leaves in_events in
    match List.find_opt is_same !known with
    | Some (_, _, s) -> s
    | None ->
      let s = create semantics ~horizon ~in_events initial in
      fly s;
      settle s;
      known := (horizon, in_events, s) :: !known;
      s
  in
  let slice formulas =
    let owner = Lazy.force owner in
    let named = List.concat_map (fun f -> List.map (Array.get owner) (Formula.leaves f)) formulas in
    let in_events = List.sort_uniq Int.compare (List.concat_map Formula.leaves_of_events formulas) in
    if List.exists (fun p -> p < 0) named then None
    else
      let in_all = not (Model.straight m && List.for_all favours_events formulas) in
      kept (swarm ~horizon:(Plan.latest_horizon formulas) ~in_events) initial named ~in_all
  in
  fun formulas ->
    if formulas <> [] && List.for_all serves formulas && Lazy.force can_be_cut then slice formulas else None

let left_out (m : Model.t) ~initial slice =
  let before = owners m initial and after = owners m slice in
  Array.to_list m.leaves
  |> List.filteri (fun i _ -> before.(i) >= 0 && after.(i) < 0)
  |> List.map (fun (l : Model.leaf) -> l.name)
