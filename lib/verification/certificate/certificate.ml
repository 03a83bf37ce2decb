open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_evaluate
open Scc_state_sets

exception Rejected of string

let reject format = Printf.ksprintf (fun text -> raise (Rejected text)) format

type context = {
  cut : Zone_parts.context;
  model : Model.t;
  invariant : Invariant.t;
  locations : (Invariant.location * Zone.t) list;  (** with a variable for each coordinate *)
  atoms : Atoms.context;
  claims : Invariant.claim list;
  stop : unit -> bool;
}

(* The rules for the values that a point of a cloud gives the parameters. *)
let semantics_at t (z : Zone.t) point =
  Semantics.with_model t.cut.semantics (Fixed.model t.model (Zone.values z point))

(* {1 Landing} *)

(* Numbers of a location of the invariant, for what single states of a cloud become: places are where they are,
   and what has aged either goes on to, or has just begun. What is right for the point in the middle is right for
   all, as no age is negative; but this is seen at enough points, too. *)
let numbers t (location : Invariant.location) (z : Zone.t) ~middle (result : State.t) =
  let n = Zone.dimension z in
  let zero = Linear.constant n Rat.zero in
  let here leaf = State.home result leaf in
  let m = t.model in
  let of_leaf forms choose leaf =
    match here leaf with None -> zero | Some p -> choose p leaf (forms : Linear.t array).(leaf)
  in
  let definitions = (Semantics.model (semantics_at t z middle)).definitions in
  let values = Zone.values z middle in
  let age (p : State.process) leaf old =
    match State.home location.skeleton leaf with
    | None -> zero
    | Some set ->
      let began = (State.leaf_of set leaf).behaviour in
      if Behaviours.delays m.definitions began = [] then zero
      else
        let known = Behaviour.aged began.origin (Fixed.behaviour t.model values began.term) in
        let is_now aged =
          let now = (State.leaf_of p leaf).behaviour in
          Behaviour.equal_aged (Cloud.tidied definitions aged) (Cloud.tidied definitions now)
        in
        (* What leads to itself when its delay is over has both ages, and the location has the lesser one. *)
        if is_now known then zero
        else if is_now (Behaviours.pass definitions (Linear.eval old middle) known) then old
        else zero
  in
  let clock (p : State.process) leaf old =
    match p.clock with
    | Some now when p.leaves.(0).leaf = leaf && Rat.equal now (Linear.eval old middle) -> old
    | Some _ | None -> zero
  in
  let leaves = List.init (Array.length m.leaves) Fun.id in
  let all choose forms = Array.of_list (List.map (of_leaf forms choose) leaves) in
  let place leaf = match here leaf with None -> Place.constant n Vec.zero | Some _ -> z.places.(leaf) in
  { z with skeleton = location.skeleton; ages = all age z.ages; clocks = all clock z.clocks;
           places = Array.of_list (List.map place leaves) }

(* The ages may be longer than what they lead to, and a location may have what is left of a delay that is over at
   these points: then they are not those. *)
let if_possible make = match make () with x -> Some x | exception Scc_base.Bug.Bug _ -> None

let is_in t (location, (all : Zone.t)) z points (results : State.t list) =
  let same candidate point result =
    let tidy = Cloud.tidy (Semantics.model (semantics_at t z point)).definitions in
    match if_possible (fun () -> Cloud.state t.model candidate point) with
    | Some s -> State.equal (tidy result) (tidy s)
    | None -> false
  in
  match if_possible (fun () -> numbers t location z ~middle:(List.hd points) (List.hd results)) with
  | None -> false
  | Some candidate ->
    List.for_all2 (same candidate) points results
    && Polyhedron.included z.Zone.set
      (Polyhedron.preimage all.set ~dimension:(Zone.dimension z) (Zone.coordinates candidate))

(* That what becomes of the states of a cloud is in the invariant: it is known at the points of {!Cloud.points}. *)
let land_in t z ~what ~arrived points results =
  if t.stop () then reject "there was no time to check it";
  let alike ((l : Invariant.location), _) = List.equal Int.equal l.arrived arrived in
  if not (List.exists (fun l -> alike l && is_in t l z points results) t.locations) then
    reject "%s leads out of it" what

(* {1 What happens at once} *)

let successors t z point state =
  match Network.successors (semantics_at t z point) state with
  | Ok list -> List.filter (fun (tr : Transition.t) -> not (Transition.is_time tr.label)) list
  | Error _ -> reject "what happens next is not known"

let arrived t ~source label =
  let events = t.invariant.events in
  List.filter (fun i -> Event.matches ~source label events.(i)) (List.init (Array.length events) Fun.id)

(* All that may happen to states of a cloud, which is the same for all of them; whether it must happen. *)
let discrete t (z : Zone.t) ~states ~only =
  let points = Cloud.points z.set in
  let sources = List.map states points in
  let wanted = List.filter (fun (tr : Transition.t) -> only tr.label) in
  let all = List.map wanted (List.map2 (successors t z) points sources) in
  let first = List.hd all in
  let same_labels list =
    let same (a : Transition.t) (b : Transition.t) = Transition.equal_label a.label b.label in
    List.compare_lengths first list = 0 && List.for_all2 same first list
  in
  if not (List.for_all same_labels all) then reject "different things happen to states that are alike";
  let each i (tr : Transition.t) =
    let results = List.map (fun list -> (List.nth list i : Transition.t).target) all in
    let arrived = arrived t ~source:(List.hd sources) tr.label in
    land_in t z ~what:(Transition.label_to_string t.model tr.label) ~arrived points results
  in
  List.iteri each first;
  List.exists (fun (tr : Transition.t) -> Transition.is_urgent tr.label) first

(* {1 What should never come} *)

let nothing_claimed t (z : Zone.t) ~passing =
  let of_claim (claim : Invariant.claim) =
    let view = { Atoms.zone = z; passing; quiescent = [] } in
    let bad region =
      List.exists
        (fun values ->
           let here = Polyhedron.preimage values ~dimension:(Zone.dimension z) z.parameters in
           not (Polyhedron.disjoint region here))
        (Union.pieces claim.values)
    in
    if List.exists bad (Atoms.possible t.atoms claim.never view) then reject "it has states that should never come"
  in
  List.iter of_claim t.claims

(* {1 Time} *)

(* A cloud of the ends of passings, with the single states that they are, by the ordinary rules. *)
let passed t (start : Zone.t) (ends : Zone.t) region =
  let n = Polyhedron.dimension region in
  (* the start, by the variables of the end, of which the last one is the time that passes *)
  let whole = Zone.with_variables start ~dimension:n (Array.init (n - 1) (Linear.variable n)) region in
  let whole = { whole with time = Some (Linear.variable n (n - 1)) } in
  match (Cloud.on { ends with set = region } region, Cloud.on whole region) with
  | None, _ | _, None -> None
  | Some z, Some start ->
    let state point =
      let before = Cloud.state t.model start point in
      let c = semantics_at t start point in
      let d = Linear.eval (Option.get start.time) point in
      (match Time.delay c before with
       | Some most when Rat.compare most d < 0 -> reject "time passes for too long"
       | Some _ | None -> ());
      Time.pass c d before
    in
    Some (z, state)

let pass t (z : Zone.t) region =
  let of_flow (flow : Flow.t) =
    nothing_claimed t flow.ends ~passing:true;
    let land_ends region =
      match passed t z flow.ends region with
      | None -> ()
      | Some (ends, state) ->
        let points = Cloud.points ends.set in
        land_in t ends ~what:"a passing of time" ~arrived:[] points (List.map state points)
    in
    let left = Zone_time.all_left t.model flow.ends in
    let over f = Constraint.equals f (Linear.constant (Linear.dimension f) Rat.zero) in
    let ended = List.map (fun f -> Polyhedron.add flow.states (over f)) left in
    let due = Flow.contacts t.cut flow @ List.filter (fun p -> not (Polyhedron.is_empty p)) ended in
    List.iter land_ends (Arrangement.by_signs left due);
    if Zone_time.splits_at_any_time t.model z then
      (* What is over at the end has led to a location, which has weak splits of its own. *)
      let before = List.map (fun f -> Constraint.greater f (Linear.constant (Linear.dimension f) Rat.zero)) left in
      let set = Polyhedron.add_all flow.ends.set before in
      let split region =
        match passed t z flow.ends region with
        | None -> ()
        | Some (ends, states) ->
          let weak = function Transition.Weak_split _ -> true | _ -> false in
          ignore (discrete t ends ~states ~only:weak)
      in
      List.iter split (Arrangement.cells t.cut { flow.ends with set })
  in
  List.iter of_flow (Flow.passings t.cut z region)

(* {1 All of it} *)

(* The lengths of all delays that a behaviour may ever come to, as far as they depend on parameters: one that has
   no length is over as it begins (rule Eps0). *)
let rec lengths b =
  let own = match (b : Behaviour.t) with Wait (f, _) -> [ f ] | _ -> [] in
  own @ List.concat_map lengths (Behaviour.parts b)

let all_lengths t (z : Zone.t) =
  let of_process (p : State.process) =
    List.concat_map (fun (l : State.leaf) -> lengths l.behaviour.term) (Array.to_list p.leaves)
  in
  let of_definition (d : Behaviour.definition) = lengths d.body in
  List.concat_map of_process (Array.to_list z.skeleton.processes)
  @ List.concat_map of_definition (Array.to_list t.model.definitions)
  |> List.sort_uniq Linear.compare
  |> List.map (fun f -> Linear.compose f ~dimension:(Zone.dimension z) z.parameters)

(* Weak splits look at whether the instant is one of the grid. *)
let at_one_instant t (z : Zone.t) = Arrangement.by_signs (all_lengths t z @ Array.to_list z.clocks) [ z.set ]

let of_location t location =
  let whole = Cloud.of_location t.model location in
  let whole = { whole with set = Zone_well_formed.convex t.cut whole } in
  let possible region =
    let z = { whole with set = region } in
    nothing_claimed t z ~passing:false;
    let of_cell cell =
      match Cloud.on z cell with
      | None -> ()
      | Some cloud ->
        let urgent = discrete t cloud ~states:(Cloud.state t.model cloud) ~only:(fun _ -> true) in
        if not urgent then pass t cloud cloud.set
    in
    List.iter of_cell
      (List.concat_map (fun set -> Arrangement.cells t.cut { z with set }) (at_one_instant t z))
  in
  List.iter possible (Zone_well_formed.apart t.cut whole)

let starts t (u : Uncertain.t) ~declared =
  let zone = Zone.declared t.model u declared ~keeps_time:false in
  let regions = Arrangement.by_signs (all_lengths t zone) [ zone.set ] in
  let initial z point =
    match Network.initial (semantics_at t z point) (Fixed.declared t.model u declared (Zone.values z point)) with
    | Ok s -> s
    | Error _ -> reject "the initial state is not known"
  in
  let of_region region =
    match Cloud.on { zone with set = region } region with
    | None -> ()
    | Some z ->
      let points = Cloud.points z.set in
      land_in t z ~what:"the start" ~arrived:[] points (List.map (initial z) points)
  in
  List.iter of_region regions

let not_for m =
  if Model.binds_on_contact m then
    Some
      "its bodies bind on contact, and where they come to meet without a collision invariants are not checked"
  else None

let check_all semantics u ~declared invariant claims ~stop =
  let model = { (Semantics.model semantics) with keeps_time = false } in
  let cut = Zone_parts.context (Semantics.with_model semantics model) in
  let t =
    {
      cut;
      model;
      invariant;
      locations = List.map (fun l -> (l, Invariant.zone model l)) invariant.locations;
      atoms = Atoms.context cut ~events:invariant.events;
      claims;
      stop;
    }
  in
  match
    starts t u ~declared;
    List.iter (of_location t) invariant.locations
  with
  | () -> Ok ()
  | exception Rejected reason -> Error reason

let check semantics u ~declared invariant claims ~stop =
  match not_for (Semantics.model semantics) with
  | Some reason -> Error reason
  | None -> check_all semantics u ~declared invariant claims ~stop
