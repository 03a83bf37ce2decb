open Scc_exact
open Scc_geometry
open Scc_calculus

type touch = {
  one : int * int;
  two : int * int;
  obstacle : Obstacle.t;
  offset : Vec.t;
  approaching : bool;
}

type contact = { first : int; second : int; touches : touch list }

let relative_velocity (s : State.t) p q =
  Vec.sub s.processes.(q).velocity s.processes.(p).velocity

let touch_of m s (a : Parts.part) (b : Parts.part) =
  let obstacle = Model.obstacle m (a.leaf, a.part) (b.leaf, b.part) in
  let offset = Vec.sub b.position a.position in
  match Obstacle.relation obstacle offset with
  | Apart -> None
  | Touching ->
    let approaching = Obstacle.approaching obstacle offset (relative_velocity s a.process b.process) in
    Some { one = (a.leaf, a.part); two = (b.leaf, b.part); obstacle; offset; approaching }
  | Interpenetrating -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"

let contacts m s =
  let parts = Parts.of_state m s in
  let touches =
    Parts.near parts
    |> List.filter_map (fun (i, j) ->
        let a = parts.(i) and b = parts.(j) in
        Option.map (fun t -> ((a.process, b.process), t)) (touch_of m s a b))
  in
  let compare_keys ((p, q), _) ((p', q'), _) =
    let c = Int.compare p p' in
    if c <> 0 then c else Int.compare q q'
  in
  let group done_ ((first, second), t) =
    match done_ with
    | c :: rest when c.first = first && c.second = second -> { c with touches = t :: c.touches } :: rest
    | _ -> { first; second; touches = [ t ] } :: done_
  in
  List.stable_sort compare_keys touches
  |> List.fold_left group []
  |> List.rev_map (fun c -> { c with touches = List.rev c.touches })

let colliding c = List.exists (fun t -> t.approaching) c.touches

type outcome = { label : Transition.label; rules : Rule.t list; results : State.process list }

(* {1 Rule Bind} *)

(* Conservation of linear momentum; what binds to a fixed body stops. *)
let joint_velocity m (p : State.process) (q : State.process) =
  match (State.mass m p, State.mass m q) with
  | Some mp, Some mq ->
    Vec.scale
      (Rat.div Rat.one (Rat.add mp mq))
      (Vec.add (Vec.scale mp p.velocity) (Vec.scale mq q.velocity))
  | None, _ | _, None -> Vec.zero

let bind m (s : State.t) c =
  let p = s.processes.(c.first) and q = s.processes.(c.second) in
  let velocity = joint_velocity m p q in
  let join (candidate : Binding.candidate) =
    {
      label = Transition.Bind candidate.bond;
      rules = Rule.Bind :: candidate.used;
      results = [ State.with_velocity velocity (Binding.joined m p q candidate) ];
    }
  in
  let candidates t =
    Binding.candidates m p q ~one:t.one ~two:t.two (fun () -> Contact.touching t.obstacle t.offset)
  in
  List.filter (fun t -> t.approaching) c.touches |> List.concat_map candidates |> List.map join

(* {1 Rule Bounce} *)

(* How the change of the relative velocity is shared: in inverse proportion to the masses; a fixed body
   takes none. *)
let shares m p q =
  match (State.mass m p, State.mass m q) with
  | Some mp, Some mq ->
    let total = Rat.add mp mq in
    (Rat.div mq total, Rat.div mp total)
  | None, Some _ -> (Rat.zero, Rat.one)
  | Some _, None -> (Rat.one, Rat.zero)
  | None, None -> Scc_base.Bug.fail __POS__ "two fixed bodies collide"

let bounce m (s : State.t) c =
  let p = s.processes.(c.first) and q = s.processes.(c.second) in
  let w = relative_velocity s c.first c.second in
  let touching =
    List.map (fun t -> { Response.obstacle = t.obstacle; offset = t.offset }) c.touches
  in
  let change = Vec.sub (Response.bounce touching w) w in
  let share_p, share_q = shares m p q in
  let moved r velocity = Process.restart_clock m (State.with_velocity velocity r) in
  {
    label = Transition.Bounce (p.leaves.(0).leaf, q.leaves.(0).leaf);
    rules = [ Rule.Bounce ];
    results =
      [
        moved p (Vec.axpy (Rat.neg share_p) change p.velocity);
        moved q (Vec.axpy share_q change q.velocity);
      ];
  }

let resolve m s c = match bind m s c with [] -> [ bounce m s c ] | outcomes -> outcomes

(* {1 First time of contact} *)

let collision_time m s (a : Parts.part) (b : Parts.part) =
  let w = relative_velocity s a.process b.process in
  if Vec.is_zero w then None
  else
    let obstacle = Model.obstacle m (a.leaf, a.part) (b.leaf, b.part) in
    match Obstacle.first_time_of_contact obstacle (Vec.sub b.position a.position) w with
    | Never -> None
    | At t -> Some t
    | Inside -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"

let first_time_of_contact m s ~limit =
  let parts = Parts.of_state m s in
  let earlier best (i, j) =
    match (collision_time m s parts.(i) parts.(j), best) with
    | Some t, Some b -> Some (Rat.min t b)
    | Some t, None -> Some t
    | None, _ -> best
  in
  let within limit t = match limit with None -> true | Some l -> Rat.compare t l <= 0 in
  (* Pairs whose swept boxes do not meet within the window cannot collide within it: what is found there
     in time is the least of all. *)
  let rec look round window =
    match window with
    | None -> Parts.fold_pairs earlier None parts
    | Some span -> (
        let near = Parts.near_within parts span in
        match List.fold_left earlier None near with
        | Some t when Rat.compare t span <= 0 -> Some t
        | Some _ | None when Option.equal Rat.equal limit window -> None
        | Some _ | None -> 
          look (round + 1) (Parts.wider parts ~limit ~met:(List.length near) ~round span))
  in
  if Parts.all_move_alike parts then None
  else
    match look 1 (Parts.first_window parts ~limit) with
    | Some t when within limit t -> Some t
    | Some _ | None -> None
