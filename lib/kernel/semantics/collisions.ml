open Scc_exact
open Scc_geometry
open Scc_calculus
open Kinematics

let parts (c : Semantics.t) processes =
  let (module K) = c.kinematics in
  let of_process i p = c.memo.parts i p (fun () -> K.parts c.setting i p) in
  Scc_data.Long_array.of_list (List.concat (List.mapi of_process (Array.to_list processes)))

(* Those of two processes together, in order. *)
let by_processes pairs =
  let compare (_, ((a : Part.t), (b : Part.t))) (_, ((a' : Part.t), (b' : Part.t))) =
    Int.compare a.process a'.process <?> fun () -> Int.compare b.process b'.process
  in
  let group groups pair =
    match groups with
    | (other :: _ as group) :: rest when compare pair other = 0 -> (pair :: group) :: rest
    | _ -> [ pair ] :: groups
  in
  List.stable_sort compare pairs |> List.fold_left group [] |> List.rev_map List.rev

(* {1 Rule Bind} *)

let open_channels (m : Model.t) (p : State.process) leaf =
  Behaviours.derivations m.definitions (State.leaf_of p leaf).behaviour
  |> List.filter_map (fun (offer, derivation) ->
      match offer with
      | Behaviours.Offer_open (polarity, channel, b) ->
        Some (polarity, channel, b, derivation)
      | Offer_weak _ | Offer_strong _ -> None)

let complementary a b =
  match (a, b) with
  | Behaviour.Name, Behaviour.Co_name | Co_name, Name -> true
  | Name, Name | Co_name, Co_name -> false

let in_turn dimension pairs =
  let pairs_of d = match List.filter (fun pair -> dimension pair = d) pairs with [] -> None | some -> Some some in
  List.filter_map pairs_of [ 2; 1; 0 ]

(* The touching pairs that two channels share, of the highest dimension among them. *)
let shared_pairs pairs ~active_one ~active_two =
  let shared = List.filter (fun (c : Contact.pair) -> active_one c.first && active_two c.second) pairs in
  match in_turn (fun (c : Contact.pair) -> c.dimension) shared with [] -> [] | highest :: _ -> highest

let fit ((pol1, (c1 : Behaviour.channel), _, _), (pol2, (c2 : Behaviour.channel), _, _)) =
  complementary pol1 pol2 && String.equal c1.name c2.name

(* All two that are open and compatible, one of a leaf of each process. *)
let compatible (c : Semantics.t) p one q two =
  let ones = open_channels c.setting.model p one and twos = open_channels c.setting.model q two in
  List.concat_map (fun one -> List.map (fun two -> (one, two)) twos) ones |> List.filter fit

let fitting c (p, one) (q, two) =
  List.map (fun ((_, one, _, _), (_, two, _, _)) -> (one, two)) (compatible c p one q two)

let joined (c : Semantics.t) (p : State.process) (q : State.process) bond continuations =
  let (module K) = c.kinematics in
  let leaves = Array.to_list (Array.append p.leaves q.leaves) |> List.map (Process.continue continuations) in
  let bonds = bond :: Array.to_list (Array.append p.bonds q.bonds) in
  State.process ~leaves ~bonds ~velocity:Scc_exact.Vec.zero ~clock:None ()
  |> Process.restart_clock c.setting.model |> K.joined c.setting p q
  |> Process.joined_step c.setting.model p q
  |> State.with_lots p.lots

type candidate = {
  bond : State.bond;
  continuations : (int * Behaviour.t) list;
  fired : Behaviours.derivation list list;
}

(* What two parts that touch may bind by: each bond with what becomes of its ends, and by which summands. *)
let bonds (c : Semantics.t) ((a : Part.t), (b : Part.t)) =
  let (module K) = c.kinematics in
  let site (part : Part.t) feature : Site.t = { part = part.index; feature } in
  let candidates pairs ((_, (c1 : Behaviour.channel), b1, one), (_, (c2 : Behaviour.channel), b2, two)) =
    shared_pairs pairs
      ~active_one:(fun f -> Behaviour.active c1 (site a f))
      ~active_two:(fun f -> Behaviour.active c2 (site b f))
    |> List.map (fun (pair : Contact.pair) ->
        let bond =
          State.bond c1.name
            { at = a.leaf.leaf; site = site a pair.first }
            { at = b.leaf.leaf; site = site b pair.second }
        in
        { bond; continuations = [ (a.leaf.leaf, b1); (b.leaf.leaf, b2) ]; fired = [ [ one; two ] ] })
  in
  match compatible c a.owner a.leaf.leaf b.owner b.leaf.leaf with
  | [] -> []
  | fitting -> List.concat_map (candidates (K.touching c.setting a b)) fitting

(* The candidates of two parts that touch, of two processes that meet. *)
let bind c p q parts =
  let outcome { bond; continuations; fired } =
    let come = [ joined c p q bond continuations ] in
    { Transition.rule = Rule.Bind; label = Bind bond; fired; gone = [ p; q ]; come }
  in
  List.map outcome (bonds c parts)

(* {1 Rule Absorb} *)

let absorber (m : Model.t) (p : State.process) =
  Array.find_opt (fun (l : State.leaf) -> m.leaves.(l.leaf).absorbs) p.leaves

let absorb (c : Semantics.t) (p : State.process) (q : State.process) =
  let taken (p : State.process) (by : State.leaf) =
    {
      Transition.rule = Rule.Absorb;
      label = Absorb { first = p.leaves.(0).leaf; absorber = by.leaf };
      fired = [];
      gone = [ p ];
      come = [];
    }
  in
  match (absorber c.setting.model p, absorber c.setting.model q) with
  | Some by, None -> [ taken q by ]
  | None, Some by -> [ taken p by ]
  | None, None | Some _, Some _ -> []

(* {1 Candidates} *)

let may_react (c : Semantics.t) (p : State.process) (q : State.process) =
  let fit (one : State.leaf) (two : State.leaf) = compatible c p one.leaf q two.leaf <> [] in
  absorb c p q <> [] || Array.exists (fun one -> Array.exists (fit one) q.leaves) p.leaves

let candidates c (processes : State.process array) (m : meeting) =
  let p = processes.(m.first) and q = processes.(m.second) in
  (if m.collide then absorb c p q else []) @ List.concat_map (bind c p q) m.touching

(* {1 Meetings} *)

(* Whether processes meet that do not collide (reading I-33). *)
let by_contact (c : Semantics.t) = Model.binds_on_contact c.setting.model

let meetings (c : Semantics.t) processes =
  let (module K) = c.kinematics in
  let by_contact = by_contact c in
  let judged ((a : Part.t), (b : Part.t)) =
    if not (by_contact || Part.in_relative_motion a b) then None
    else
      match c.memo.contact a b (fun () -> K.contact c.setting a b) with
      | Apart -> None
      | (Touching | Colliding) as contact -> Some (contact, (a, b))
  in
  let collides = function Colliding, _ -> true | (Touching | Apart), _ -> false in
  let meeting found =
    let (a : Part.t), (b : Part.t) = snd (List.hd found) in
    let m =
      {
        first = a.process; second = b.process; collide = List.exists collides found;
        touching = List.map snd found;
      }
    in
    if m.collide || (by_contact && candidates c processes m <> []) then Some m else None
  in
  let parts = parts c processes in
  if (not by_contact) && Part.move_alike parts then []
  else
    c.setting.neighbours.within (K.margin c.setting) parts
    |> List.filter_map judged |> by_processes |> List.filter_map meeting

let colliding c (s : State.t) = List.map (fun (m : meeting) -> (m.first, m.second)) (meetings c s.processes)
let collides c (s : State.t) = meetings c s.processes <> []

(* {1 Rule Blocked} *)

(* Each of the two stops that would collide with the other at rest, or with which the other would not. *)
let stopping (c : Semantics.t) (processes : State.process array) m =
  let p = processes.(m.first) and q = processes.(m.second) in
  let approach w ((a : Part.t), (b : Part.t)) = c.setting.geometry.approaching a.placed b.placed w in
  let runs w = List.exists (approach w) m.touching in
  let one = runs (Vec.neg p.velocity) and two = runs q.velocity in
  let stops p = Process.stops c.setting.model p in
  (if stops p && (one || not two) then [ m.first ] else [])
  @ if stops q && (two || not one) then [ m.second ] else []

let blocked (c : Semantics.t) processes m =
  if m.collide && Model.stops_walkers c.setting.model && candidates c processes m = [] then stopping c processes m
  else []

(* {1 Clusters} *)

type cluster = { members : int list; meetings : meeting list }

let of_meeting m = { members = [ m.first; m.second ]; meetings = [ m ] }

(* A process that does not yield takes nothing of a change, and so links nobody. *)
let linked model (processes : State.process array) x y =
  let yields i = Option.is_some (Process.yielding_mass model processes.(i)) in
  List.exists (fun i -> List.mem i y.members && yields i) x.members

let merged x y =
  { members = List.sort_uniq Int.compare (x.members @ y.members); meetings = x.meetings @ y.meetings }

(* The clusters keep the order of their first meetings. *)
let add linked found x =
  let rec go before = function
    | [] -> List.rev (x :: before)
    | y :: rest when linked x y ->
      let apart, more = List.partition (fun z -> not (linked x z)) rest in
      let whole = List.fold_left merged y more in
      List.rev_append before (merged whole x :: apart)
    | y :: rest -> go (y :: before) rest
  in
  go [] found

let clusters (c : Semantics.t) processes =
  let single = List.map of_meeting (List.filter (fun m -> blocked c processes m = []) (meetings c processes)) in
  match c.setting.model.collisions with
  | In_turn | Drawn -> single
  | Together -> List.fold_left (add (linked c.setting.model processes)) [] single

(* {1 Rule Bounce} *)

(* The parts that touch, of processes that collide. Some of bodies that turn are only near each other. *)
let hits (c : Semantics.t) meetings =
  let (module K) = c.kinematics in
  let turns = Option.is_some c.setting.model.rigid in
  let touch (a, b) = (not turns) || K.touching c.setting a b <> [] in
  List.concat_map (fun m -> List.filter touch m.touching) meetings
  |> List.map (fun (a, b) -> Transition.hit (Part.name a) (Part.name b))
  |> List.sort_uniq Transition.compare_hit

let bounce (c : Semantics.t) (processes : State.process array) { members; meetings } =
  let (module K) = c.kinematics in
  let gone = List.map (fun i -> processes.(i)) members in
  let firsts = List.map (fun (p : State.process) -> p.leaves.(0).leaf) gone in
  let rec number k i = function
    | [] -> Scc_base.Bug.fail __POS__ "a meeting of others"
    | j :: rest -> if Int.equal i j then k else number (k + 1) i rest
  in
  let meetings = List.filter (fun m -> m.collide) meetings in
  let local m = { m with first = number 0 m.first members; second = number 0 m.second members } in
  match K.bounce c.setting (Array.of_list gone) (List.map local meetings) with
  | None -> Error (Transition.Persistent_contact firsts)
  | Some after ->
    let m = c.setting.model in
    let come = List.map (fun p -> Process.end_step m (Process.restart_clock m p)) (Array.to_list after) in
    let label = Transition.Bounce { firsts; hits = hits c meetings } in
    Ok { Transition.rule = Rule.Bounce; label; fired = []; gone; come }

let outcomes c processes cluster =
  match List.concat_map (candidates c processes) cluster.meetings with
  | [] -> Result.map (fun o -> [ o ]) (bounce c processes cluster)
  | candidates -> Ok candidates

(* {1 First time of contact} *)

(* The least time at which active surfaces of two parts meet that are open and compatible now. What is open does
   not change before the next horizon, and closed features meet no later than the parts interpenetrate. *)
let binding_time (c : Semantics.t) ~before:_ (a : Part.t) (b : Part.t) =
  let w = Part.relative_velocity a b in
  let corners (part : Part.t) (channel : Behaviour.channel) =
    List.map (Scc_rigid.Placed.corners part.placed) (Site.on part.index channel.sites)
  in
  let of_channels ((_, one, _, _), (_, two, _, _)) =
    List.concat_map
      (fun p -> List.filter_map (fun q -> c.setting.geometry.first_meeting p q w) (corners b two))
      (corners a one)
  in
  match List.concat_map of_channels (compatible c a.owner a.leaf.leaf b.owner b.leaf.leaf) with
  | [] -> None
  | t :: more -> Some (List.fold_left Rat.min t more)

let first_time_of_contact (c : Semantics.t) processes ~limit =
  let (module K) = c.kinematics in
  let parts = parts c processes in
  let contact = K.first_time_of_contact c.setting parts ~limit in
  if not (by_contact c) then contact
  else
    Option.merge Rat.min contact
      (c.setting.neighbours.earliest ~margin:Rat.zero ~limit (binding_time c) parts)
