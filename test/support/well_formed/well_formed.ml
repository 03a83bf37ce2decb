open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics

module Counts = Map.Make (Int)

type fault =
  | Lost_leaf of int
  | Repeated_leaf of int
  | Interpenetration of { first : int * int; second : int * int }
  | Bad_bond of State.bond
  | Loose_bond of State.bond
  | Not_a_tree of int
  | Bound_absorber of int
  | Moving_wall of int
  | Bad_clock of int
  | Bad_turn of int
  | Bad_step
  | Bad_lots
  | Bad_time

(* Each leaf of the model is in one process, once; or in none, if it may have been absorbed. *)
let check_leaves (m : Model.t) state =
  let add counts (l : State.leaf) =
    Counts.update l.leaf (fun n -> Some (1 + Option.value n ~default:0)) counts
  in
  let counts = List.fold_left add Counts.empty (State.leaves state) in
  let fault leaf =
    match Counts.find_opt leaf counts with
    | None when Model.absorbs m && not m.leaves.(leaf).fixed -> None
    | None -> Some (Lost_leaf leaf)
    | Some 1 -> None
    | Some _ -> Some (Repeated_leaf leaf)
  in
  List.filter_map fault (List.init (Array.length m.leaves) Fun.id)

(* Parts of one leaf and of one process must not interpenetrate either: so each counts as one of its own. *)
let check_overlaps (c : Semantics.t) (state : State.t) =
  let alone i (p : Part.t) = { p with process = i } in
  let parts = Array.mapi alone (Collisions.parts c state.processes) in
  let fault ((a : Part.t), (b : Part.t)) =
    match c.setting.geometry.relation a.placed b.placed with
    | Interpenetrating -> Some (Interpenetration { first = Part.name a; second = Part.name b })
    | Apart | Touching -> None
  in
  List.filter_map fault (c.setting.neighbours.within Rat.zero parts)

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

let part (parts : Part.t array) leaf index =
  Array.to_list parts |> List.find_opt (fun (p : Part.t) -> p.leaf.leaf = leaf && p.index = index)

(* Definition 5.2: the two features touch, or are within the resolution (rule Near). *)
let check_bond (c : Semantics.t) parts p (bond : State.bond) =
  let (module K) = c.kinematics in
  match (find_end c.setting.model p bond.one, find_end c.setting.model p bond.two) with
  | Some (l1, p1), Some (l2, p2) when not (Int.equal l1.leaf l2.leaf) -> (
      match (part parts l1.leaf p1, part parts l2.leaf p2) with
      | Some a, Some b when K.bonded c.setting (a, bond.one.site.feature) (b, bond.two.site.feature) -> None
      | _ -> Some (Loose_bond bond))
  | _ -> Some (Bad_bond bond)

let clock_is_right (m : Model.t) (p : State.process) =
  match (p.clock, Process.weak_split_enabled m p) with
  | None, false -> true
  | Some c, true -> (
      match m.splits with
      | Every step -> Rat.sign c >= 0 && Rat.compare c step < 0
      | Any_time -> Rat.sign c = 0)
  | Some _, false | None, true -> false

(* Bonds are in the order of their ends, but those of two leaves need not follow each other. *)
let joined_once (p : State.process) =
  let ends (b : State.bond) = (b.one.at, b.two.at) in
  let compare (i, j) (k, l) = if i <> k then Int.compare i k else Int.compare j l in
  let joined = List.map ends (Array.to_list p.bonds) in
  List.length (List.sort_uniq compare joined) = List.length joined

(* A tree, or any connected graph in which no two leaves are joined twice (reading I-37). *)
let bonds_are_right (m : Model.t) (p : State.process) =
  (if Model.closes_rings m then joined_once p else Array.length p.bonds = Array.length p.leaves - 1)
  &&
  match State.components p.leaves p.bonds with
  | [ _ ] -> true
  | _ -> false

let check_process (c : Semantics.t) i (p : State.process) =
  let (module K) = c.kinematics in
  let m = c.setting.model in
  let parts = Collisions.parts c [| p |] in
  let bonds = List.filter_map (check_bond c parts p) (Array.to_list p.bonds) in
  let bad_ends =
    List.exists
      (function
        | Bad_bond _ -> true
        | _ -> false)
      bonds
  in
  let wall = Array.exists (fun (l : State.leaf) -> m.leaves.(l.leaf).fixed) p.leaves in
  let absorbs = Array.exists (fun (l : State.leaf) -> m.leaves.(l.leaf).absorbs) p.leaves in
  let faults =
    [
      ((not bad_ends) && not (bonds_are_right m p), Not_a_tree i);
      (absorbs && Array.length p.leaves > 1, Bound_absorber i);
      (wall && not (Vec.is_zero p.velocity && Vec.is_zero p.spin), Moving_wall i);
      ((not bad_ends) && not (clock_is_right m p), Bad_clock i);
      (not (K.turns_rightly c.setting p), Bad_turn i);
    ]
  in
  List.append bonds @@ List.filter_map (fun (holds, fault) -> if holds then Some fault else None) faults

(* The laws of all leaves are asked at once; only what has just been bound remembers several times. *)
let own_step_is_right (m : Model.t) (p : State.process) =
  let waited = p.leaves.(0).waited in
  let alike (l : State.leaf) = Rat.equal l.waited waited in
  let since (l : State.leaf) = Rat.sign l.waited >= 0 && Rat.compare l.waited m.timestep <= 0 in
  let none = Rat.sign waited = 0 && Array.for_all alike p.leaves in
  match p.phase with
  | None -> none && not (Model.of_each m && Process.steers m p)
  | Some _ when not (Model.of_each m && Process.steers m p) -> false
  | Some Due -> Array.for_all since p.leaves
  | Some Steered -> none
  | Some Moving -> Array.for_all alike p.leaves && Rat.sign waited > 0 && Rat.compare waited m.timestep < 0

let step_is_right (m : Model.t) (s : State.t) =
  match s.step with
  | None -> not (Model.of_all m) && Array.for_all (own_step_is_right m) s.processes
  | Some { remaining; phase } -> (
      Model.of_all m
      && Array.for_all (own_step_is_right m) s.processes
      && Rat.compare remaining m.timestep <= 0
      &&
      match phase with
      | Due -> Rat.sign remaining >= 0 (* a collision cuts a step short *)
      | Moving | Steered -> Rat.sign remaining > 0)

(* Only while somebody waits, and then of all whose laws are asked. *)
let draw_is_right (m : Model.t) (s : State.t) =
  let is_asked (p : State.process) =
    Process.steers m p
    &&
    match (s.step, p.phase) with
    | Some { phase = Due; _ }, _ | None, Some Due -> true
    | Some { phase = Moving | Steered; _ }, _ | None, (None | Some (Moving | Steered)) -> false
  in
  let right (p : State.process) =
    match p.draw with
    | None -> Option.is_none s.step || not (is_asked p)
    | Some Waits -> is_asked p && Process.draws m p
    | Some (Drawn _) -> is_asked p
  in
  let waits (p : State.process) = match p.draw with Some Waits -> true | Some (Drawn _) | None -> false in
  if Array.exists waits s.processes then Array.for_all right s.processes
  else Array.for_all (fun (p : State.process) -> Option.is_none p.draw) s.processes

(* Split instants are those of the network, and lots are pending at them alone, for bonds that are there. All are
   drawn before one bond is released before others. *)
let lots_are_right (m : Model.t) (s : State.t) =
  let is_first (_, (lot : State.lot)) = match lot with Next _ -> true | Undecided | Let_go _ -> false in
  let one_first cluster = List.compare_length_with (List.filter is_first cluster) 1 <= 0 in
  let right (since : Rat.t) (p : State.process) =
    match p.lots with
    | None -> false
    | Some lots ->
      let of_bond (b, (lot : State.lot)) =
        Array.exists (State.equal_bond b) p.bonds
        && match lot with
        | Undecided -> Option.is_some (Lots.sides Chances.rationals m p b)
        | Let_go _ | Next _ -> true
      in
      Rat.equal lots.since since
      && (lots.pending = [] || Rat.sign since = 0)
      && List.for_all of_bond lots.pending
      && List.for_all one_first (Lots.clusters lots.pending)
  in
  let has_first (p : State.process) =
    match p.lots with Some { pending; _ } -> List.exists is_first pending | None -> false
  in
  let drawn = not (Array.exists Lots.some_undecided s.processes) in
  let lots (p : State.process) = Option.is_some p.lots in
  match (m.lots, m.splits) with
  | true, Any_time -> false
  | false, _ -> not (Array.exists lots s.processes)
  | true, Every step -> (
      match Array.to_list s.processes with
      | [] -> true
      | { lots = Some { since; _ }; _ } :: _ ->
        Rat.sign since >= 0 && Rat.compare since step < 0
        && Array.for_all (right since) s.processes
        && (drawn || not (Array.exists has_first s.processes))
      | { lots = None; _ } :: _ -> false)

let time_is_right (m : Model.t) (s : State.t) =
  match s.time with
  | None -> not m.keeps_time
  | Some t -> m.keeps_time && Rat.sign t >= 0

let check (c : Semantics.t) (s : State.t) =
  let m = c.setting.model in
  let processes = List.concat (List.mapi (check_process c) (Array.to_list s.processes)) in
  List.concat
    [
      check_leaves m s;
      check_overlaps c s;
      processes;
      (if step_is_right m s && draw_is_right m s then [] else [ Bad_step ]);
      (if lots_are_right m s then [] else [ Bad_lots ]);
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
  | Interpenetration { first; second } ->
    Printf.sprintf "`%s` and `%s` interpenetrate" (part first) (part second)
  | Bad_bond b ->
    Printf.sprintf "a bond `%s` between `%s` and `%s` names what is not there" b.name (leaf b.one.at)
      (leaf b.two.at)
  | Loose_bond b -> Printf.sprintf "the features of the bond %s do not touch" (bond_to_string m b)
  | Not_a_tree i when Model.closes_rings m ->
    Printf.sprintf "the bonds of the process of `%s` do not join it, or join two leaves twice" (process i)
  | Not_a_tree i -> Printf.sprintf "the bonds of the process of `%s` are not a tree" (process i)
  | Bound_absorber i -> Printf.sprintf "in the process of `%s` an absorbing body is bound" (process i)
  | Moving_wall i -> Printf.sprintf "the process of `%s` holds a fixed body and moves" (process i)
  | Bad_clock i -> Printf.sprintf "the split clock of the process of `%s` is wrong" (process i)
  | Bad_turn i -> Printf.sprintf "the process of `%s` turns as it cannot" (process i)
  | Bad_step -> "the movement step is wrong"
  | Bad_lots -> "the lots of a split instant are wrong"
  | Bad_time -> "the time is wrong"
