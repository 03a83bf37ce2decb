open Scc_geometry
open Scc_calculus

type meeting = {
  first : int;
  second : int;
  touching : (Part.t * Part.t) list;
}

let parts (c : Semantics.t) processes =
  let (module K) = c.kinematics in
  Array.of_list (List.concat (List.mapi (K.parts c.setting) (Array.to_list processes)))

(* Those of two processes together, in order. *)
let by_processes pairs =
  let compare (_, ((a : Part.t), (b : Part.t))) (_, ((a' : Part.t), (b' : Part.t))) =
    let c = Int.compare a.process a'.process in
    if c <> 0 then c else Int.compare b.process b'.process
  in
  let group groups pair =
    match groups with
    | (other :: _ as group) :: rest when compare pair other = 0 -> (pair :: group) :: rest
    | _ -> [ pair ] :: groups
  in
  List.stable_sort compare pairs |> List.fold_left group [] |> List.rev_map List.rev

let meetings (c : Semantics.t) processes =
  let (module K) = c.kinematics in
  let judged (a, b) =
    if not (Part.in_relative_motion a b) then None
    else
      match K.contact c.setting a b with
      | Apart -> None
      | (Touching | Colliding) as contact -> Some (contact, (a, b))
  in
  let colliding = function
    | (Kinematics.Colliding, pair) -> Some pair
    | (Touching | Apart), _ -> None
  in
  let meeting touching =
    match List.find_map colliding touching with
    | None -> None
    | Some (a, b) ->
      Some { first = a.Part.process; second = b.Part.process; touching = List.map snd touching }
  in
  let parts = parts c processes in
  if Part.move_alike parts then []
  else
    c.setting.neighbours.within (K.margin c.setting) parts
    |> List.filter_map judged |> by_processes |> List.filter_map meeting

let colliding c (s : State.t) = List.map (fun m -> (m.first, m.second)) (meetings c s.processes)
let collides c (s : State.t) = meetings c s.processes <> []

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

(* The touching pairs that two channels share, of the highest dimension among them. *)
let shared_pairs pairs ~active_one ~active_two =
  let shared = List.filter (fun (c : Contact.pair) -> active_one c.first && active_two c.second) pairs in
  let highest = List.fold_left (fun d (c : Contact.pair) -> Int.max d c.dimension) 0 shared in
  List.filter (fun (c : Contact.pair) -> c.dimension = highest) shared

let joined (c : Semantics.t) (p : State.process) (q : State.process) bond continuations =
  let (module K) = c.kinematics in
  let leaves = Array.to_list (Array.append p.leaves q.leaves) |> List.map (Process.continue continuations) in
  let bonds = bond :: Array.to_list (Array.append p.bonds q.bonds) in
  State.process ~leaves ~bonds ~velocity:Scc_exact.Vec.zero ~clock:None ()
  |> Process.restart_clock c.setting.model |> K.joined c.setting p q

(* The candidates of two parts that touch, of two processes that collide. *)
let bind (c : Semantics.t) p q ((a : Part.t), (b : Part.t)) =
  let (module K) = c.kinematics in
  let site (part : Part.t) feature : Site.t = { part = part.index; feature } in
  let fit ((pol1, (c1 : Behaviour.channel), _, _), (pol2, (c2 : Behaviour.channel), _, _)) =
    complementary pol1 pol2 && String.equal c1.name c2.name
  in
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
        {
          Transition.rule = Rule.Bind;
          label = Bind bond;
          fired = [ [ one; two ] ];
          gone = [ p; q ];
          come = [ joined c p q bond [ (a.leaf.leaf, b1); (b.leaf.leaf, b2) ] ];
        })
  in
  let ones = open_channels c.setting.model p a.leaf.leaf and twos = open_channels c.setting.model q b.leaf.leaf in
  let pairs = List.concat_map (fun one -> List.map (fun two -> (one, two)) twos) ones in
  match List.filter fit pairs with
  | [] -> []
  | fitting -> List.concat_map (candidates (K.touching c.setting a b)) fitting

(* {1 Rule Bounce} *)

let bounce (c : Semantics.t) (p : State.process) (q : State.process) touching =
  let (module K) = c.kinematics in
  let first = p.leaves.(0).leaf and second = q.leaves.(0).leaf in
  match K.bounce c.setting p q touching with
  | Persistent -> Error (Transition.Persistent_contact (first, second))
  | Responded (p', q') ->
    let come = List.map (Process.restart_clock c.setting.model) [ p'; q' ] in
    Ok { Transition.rule = Rule.Bounce; label = Bounce (first, second); fired = []; gone = [ p; q ]; come }

let outcomes c processes meeting =
  let p = processes.(meeting.first) and q = processes.(meeting.second) in
  match List.concat_map (bind c p q) meeting.touching with
  | [] -> Result.map (fun o -> [ o ]) (bounce c p q meeting.touching)
  | candidates -> Ok candidates

(* {1 First time of contact} *)

let first_time_of_contact (c : Semantics.t) processes ~limit =
  let (module K) = c.kinematics in
  K.first_time_of_contact c.setting (parts c processes) ~limit
