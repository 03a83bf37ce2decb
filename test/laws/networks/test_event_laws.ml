(* Laws of the rule book about the events of an instant: confluence, and bounces that can be undone. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model
let say = Printf.sprintf
let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

(* {1 Confluence} *)

(* The processes that change, by their indices. *)
let part (s : State.t) (t : Transition.t) =
  let leaves =
    match t.label with
    | Bounce { firsts; _ } -> firsts
    | Absorb { first; _ } | Draw { first; _ } -> [ first ]
    | Lot { bond; _ } -> [ bond.one.at; bond.two.at ]
    | Time _ | Bind _ | Close _ | Weak_split _ | Strong_split _ ->
      List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) (Transition.bonds t.label)
  in
  let has leaf i = State.has_leaf s.processes.(i) leaf in
  let home leaf = List.find (has leaf) (List.init (Array.length s.processes) Fun.id) in
  List.sort_uniq Int.compare (List.map home leaves)

let disjoint one two = not (List.exists (fun p -> List.mem p two) one)

let rec pairs = function [] -> [] | x :: rest -> List.map (fun y -> (x, y)) rest @ pairs rest

(* Events of one state that share no process. *)
let independent (s, transitions) =
  let events = List.filter (fun (t : Transition.t) -> not (Transition.is_time t.label)) transitions in
  List.filter (fun (t, u) -> disjoint (part s t) (part s u)) (pairs events)

(* Which processes are in contact, directly or through others: the least one of all. *)
let companies m (s : State.t) =
  let semantics = standard m in
  let company = Array.init (Array.length s.processes) Fun.id in
  let resolution = Option.value (Model.resolution m) ~default:Rat.zero in
  let join ((a : Part.t), (b : Part.t)) =
    if Rat.compare (Near_contact.distance2 a.placed b.placed) (Rat.mul resolution resolution) <= 0 then
      let one = company.(a.process) and two = company.(b.process) in
      Array.iteri (fun i c -> if c = Int.max one two then company.(i) <- Int.min one two) company
  in
  let parts = Array.to_list (Collisions.parts semantics s.processes) in
  let of_others ((a : Part.t), (b : Part.t)) = a.process <> b.process in
  List.iter join (List.filter of_others (pairs parts));
  company

let in_separate_companies m (s, t, u) =
  let company = companies m s in
  let of_event t = List.map (Array.get company) (part s t) in
  disjoint (of_event t) (of_event u)

(* Nothing where the first leads to a dead end. *)
let after m (t : Transition.t) (u : Transition.t) =
  match Network.successors (standard m) t.target with
  | Error _ -> None
  | Ok ts ->
    List.filter (fun (v : Transition.t) -> Transition.equal_label v.label u.label) ts
    |> List.map (fun (v : Transition.t) -> v.target)
    |> Option.some

let confluent ?(only = fun _ _ -> true) m state =
  List.find_map
    (fun ((t : Transition.t), (u : Transition.t)) ->
       let meet one other = List.exists (fun s -> List.exists (State.equal s) other) one in
       match (after m t u, after m u t) with
       | None, _ | _, None -> None
       | Some one, Some other when meet one other -> None
       | Some _, Some _ ->
         let label (t : Transition.t) = Transition.label_to_string m t.label in
         Some (say "%s and %s depend on their order" (label t) (label u)))
    (List.filter (fun (t, u) -> only m (fst state, t, u)) (independent state))

(* A network and its image far away, so that whatever happens happens twice at once. *)
let twice (m, (s : State.t)) =
  let n = Array.length m.Model.leaves in
  let other (l : Model.leaf) =
    let part (p : Model.part) = { p with name = "other_" ^ p.name } in
    { l with name = "other_" ^ l.name; parts = Array.map part l.parts }
  in
  let leaf (l : State.leaf) =
    { l with leaf = l.leaf + n; position = Vec.add (Vec.of_ints 0 1000 0) l.position }
  in
  let finish (f : State.finish) = { f with at = f.at + n } in
  let bond (b : State.bond) = State.bond b.name (finish b.one) (finish b.two) in
  let process (p : State.process) =
    State.process
      ~leaves:(List.map leaf (Array.to_list p.leaves))
      ~bonds:(List.map bond (Array.to_list p.bonds))
      ?phase:p.phase ?draw:p.draw
      ?lots:(Option.map (Symmetry.mapped_lots ~bond ~leaf:(fun l -> l + n)) p.lots)
      ~velocity:p.velocity ~spin:p.spin ~since:p.since ~lasts:p.lasts
      ~kept:p.kept ~clock:p.clock ()
  in
  let processes = Array.to_list s.processes in
  ( { m with Model.leaves = Array.append m.leaves (Array.map other m.leaves) },
    State.make ~processes:(processes @ List.map process processes) ~step:s.step ~time:s.time )

let explored (m, start) = (m, Reach.states m start ~limit:40)
let straight_states n = explored (Random_network.start n)
let states_twice n = explored (twice (Random_network.start n))

let straight name ?(count = 30) ?(networks = Random_network.generate ()) ?(states = straight_states) law =
  QCheck2.Test.make ~name ~count ~print:Random_network.print networks (fun n ->
      let m, states = states n in
      fail_on (List.find_map (law m) states))

(* The first states of a network twice over, and those of a run. *)
let turning_twice n =
  let m, start = twice (Random_rigid.start n) in
  let short (s, _) = Rigid_reach.bits s <= Rigid_reach.longest in
  (m, List.filter short (Rigid_reach.states ~limit:6 ~steps:12 m start))

let turning name ?(count = 3) features law =
  QCheck2.Test.make ~name ~count ~print:Random_rigid.print (Random_rigid.generate features) (fun n ->
      let m, states = turning_twice n in
      fail_on (List.find_map (law m) states))

(* So that confluence is about something. *)
let together () =
  let rand = Random.State.make [| 42 |] in
  let found n = List.fold_left (fun k s -> k + List.length (independent s)) 0 (snd (states_twice n)) in
  let all = List.fold_left (fun k n -> k + found n) 0 (Gen.generate ~rand ~n:50 (Random_network.generate ())) in
  Alcotest.(check bool) (say "%d pairs of events" all) true (all > 100)

(* Where it is said to fail, some network shows it. *)
let fails name ~count generate states =
  let shows () =
    let drawn = Gen.generate ~rand:(Random.State.make [| 42 |]) ~n:count generate in
    let broken n =
      let m, states = states n in
      List.exists (fun s -> Option.is_some (confluent m s)) states
    in
    Alcotest.(check bool) "some network shows it" true (List.exists broken drawn)
  in
  Alcotest.test_case name `Quick shows

(* {1 Bounces of one instant}

   Cubes in a pile, each touching its neighbours, at most one of them fixed: if each moved away from a point inside
   the fixed one, all would part. *)

let pile =
  let open Gen in
  let three g = triple g g g in
  let body = triple (three (-3 -- 3)) (1 -- 4) (0 -- 5) in
  let row x = [ (x, 0, 0); (x, 1, 0); (x, 0, 1); (x, 1, 1) ] in
  let place = oneofl (List.concat_map row [ 0; 1; 2 ]) in
  map
    (List.sort_uniq (fun (a, _) (b, _) -> Stdlib.compare a b))
    (list_size (2 -- 8) (pair place body))

let network_of_pile bodies =
  let is_fixed i = List.nth bodies i |> fun (_, (_, _, f)) -> f = 0 && i = 0 in
  let solid = Random_rigid.cube ~id:0 in
  let leaf i (_, (_, mass, _)) : Model.leaf =
    let name = say "p%d" i and mass = Rat.of_int mass in
    let part = { Model.name; template = "Cube"; solid; offset = Vec.zero; open_offset = None; mass } in
    { name; template = "Cube"; parts = [| part |]; fixed = is_fixed i; absorbs = false; mass; law = Inertial;
      law_at = Scc_base.Span.none }
  in
  let leaves = Array.of_list (List.mapi leaf bodies) in
  let m = { (Random_network.model Random_network.none) with leaves } in
  let process i ((x, y, z), ((vx, vy, vz), _, _)) =
    let position = Vec.of_ints (2 * x) (2 * y) (2 * z) in
    let behaviour = Behaviour.fresh Behaviour.nil in
    let leaf = { State.leaf = i; position; turned = Quaternion.identity; waited = Rat.zero; behaviour } in
    let velocity = if is_fixed i then Vec.zero else Vec.of_ints vx vy vz in
    State.process ~leaves:[ leaf ] ~bonds:[] ~velocity ~clock:None ()
  in
  (m, State.make ~processes:(List.mapi process bodies) ~step:None ~time:None)

let many_bounces = 2000

(* Now this collision first, now that. *)
let rec bounces m s n =
  let events = List.filter (fun (t : Transition.t) -> not (Transition.is_time t.label)) (Reach.successors m s) in
  match events with
  | [] -> n
  | _ when n > many_bounces -> n
  | events -> bounces m (List.nth events (n * 7 mod List.length events)).target (n + 1)

let show_pile bodies =
  String.concat "; "
    (List.map
       (fun ((x, y, z), ((vx, vy, vz), m, f)) -> say "(%d,%d,%d) v (%d,%d,%d) m %d f %d" x y z vx vy vz m f)
       bodies)

let bounces_end ?(switches = Switches.off) name =
  QCheck2.Test.make ~name ~count:40 ~print:show_pile pile (fun bodies ->
      let m, s = network_of_pile bodies in
      bounces (Switches.apply switches m) s 0 <= many_bounces)

(* {1 Sites} *)

(* What a part offers: name or co-name, the channel's name, and the corners of each feature of its surface. *)
let surfaces (m : Model.t) (part : Part.t) =
  let corners (site : Site.t) =
    if site.part = part.index then Some (Placed.corners part.placed site.feature) else None
  in
  List.filter_map
    (fun (offer, _) ->
       match offer with
       | Behaviours.Offer_open (polarity, (c : Behaviour.channel), _) ->
         Some (polarity, c.name, List.filter_map corners c.sites)
       | Offer_weak _ | Offer_strong _ -> None)
    (Behaviours.derivations m.definitions part.leaf.behaviour)

let surfaces_meet m ((a : Part.t), (b : Part.t)) =
  let common one two =
    List.exists (fun x -> List.exists (Near_contact.within ~resolution:Rat.zero x) two) one
  in
  List.exists
    (fun (p, name, one) ->
       List.exists
         (fun (q, other, two) -> p <> q && String.equal name other && common one two)
         (surfaces m b))
    (surfaces m a)

let bind_iff s transitions meet one two =
  let binds (t : Transition.t) =
    match t.label with
    | Bind _ -> List.equal Int.equal (part s t) [ one; two ]
    | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ | Time _ -> false
  in
  if Bool.equal meet (List.exists binds transitions) then None
  else Some (if meet then "surfaces meet, and nothing binds" else "what binds does not meet")

(* Of the pairs of parts that a candidate may be of (rule Bind, reading I-12). *)
let finds_sites m ((s : State.t), transitions) =
  Collisions.meetings (standard m) s.processes
  |> List.find_map (fun (e : Kinematics.meeting) ->
      bind_iff s transitions (List.exists (surfaces_meet m) e.touching) e.first e.second)

(* Of all pairs of parts (reading I-33). *)
let finds_sites_anywhere m ((s : State.t), transitions) =
  let parts = Array.to_list (Collisions.parts (standard m) s.processes) in
  let of_two i j ((a : Part.t), (b : Part.t)) = a.process = i && b.process = j in
  let processes = List.init (Array.length s.processes) Fun.id in
  List.find_map
    (fun (i, j) ->
       bind_iff s transitions (List.exists (surfaces_meet m) (List.filter (of_two i j) (pairs parts))) i j)
    (pairs processes)

(* {1 Reversal} *)

let backwards (s : State.t) =
  let process (p : State.process) = State.with_velocity (Vec.neg p.velocity) p in
  State.make ~processes:(List.map process (Array.to_list s.processes)) ~step:s.step ~time:s.time

(* The directions that count in a collision (rule Response). *)
let directions (s : State.t) (e : Kinematics.meeting) =
  let touching ((a : Part.t), (b : Part.t)) : Response.touching =
    {
      obstacle = Obstacle.make a.placed.solid b.placed.solid;
      offset = Vec.sub b.placed.at a.placed.at;
    }
  in
  let w = Vec.sub s.processes.(e.second).velocity s.processes.(e.first).velocity in
  Response.directions (List.map touching e.touching) w

(* Whether two processes collide, by one direction. *)
let one_direction m (s : State.t) p q =
  Collisions.meetings (standard m) s.processes
  |> List.exists (fun (e : Kinematics.meeting) ->
      e.first = p && e.second = q && List.compare_length_with (directions s e) 1 = 0)

let single m (s : State.t) p = Array.length m.Model.leaves.(s.processes.(p).leaves.(0).leaf).parts = 1

(* Forwards and backwards; of bodies of one part each, backwards follows. *)
let by_one_direction m (s : State.t) back (t : Transition.t) =
  match part s t with
  | [ p; q ] -> one_direction m s p q && ((single m s p && single m s q) || one_direction m back p q)
  | _ -> false

let undone m (s, transitions) =
  List.find_map
    (fun (t : Transition.t) ->
       let back = backwards t.target and goal = backwards s in
       match t.label with
       | Bounce _ when by_one_direction m s back t ->
         let undoes (u : Transition.t) =
           Transition.equal_label u.label t.label && State.equal u.target goal
         in
         if List.exists undoes (Reach.successors m back) then None else Some "a bounce is not undone"
       | Time d ->
         let in_time = match Time.delay (standard m) back with None -> true | Some e -> Rat.compare d e <= 0 in
         if Collisions.collides (standard m) back then Some "something collides at once on the way back"
         else if not in_time then Some "something happens on the way back"
         else if not (State.equal (Time.pass (standard m) d back) goal) then Some "the way back leads elsewhere"
         else None
       | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> None)
    transitions

let some_network networks shows () =
  let rand = Random.State.make [| 42 |] in
  let drawn = Gen.generate ~rand ~n:300 networks in
  let shows n = let m, states = straight_states (Random_network.inert n) in List.exists (shows m) states in
  Alcotest.(check bool) "some network shows it" true (List.exists shows drawn)

(* Where several directions count, some bounce is not undone. *)
let several =
  some_network (Random_network.generate ()) (fun m (s, ts) ->
      List.exists
        (fun (t : Transition.t) ->
           let undoes (u : Transition.t) = State.equal u.target (backwards s) in
           match t.label with
           | Bounce _ -> not (List.exists undoes (Reach.successors m (backwards t.target)))
           | Time _ | Bind _ | Close _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> false)
        ts)

(* Backwards, a third body may collide as well. *)
let clusters =
  some_network
    (Gen.map (Random_network.with_switches Switches.together) (Random_network.switched ()))
    (fun m state -> Option.is_some (undone m state))

let suite =
  let group name ?(failing = []) tests = (name, Scc_test_support.Property.cases tests @ failing) in
  let quick name f = Alcotest.test_case name `Quick f in
  ("event laws",
   [
     group "Progress"
       [
         bounces_end "Progress: the bounces of an instant end where all could part";
         bounces_end ~switches:Switches.together "Progress: so do those of clusters";
       ];
     group "Confluence"
       ~failing:
         [
           quick "there are many events at once" together;
           fails "Confluence: fails with laws of motion" ~count:80 (Random_network.generate ~steered:true ())
             states_twice;
         ]
       [
         straight "Confluence: events that share no process come to the same in either order"
           ~states:states_twice confluent;
         straight "Confluence: with binding by contact"
           ~count:10
           ~networks:(Gen.map (Random_network.with_switches Switches.by_contact) (Random_network.switched ()))
           ~states:states_twice confluent;
         straight "Confluence: with the switches of a model, of what is not in contact"
           ~networks:(Random_network.switched ()) ~states:states_twice
           (confluent ~only:in_separate_companies);
         straight "Confluence: laws of motion with steps of single processes, of what is not in contact"
           ~count:3
           ~networks:(Random_network.switched ~steered:true ())
           ~states:(fun n -> states_twice (Random_network.with_switches Switches.local n))
           (confluent ~only:in_separate_companies);
         turning "Confluence: bodies that turn" Random_rigid.anything confluent;
         turning "Confluence: bodies that turn, with rounding"
           { Random_rigid.anything with rounds = true }
           confluent;
         turning "Confluence: bodies that turn, with the switches of a model, of what is not in contact"
           ~count:3
           { Random_rigid.anything with rounds = true; switched = true }
           (confluent ~only:in_separate_companies);
       ];
     group "Sites"
       [
         straight "Sites: two processes that collide may bind iff surfaces meet" ~count:60 finds_sites;
         straight "Sites: with the switches of a model" ~count:16 ~networks:(Random_network.switched ())
           finds_sites;
         straight "Sites: with binding by contact any two may bind iff surfaces meet" ~count:16
           ~networks:(Gen.map (Random_network.with_switches Switches.by_contact) (Random_network.switched ()))
           finds_sites_anywhere;
       ];
     group "Reversal"
       ~failing:
         [
           quick "Reversal: fails where several directions count" several;
           quick "Reversal: fails with collisions together" clusters;
         ]
       [
         straight "Reversal: of bodies that are packed" ~count:20
           ~networks:(Gen.map (Random_network.with_switches Switches.by_contact) (Random_network.switched ()))
           ~states:(fun n -> straight_states (Random_network.inert n))
           undone;
         straight "Reversal: bounces by one direction, and the way between, are undone"
           ~count:60
           ~states:(fun n -> straight_states (Random_network.inert n))
           undone;
       ];
   ])
