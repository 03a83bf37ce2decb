open Scc_base
open Scc_exact
open Scc_geometry
open Scc_rigid

type fault =
  | Lost_leaf of int
  | Repeated_leaf of int
  | Interpenetration of { first : int * int; second : int * int; point : Vec.t option }
  | Bad_bond of State.bond
  | Loose_bond of State.bond
  | Not_a_tree of int
  | Moving_wall of int
  | Bad_clock of int
  | Bad_turn of int
  | Bad_step
  | Bad_time

let leaves (state : State.t) =
  Array.to_list state.processes
  |> List.concat_map (fun (p : State.process) -> Array.to_list p.leaves)

(* Each leaf of the model is in one process, once. *)
let check_leaves (m : Model.t) state =
  let count = Array.make (Array.length m.leaves) 0 in
  List.iter (fun (l : State.leaf) -> count.(l.leaf) <- count.(l.leaf) + 1) (leaves state);
  Array.to_list count
  |> Long_list.mapi (fun leaf n -> (leaf, n))
  |> List.filter_map (fun (leaf, n) ->
      match n with
      | 0 -> Some (Lost_leaf leaf)
      | 1 -> None
      | _ -> Some (Repeated_leaf leaf))

(* Every part in the world, with its leaf and its index. *)
let parts (m : Model.t) state =
  let of_leaf (l : State.leaf) =
    Array.to_list m.leaves.(l.leaf).parts
    |> Long_list.mapi (fun i (part : Model.part) ->
        let placed =
          { Overlap.body = l.leaf; solid = part.solid; position = State.part_position m l i }
        in
        ((l, i), placed))
  in
  Array.of_list (List.concat_map of_leaf (leaves state))

(* Solids that are turned are made anew, with numbers of their own: the obstacles of the model do not know them. *)
let as_turned k ((l : State.leaf), (placed : Overlap.placed)) =
  let polyhedron = placed.solid.polyhedron in
  let linear = Mat.mul (Quaternion.to_mat l.turned) placed.solid.linear in
  { placed with solid = Solid.make ~id:k polyhedron linear }

let check_overlaps (m : Model.t) state =
  let parts = parts m state in
  let obstacles, placed =
    match m.rigid with
    | None -> (m.obstacles, Array.map snd parts)
    | Some _ -> (Obstacle_cache.create (), Array.mapi (fun k ((l, _), p) -> as_turned k (l, p)) parts)
  in
  let name i =
    let (l : State.leaf), part = fst parts.(i) in
    (l.leaf, part)
  in
  let fault (i, j) =
    let point = Overlap.common_point placed.(i) placed.(j) in
    Interpenetration { first = name i; second = name j; point }
  in
  Long_list.map fault (Overlap.pairs obstacles placed)

let has_feature (polyhedron : Polyhedron.t) : Feature.t -> bool = function
  | Vertex i -> 0 <= i && i < Array.length polyhedron.vertices
  | Edge i -> 0 <= i && i < Array.length polyhedron.edges
  | Face i -> 0 <= i && i < Array.length polyhedron.faces

(* The leaves of a process are in order. *)
let find_leaf (p : State.process) leaf =
  let rec search low high =
    if low >= high then None
    else
      let middle = (low + high) / 2 in
      let c = Int.compare leaf p.leaves.(middle).leaf in
      if c = 0 then Some p.leaves.(middle) else if c < 0 then search low middle else search (middle + 1) high
  in
  search 0 (Array.length p.leaves)

(* The leaf, in this process, and its part at one end of a bond. *)
let find_end (m : Model.t) (p : State.process) (f : State.finish) =
  match find_leaf p f.at with
  | None -> None
  | Some l ->
    let parts = m.leaves.(l.leaf).parts in
    let i = f.site.part in
    if 0 <= i && i < Array.length parts && has_feature parts.(i).solid.polyhedron f.site.feature then
      Some (l, i)
    else None

(* Definition 5.2 asks that the two touch; of turning bodies, within the resolution (rule Near). *)
let near (m : Model.t) resolution (l1, p1) (l2, p2) (bond : State.bond) =
  let corners l part (f : State.finish) = Placed.corners (State.placed m l part) f.site.feature in
  Near_contact.within ~resolution (corners l1 p1 bond.one) (corners l2 p2 bond.two)

let check_bond (m : Model.t) p (bond : State.bond) =
  match (find_end m p bond.one, find_end m p bond.two, m.rigid) with
  | Some (l1, p1), Some (l2, p2), Some rigid when not (Int.equal l1.leaf l2.leaf) ->
    (* features whose projections meet are at most so far apart *)
    let resolution = Rat.mul (Rat.of_int 2) rigid.resolution in
    if near m resolution (l1, p1) (l2, p2) bond then None else Some (Loose_bond bond)
  | Some (l1, p1), Some (l2, p2), None when not (Int.equal l1.leaf l2.leaf) ->
    let obstacle = Model.obstacle m (l1.leaf, p1) (l2.leaf, p2) in
    let offset = Vec.sub (State.part_position m l2 p2) (State.part_position m l1 p1) in
    let is_bond (c : Contact.pair) =
      Feature.equal c.first bond.one.site.feature && Feature.equal c.second bond.two.site.feature
    in
    let touches =
      match Obstacle.relation obstacle offset with
      | Touching -> List.exists is_bond (Contact.touching obstacle offset)
      | Apart | Interpenetrating -> false
    in
    if touches then None else Some (Loose_bond bond)
  | _ -> Some (Bad_bond bond)

let weak_split_enabled (m : Model.t) (p : State.process) =
  let offers (f : State.finish) name =
    match find_leaf p f.at with
    | None -> false
    | Some l ->
      let releases : Behaviour.offer -> bool = function
        | Offer_weak (c, _) -> String.equal c.name name && Behaviour.active c f.site
        | Offer_open _ | Offer_strong _ -> false
      in
      List.exists releases (Behaviour.offers m.definitions l.behaviour)
  in
  Array.exists (fun (b : State.bond) -> offers b.one b.name && offers b.two b.name) p.bonds

let clock_is_right (m : Model.t) (p : State.process) =
  match (p.clock, weak_split_enabled m p) with
  | None, false -> true
  | Some c, true -> Rat.sign c >= 0 && Rat.compare c m.split_step < 0
  | Some _, false | None, true -> false

let turn_is_right (m : Model.t) (p : State.process) =
  match m.rigid with
  | Some { dynamics = Constant_spin; _ } when not (Vec.is_zero p.kept) -> false
  | Some _ -> Rat.sign p.since = 0 || (Rat.sign p.since > 0 && not (Vec.is_zero p.spin))
  | None ->
    Vec.is_zero p.spin
    && Rat.sign p.since = 0
    && Array.for_all (fun (l : State.leaf) -> Quaternion.is_identity l.turned) p.leaves

let is_tree (p : State.process) =
  Array.length p.bonds = Array.length p.leaves - 1
  &&
  match State.components p.leaves p.bonds with
  | [ _ ] -> true
  | _ -> false

let check_process (m : Model.t) i (p : State.process) =
  let bonds = List.filter_map (check_bond m p) (Array.to_list p.bonds) in
  let bad_ends =
    List.exists
      (function
        | Bad_bond _ -> true
        | _ -> false)
      bonds
  in
  let wall = Array.exists (fun (l : State.leaf) -> m.leaves.(l.leaf).fixed) p.leaves in
  let faults =
    [
      ((not bad_ends) && not (is_tree p), Not_a_tree i);
      (wall && not (Vec.is_zero p.velocity && Vec.is_zero p.spin), Moving_wall i);
      (not (clock_is_right m p), Bad_clock i);
      (not (turn_is_right m p), Bad_turn i);
    ]
  in
  Long_list.append bonds @@ List.filter_map (fun (holds, fault) -> if holds then Some fault else None) faults

let step_is_right (m : Model.t) (s : State.t) =
  match s.step with
  | None -> not m.steered
  | Some { remaining; length; phase } -> (
      m.steered
      && Rat.compare remaining length <= 0 && Rat.compare length m.timestep <= 0
      &&
      match phase with
      | Due -> Rat.sign remaining >= 0 (* a collision cuts a step short *)
      | Moving | Steered -> Rat.sign remaining > 0)

let time_is_right (m : Model.t) (s : State.t) =
  match s.time with
  | None -> not m.keeps_time
  | Some t -> m.keeps_time && Rat.sign t >= 0

let check (m : Model.t) (s : State.t) =
  let processes = Long_list.concat (Long_list.mapi (check_process m) (Array.to_list s.processes)) in
  Long_list.concat
    [
      check_leaves m s;
      check_overlaps m s;
      processes;
      (if step_is_right m s then [] else [ Bad_step ]);
      (if time_is_right m s then [] else [ Bad_time ]);
    ]

let bond_to_string (m : Model.t) (b : State.bond) =
  let finish (f : State.finish) = Model.site_name m ~leaf:f.at f.site in
  Printf.sprintf "<%s, {%s, %s}>" b.name (finish b.one) (finish b.two)

let to_string (m : Model.t) (s : State.t) fault =
  let leaf i = m.leaves.(i).name and part (l, p) = m.leaves.(l).parts.(p).name in
  let process i = leaf s.processes.(i).leaves.(0).leaf in
  match fault with
  | Lost_leaf i -> Printf.sprintf "`%s` is in no process" (leaf i)
  | Repeated_leaf i -> Printf.sprintf "`%s` is there more than once" (leaf i)
  | Interpenetration { first; second; point } ->
    let where =
      match point with
      | Some x -> Printf.sprintf ": the point %s is inside both" (Vec.to_string x)
      | None -> ""
    in
    Printf.sprintf "`%s` and `%s` interpenetrate%s" (part first) (part second) where
  | Bad_bond b ->
    Printf.sprintf "a bond `%s` between `%s` and `%s` names what is not there" b.name (leaf b.one.at)
      (leaf b.two.at)
  | Loose_bond b -> Printf.sprintf "the features of the bond %s do not touch" (bond_to_string m b)
  | Not_a_tree i -> Printf.sprintf "the bonds of the process of `%s` are not a tree" (process i)
  | Moving_wall i -> Printf.sprintf "the process of `%s` holds a fixed body and moves" (process i)
  | Bad_clock i -> Printf.sprintf "the split clock of the process of `%s` is wrong" (process i)
  | Bad_turn i -> Printf.sprintf "the process of `%s` turns as it cannot" (process i)
  | Bad_step -> "the movement step is wrong"
  | Bad_time -> "the time is wrong"
