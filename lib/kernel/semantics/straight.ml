open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_rigid
open Kinematics

(* {1 Contact} *)

let parts { model; _ } process (owner : State.process) =
  let of_leaf (leaf : State.leaf) =
    let of_part index (part : Model.part) =
      let at = if Vec.is_zero part.offset then leaf.position else Vec.add leaf.position part.offset in
      let placed = { Placed.solid = part.solid; turned = leaf.turned; at } in
      { Part.process; owner; leaf; index; placed; centre = at }
    in
    List.mapi of_part (Array.to_list model.leaves.(leaf.leaf).parts)
  in
  List.concat_map of_leaf (Array.to_list owner.leaves)

let margin _ = Rat.zero
let interpenetration () = Scc_base.Bug.fail __POS__ "two bodies interpenetrate"

let contact c (a : Part.t) (b : Part.t) : contact =
  match c.geometry.relation a.placed b.placed with
  | Apart -> Apart
  | Touching ->
    if c.geometry.approaching a.placed b.placed (Part.relative_velocity a b) then Colliding else Touching
  | Interpenetrating -> interpenetration ()

let touching c (a : Part.t) (b : Part.t) =
  match c.geometry.relation a.placed b.placed with
  | Touching -> c.geometry.touching a.placed b.placed
  | Apart | Interpenetrating -> []

let near c (a : Part.t) (b : Part.t) = c.geometry.near ~resolution:Rat.zero a.placed b.placed

let bonded c ((a : Part.t), one) ((b : Part.t), two) =
  let is_bond (pair : Contact.pair) = Feature.equal pair.first one && Feature.equal pair.second two in
  List.exists is_bond (touching c a b)

let collision_time c ~before:_ (a : Part.t) (b : Part.t) =
  match c.geometry.first_time_of_contact a.placed b.placed (Part.relative_velocity a b) with
  | Never -> None
  | At t -> Some t
  | Inside -> interpenetration ()

let first_time_of_contact c parts ~limit =
  c.neighbours.earliest ~margin:Rat.zero ~limit (collision_time c) parts

let none_ahead c parts = Option.is_none (first_time_of_contact c parts ~limit:None)

(* {1 What happens to processes} *)

(* Where velocities are rounded a turn of length 0 is due of what has come to be, as of what does not spin in a
   rigid model (rule Round). *)
let renewed { model; _ } p =
  match model.round_velocity with
  | None -> p
  | Some _ -> State.with_turn ~spin:Vec.zero ~since:Rat.zero ~lasts:None p

(* A separating direction n of two processes is a row n.(v' - v); no impulse changes a body that does not yield. *)
let row model (processes : State.process array) first second n : Reflection.row =
  let part i push =
    let change mass = Vec.scale (Rat.div Rat.one mass) push in
    (i, push, Option.fold (Process.yielding_mass model processes.(i)) ~none:Vec.zero ~some:change)
  in
  [ part first (Vec.neg n); part second n ]

let rows c (processes : State.process array) (m : meeting) =
  let w = Vec.sub processes.(m.second).velocity processes.(m.first).velocity in
  let placed ((a : Part.t), (b : Part.t)) = (a.placed, b.placed) in
  List.map (row c.model processes m.first m.second) (c.geometry.directions (List.map placed m.touching) w)

let bounce c (processes : State.process array) meetings =
  let q = Array.map (fun (p : State.process) -> p.velocity) processes in
  let rows = Array.of_list (List.concat_map (rows c processes) meetings) in
  let after p velocity = renewed c (State.with_velocity velocity p) in
  Option.map (Array.map2 after processes) (Reflection.reflect q rows)

(* Conservation of linear momentum; what binds to a fixed body stops. *)
let joined ({ model; _ } as c) (p : State.process) (q : State.process) whole =
  let velocity =
    match (State.mass model p, State.mass model q) with
    | Some mp, Some mq ->
      Vec.scale
        (Rat.div Rat.one (Rat.add mp mq))
        (Vec.add (Vec.scale mp p.velocity) (Vec.scale mq q.velocity))
    | None, _ | _, None -> Vec.zero
  in
  renewed c (State.with_velocity velocity whole)

let piece c ~whole (piece : State.process) = renewed c (State.with_velocity whole.State.velocity piece)

let pushed c ~at:_ impulse (p : State.process) =
  match State.mass c.model p with
  | None -> p
  | Some mass -> State.with_velocity (Vec.axpy (Rat.div Rat.one mass) impulse p.velocity) p

let start = renewed

(* {1 Turns} *)

let time_rules = [ Rule.Time; Time_behaviour ]
let at_contact _ ~colliding:_ s = s

let begin_turns c ~parts:_ ~colliding before =
  match Round.beginning ~colliding before with
  | [] -> (before, None)
  | indices ->
    let s, changed = Round.run c.model ~colliding ~near:(fun _ _ -> []) before indices in
    (Round.begun c.model s indices, if changed then Some before else None)

let turns_rightly { model; _ } (p : State.process) =
  Vec.is_zero p.spin
  && Rat.sign p.since = 0
  && (match p.lasts with None -> Option.is_some model.round_velocity | Some d -> Rat.sign d = 0)
  && Array.for_all (fun (l : State.leaf) -> Quaternion.is_identity l.turned) p.leaves

let settled _ _ = true
