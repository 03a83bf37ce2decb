open Scc_exact
open Scc_calculus

(* What a bounded law may give. *)
type given = { speed2 : Rat.t; velocities : int }

let looks_at_mass_alone =
  let beyond : Law.variable -> bool = function
    | Mass -> false
    | X | Y | Z | Vx | Vy | Vz | Wx | Wy | Wz | Time | Dt -> true
  in
  fun law -> not (Law.mentions beyond law)

(* None where the law is not bounded, or is in error. *)
let given (leaf : Model.leaf) =
  let eval e = Result.to_option (Law.eval (fun _ -> leaf.mass) e) in
  let speed2 (x, y, z) =
    match (eval x, eval y, eval z) with
    | Some x, Some y, Some z -> Some (Vec.norm2 (Vec.make x y z))
    | _ -> None
  in
  let add sum (kick : Law.kick) =
    match (sum, speed2 kick.motion.velocity, eval kick.weight) with
    | Some (greatest, total), Some v2, Some weight when Rat.sign weight >= 0 ->
      Some (Rat.max greatest v2, Rat.add total weight)
    | _ -> None
  in
  if not (looks_at_mass_alone leaf.law) then None
  else
    match leaf.law with
    | Inertial -> Some { speed2 = Rat.zero; velocities = 1 }
    | Gives m -> Option.map (fun speed2 -> { speed2; velocities = 1 }) (speed2 m.velocity)
    | Choose kicks -> (
        match List.fold_left add (Some (Rat.zero, Rat.zero)) kicks with
        | Some (speed2, total) when Rat.sign total > 0 -> Some { speed2; velocities = List.length kicks }
        | _ -> None)

let allows (m : Model.t) =
  let laws = List.filter (fun (l : Model.leaf) -> not (Law.is_inertial l.law)) (Array.to_list m.leaves) in
  let draws (l : Model.leaf) = Law.draws l.law in
  List.for_all (fun l -> Option.is_some (given l)) laws
  && (List.for_all draws laws || not (List.exists draws laws))

type t = {
  first : Rat.t;  (** the energy at the start *)
  laws : Rat.t;  (** what laws give to the leaves that they move, at most *)
  free : bool;  (** some leaf that is not fixed is under no law *)
  driven : bool;
  velocities : int;  (** that they may draw together, or more than {!Law.most_outcomes} *)
}

let times a b = if a > Law.most_outcomes / b then Law.most_outcomes + 1 else a * b

let add a b =
  {
    first = Rat.add a.first b.first;
    laws = Rat.add a.laws b.laws;
    free = a.free || b.free;
    driven = a.driven || b.driven;
    velocities = times a.velocities b.velocities;
  }

let of_process (m : Model.t) (p : State.process) =
  let of_leaf (l : State.leaf) =
    let leaf = m.leaves.(l.leaf) in
    let driven = not (leaf.fixed || Law.is_inertial leaf.law) in
    match given leaf with
    | None when driven -> Scc_base.Bug.fail __POS__ "a law that is not bounded"
    | Some { speed2; velocities } when driven ->
      { first = Rat.zero; laws = Rat.mul leaf.mass speed2; free = false; driven; velocities }
    | _ -> { first = Rat.zero; laws = Rat.zero; free = not leaf.fixed; driven; velocities = 1 }
  in
  let still = { first = Rat.zero; laws = Rat.zero; free = false; driven = false; velocities = 1 } in
  let leaves = Array.fold_left (fun sum l -> add sum (of_leaf l)) still p.leaves in
  (* Of who is about to have a new velocity the old one counts no more, but for leaves that ask for no change of
     it. *)
  let renewed = Option.is_some p.draw && not leaves.free in
  match State.mass m p with
  | Some mass when not renewed -> { leaves with first = Rat.mul mass (Vec.norm2 p.velocity) }
  | Some _ | None -> leaves

let driven t = t.driven
let may_draw t = t.velocities <= Law.most_outcomes

(* Laws are asked once right now, and then each time that a timestep is over. *)
let times_asked (m : Model.t) h = Rat.make (Z.succ (Rat.floor (Rat.div h m.timestep))) Z.one

let energy (m : Model.t) ~horizon ~collide t =
  match horizon with
  | _ when not t.driven -> Some t.first
  | _ when collide && Model.of_each m -> None
  | _ when not t.free -> Some (Rat.max t.first t.laws)
  | Some h when Model.keeps_beat m -> Some (Rat.add t.first (Rat.mul (times_asked m h) t.laws))
  | Some _ | None -> None

let may_release (m : Model.t) (p : State.process) =
  let releases : Behaviour.t -> bool = function
    | Weak _ | Strong _ -> true
    | Nil | Open _ | Delay _ | Wait _ | Sum _ | Call _ -> false
  in
  let may (l : State.leaf) =
    Behaviour.some_prefix m.definitions ~behind:(fun _ -> true) releases l.behaviour.term
  in
  Array.length p.leaves > 1 && Array.exists may p.leaves

(* Where walkers stop and nothing else moves, all velocities are mixtures of the first ones, of kicks and of 0. *)
let of_walkers (m : Model.t) (s : State.t) =
  let kick speed2 (l : Model.leaf) =
    Option.map2 Rat.max speed2 (if l.fixed then Some Rat.zero else Option.map (fun g -> g.speed2) (given l))
  in
  let first = List.map (fun (p : State.process) -> Vec.norm2 p.velocity) (Array.to_list s.processes) in
  let all_draw = Array.for_all (fun (l : Model.leaf) -> l.fixed || Law.draws l.law) m.leaves in
  if all_draw then Array.fold_left kick (Some (snd (Rat.span Rat.zero first))) m.leaves else None

let speeds (m : Model.t) (s : State.t) ~horizon =
  let of_all speed2 = Array.map (fun (l : Model.leaf) -> if l.fixed then Rat.zero else speed2 l) m.leaves in
  if Model.has_turns m || Parameters.may_push m s || not (allows m) then None
  else if Model.stops_walkers m then Option.map (fun speed2 -> of_all (fun _ -> speed2)) (of_walkers m s)
  else if m.lots || Model.binds_on_contact m then None
  else
    match Array.to_list (Array.map (of_process m) s.processes) with
    | [] -> None
    | first :: rest ->
      let all = energy m ~horizon:(Some horizon) ~collide:true (List.fold_left add first rest) in
      Option.map (fun all -> of_all (fun l -> Rat.div all l.mass)) all
