open Scc_exact
open Scc_calculus
open Scc_rigid

let rigid (m : Model.t) =
  match m.rigid with
  | Some r -> r
  | None -> Scc_base.Bug.fail __POS__ "a translational model does not turn"

let spinning (p : State.process) = not (Vec.is_zero p.spin)

(* What a turn by a spin has done after a time. *)
let turned spin time = Quaternion.cayley (Vec.scale (Rat.mul Rat.half time) spin)

let pass m d (p : State.process) =
  if Rat.sign d = 0 then p
  else if not (spinning p) then
    if Vec.is_zero p.velocity then p
    else State.map_leaves (fun l -> { l with position = Vec.axpy d p.velocity l.position }) p
  else
    let since = Rat.add p.since d in
    let turn = Quaternion.mul (turned p.spin since) (Quaternion.inverse (turned p.spin p.since)) in
    let from = State.centre_of_mass m p in
    let centre = Vec.axpy d p.velocity from in
    let move (l : State.leaf) =
      {
        l with
        position = Vec.add centre (Quaternion.apply turn (Vec.sub l.position from));
        turned = Quaternion.mul turn l.turned;
      }
    in
    State.with_turn ~spin:p.spin ~since ~lasts:p.lasts (State.map_leaves move p)

let velocity_at m (p : State.process) x =
  if spinning p then Vec.add p.velocity (Vec.cross p.spin (Vec.sub x (State.centre_of_mass m p))) else p.velocity

(* {1 Mass} *)

let mass_parts (m : Model.t) (p : State.process) =
  let of_leaf (l : State.leaf) =
    Array.to_list m.leaves.(l.leaf).parts
    |> List.mapi (fun i (part : Model.part) -> { Mass.body = State.placed m l i; mass = part.mass })
  in
  List.concat_map of_leaf (Array.to_list p.leaves)

let mass m (p : State.process) = Option.map (fun _ -> Mass.of_parts (mass_parts m p)) (State.mass m p)

(* {1 Spin and angular momentum} *)

let is_free (m : Model.t) =
  match m.rigid with
  | Some { dynamics = Free_body; _ } -> true
  | Some { dynamics = Constant_spin; _ } | None -> false

(* Seen from a leaf, a process has the numbers that it was made with. From which leaf does not matter: what is
   computed from this mass is turned back, exactly. *)
let mass_from_first m (p : State.process) =
  let { State.position; turned; _ } = p.leaves.(0) in
  let back = Quaternion.inverse turned in
  let seen (l : State.leaf) =
    {
      l with
      position = Quaternion.apply back (Vec.sub l.position position);
      turned = Quaternion.mul back l.turned;
    }
  in
  mass m (State.map_leaves seen p)

(* I^-1 l when what has this mass is turned by q. *)
let turn_rate mass q l = Quaternion.apply q (Mass.turn_rate mass (Quaternion.apply (Quaternion.inverse q) l))

let settled_spin m (p : State.process) =
  if not (is_free m) then p.spin
  else if Vec.is_zero p.kept then Vec.zero
  else
    match mass_from_first m p with
    | Some mass -> turn_rate mass p.leaves.(0).turned p.kept
    | None -> Vec.zero

let mover m p : Impact.mover =
  { mass = mass m p; velocity = p.State.velocity; spin = settled_spin m p }

let renew m p = State.with_turn ~spin:(settled_spin m p) ~since:Rat.zero ~lasts:None p

let start m (p : State.process) =
  let p = State.with_turn ~spin:p.spin ~since:p.since ~lasts:None p in
  match mass m p with
  | Some mass when is_free m -> State.with_kept (Mat.apply mass.inertia p.State.spin) p
  | Some _ | None -> p

let moving m (mover : Impact.mover) p =
  State.with_velocity mover.velocity p |> State.with_turn ~spin:mover.spin ~since:Rat.zero ~lasts:None
  |> start m

let spun m spin p = start m (State.with_turn ~spin ~since:Rat.zero ~lasts:None p)
let piece m ~whole p = moving m (Impact.piece (mover m (renew m whole)) (mass m p)) p

(* Any spin would do: what a free body keeps is not computed from it. So an estimate has no more digits than it is
   worth, and orientations grow no faster than those of bodies that keep their spin. *)
let estimated_bits = 40

let estimate (v : Vec.t) =
  let greatest = Rat.max (Rat.abs v.x) (Rat.max (Rat.abs v.y) (Rat.abs v.z)) in
  if Rat.sign greatest = 0 then v
  else
    (* 2^e <= greatest < 2^(e + 1) *)
    let about = Z.numbits (Q.num greatest) - Z.numbits (Q.den greatest) in
    let e = if Rat.compare (Rat.power_of_two about) greatest <= 0 then about else about - 1 in
    let round x = Rat.round_to x ~quantum:(Rat.power_of_two (e - estimated_bits)) in
    Vec.make (round v.x) (round v.y) (round v.z)

(* {1 How long turns last} *)

(* |spin| d / 2 <= 1/4 *)
let fits spin d = Rat.compare (Rat.mul (Vec.norm2 spin) (Rat.mul d d)) (Rat.make Z.one (Z.of_int 4)) <= 0

let rec fitted spin d = if fits spin d then d else fitted spin (Rat.mul Rat.half d)
let length (m : Model.t) spin = if Vec.is_zero spin then Rat.zero else fitted spin m.timestep

(* {1 Turns that begin and end} *)

let due (p : State.process) = Option.is_none p.lasts
let begun m p = State.with_turn ~spin:p.State.spin ~since:Rat.zero ~lasts:(Some (length m p.spin)) p

(* I_mid = C I C^-1, with C the turn of half the time. *)
let midway m (p : State.process) =
  match if is_free m && spinning p then mass_from_first m p else None with
  | None -> None
  | Some mass ->
    let start = estimate p.spin in
    let rec attempt d =
      let half_way = Quaternion.mul (turned start (Rat.mul Rat.half d)) p.leaves.(0).turned in
      let spin = estimate (turn_rate mass half_way p.kept) in
      if fits spin d then State.with_turn ~spin ~since:Rat.zero ~lasts:(Some d) p else attempt (Rat.mul Rat.half d)
    in
    Some (attempt (length m p.spin))

let left (p : State.process) =
  match p.lasts with
  | Some d when spinning p -> Some (Rat.sub d p.since)
  | Some _ -> None
  | None -> Some Rat.zero

let goes_on (p : State.process) = spinning p && not (due p)

let ended m (p : State.process) =
  match left p with
  | Some d when Rat.sign d <= 0 -> renew m p
  | Some _ | None -> p

let motion (m : Model.t) (p : State.process) ~centre (l : State.leaf) part : Motion.t =
  let back = if spinning p then Quaternion.inverse (turned p.spin p.since) else Quaternion.identity in
  {
    solid = m.leaves.(l.leaf).parts.(part).solid;
    turned = Quaternion.mul back l.turned;
    arm = Quaternion.apply back (Vec.sub (State.part_position m l part) centre);
    centre;
    velocity = p.velocity;
    spin = p.spin;
    since = p.since;
  }

let reach (m : Model.t) ~centre (l : State.leaf) part =
  let solid = m.leaves.(l.leaf).parts.(part).solid in
  let arm = Vec.add (State.part_position m l part) (Quaternion.apply l.turned solid.centroid) in
  Speed.reach solid (Vec.sub arm centre)
