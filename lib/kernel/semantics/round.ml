open Scc_exact
open Scc_calculus
open Scc_rigid

type apart = State.t -> (int * Rat.t) list -> (int * int) list

let replace (s : State.t) changes =
  let change i p = Option.value (List.assoc_opt i changes) ~default:p in
  State.mapi change s

let involves i (a, b) = Int.equal a i || Int.equal b i

(* Each time at least one fewer is left: what collides without any change does not begin a turn. *)
let rec at_once ~colliding s changes =
  match changes with
  | [] -> (s, [])
  | _ :: _ ->
    let trial = replace s changes in
    let hit = colliding trial in
    let waiting, going = List.partition (fun (i, _) -> List.exists (involves i) hit) changes in
    if waiting = [] then (trial, changes) else at_once ~colliding s going

let fixed m p = Option.is_none (State.mass m p)

let beginning ~colliding (s : State.t) =
  let due i = Turn.due s.processes.(i) in
  match List.filter due (List.init (Array.length s.processes) Fun.id) with
  | [] -> []
  | due ->
    let hit = colliding s in
    List.filter (fun i -> not (List.exists (involves i) hit)) due

let begun m (s : State.t) indices =
  let begin_turn i = if Turn.due s.processes.(i) then Some (i, Turn.begun m s.processes.(i)) else None in
  replace s (List.filter_map begin_turn indices)

(* {1 Orientations} *)

let reach m p centre =
  Array.fold_left
    (fun far (l : State.leaf) ->
       let parts = Array.length m.Model.leaves.(l.leaf).parts in
       List.fold_left (fun far i -> Rat.max far (Turn.reach m ~centre l i)) far (List.init parts Fun.id))
    Rat.zero p.State.leaves

(* The shortest of those of its leaves: of leaves that have the same it does not matter which one is meant. *)
let reference (p : State.process) =
  let shorter (best : Quaternion.t) (l : State.leaf) =
    if Quaternion.compare_lengths l.turned best < 0 then l.turned else best
  in
  Array.fold_left shorter p.leaves.(0).turned p.leaves

let rounded_orientation m k (p : State.process) =
  let old = reference p in
  let rounded = Quaternion.round k old in
  if fixed m p || Quaternion.equal old rounded then None
  else
    let centre = State.centre_of_mass m p in
    let turn = Quaternion.mul rounded (Quaternion.inverse old) in
    let move (l : State.leaf) =
      {
        l with
        position = Vec.add centre (Quaternion.apply turn (Vec.sub l.position centre));
        turned = Quaternion.mul turn l.turned;
      }
    in
    (* the spin of a free body follows from how it is turned *)
    Some (Turn.renew m (State.map_leaves move p), Rat.mul (Quaternion.round_error k) (reach m p centre))

let each (s : State.t) indices f =
  List.filter_map (fun i -> Option.map (fun x -> (i, x)) (f s.processes.(i))) indices

let orientations m k ~near ~colliding s indices =
  match each s indices (rounded_orientation m k) with
  | [] -> (s, [])
  | all ->
    let close = near s (List.map (fun (i, (_, by)) -> (i, by)) all) in
    let free (i, (p, _)) = if List.exists (involves i) close then None else Some (i, p) in
    at_once ~colliding s (List.filter_map free all)

(* {1 Velocities} *)

let quantum k = Rat.make Z.one (Z.shift_left Z.one k)

let nearest quantum (v : Vec.t) =
  let round x = Rat.round_to x ~quantum in
  Vec.make (round v.x) (round v.y) (round v.z)

(* An angular momentum is in proportion to inertia: the trace is that of the body however it is turned. *)
let kept m k (p : State.process) =
  if Vec.is_zero p.kept then p.kept
  else
    match Turn.mass_from_first m p with
    | Some mass -> nearest (Rat.mul (quantum k) (Mass.scale mass)) p.kept
    | None -> p.kept

(* What a free body has for a spin follows from what it keeps. *)
let velocity m k (p : State.process) =
  let v = nearest (quantum k) p.velocity in
  let spin = if Turn.is_free m then p.spin else nearest (quantum k) p.spin and kept = kept m k p in
  if fixed m p || (Vec.equal v p.velocity && Vec.equal spin p.spin && Vec.equal kept p.kept) then None
  else
    let p = State.with_velocity v (State.with_turn ~spin ~since:p.since ~lasts:p.lasts p) in
    Some (if Vec.equal kept p.kept then p else Turn.renew m (State.with_kept kept p))

(* How a body is turned does not matter to the ball that it spins in. *)
let settled (m : Model.t) (p : State.process) =
  match m.round_velocity with
  | Some k when Turn.spinning p -> Option.is_none (velocity m k p)
  | Some _ | None -> true

let run (m : Model.t) ~colliding ~near s indices =
  let s, turned =
    match Option.bind m.rigid (fun r -> r.round_orientation) with
    | None -> (s, [])
    | Some k -> orientations m k ~near ~colliding s indices
  in
  let s, changed =
    match m.round_velocity with
    | None -> (s, [])
    | Some k -> at_once ~colliding s (each s indices (velocity m k))
  in
  (s, turned <> [] || changed <> [])
