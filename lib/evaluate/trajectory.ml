open Scc_ctl
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

type t = {
  model : Model.t;
  state : State.t;
  extent : Timeline.extent;
  homes : (int * State.leaf) option array;  (** by leaf: the index of its process, and itself *)
  arrived : Property.event -> bool;
}

let make ?(arrived = fun _ -> false) model (state : State.t) extent =
  let homes = Array.make (Array.length model.Model.leaves) None in
  Array.iteri
    (fun i (p : State.process) ->
       Array.iter (fun (l : State.leaf) -> homes.(l.leaf) <- Some (i, l)) p.leaves)
    state.processes;
  { model; state; extent; homes; arrived }

let home c leaf =
  match c.homes.(leaf) with
  | Some (i, l) -> (c.state.processes.(i), l)
  | None -> Scc_base.Bug.fail __POS__ "a leaf of the model is not in the state"

let same_process c p q =
  match (c.homes.(p), c.homes.(q)) with
  | Some (i, _), Some (j, _) -> Int.equal i j
  | _ -> Scc_base.Bug.fail __POS__ "a leaf of the model is not in the state"

let is_rigid c = Option.is_some c.model.rigid

(** {2 Constant atoms} *)

let joins p q (b : State.bond) =
  (b.one.at = p && b.two.at = q) || (b.one.at = q && b.two.at = p)

let count_bonds c name ends =
  let wanted (b : State.bond) =
    (match name with None -> true | Some n -> String.equal n b.name)
    && match ends with None -> true | Some (p, q) -> joins p q b
  in
  let in_process n (p : State.process) =
    Array.fold_left (fun n b -> if wanted b then n + 1 else n) n p.bonds
  in
  Array.fold_left in_process 0 c.state.processes

let axis (a : Property.axis) (v : Vec.t) = match a with X -> v.x | Y -> v.y | Z -> v.z

(* The sum of a quantity over the processes that are not fixed. *)
let total c quantity =
  Array.fold_left
    (fun acc (p : State.process) ->
       match State.mass c.model p with
       | None -> acc
       | Some m -> Rat.add acc (quantity m p))
    Rat.zero c.state.processes

let offers_in c (b : Behaviour.aged) polarity name =
  let named (ch : Behaviour.channel) = String.equal ch.name name in
  let wanted (o : Behaviour.offer) =
    match (o, polarity) with
    | Offer_open (p, ch, _), Some wanted ->
      named ch && (match (p, wanted) with
          | Behaviour.Name, Behaviour.Name | Co_name, Co_name -> true
          | (Name | Co_name), _ -> false)
    | Offer_open (_, ch, _), None | Offer_weak (ch, _), None -> named ch
    | Offer_strong (list, _), None -> List.exists named list
    | (Offer_weak _ | Offer_strong _), Some _ -> false
  in
  List.exists wanted (Behaviour.offers c.model.definitions b)

(* Constant: an eps that expires ends the time transition, and what time does to a behaviour before that
   changes neither its offers nor where it comes from. *)
let behavioural c leaf test =
  Timeline.constant c.extent (Truth.of_bool (test (snd (home c leaf)).behaviour))

let is_called k (b : Behaviour.aged) = match b.origin with Some o -> Int.equal o k | None -> false

(** {2 Motion} *)

let moving c position velocity =
  match c.extent with
  | Instant -> Polynomial.constant position
  | Lasts _ | Forever -> Polynomial.of_coefficients [ position; velocity ]

let centroid c leaf =
  let _, l = home c leaf in
  Vec.add l.position (Model.leaf_centroid c.model.leaves.(leaf))

let coordinate c a leaf =
  let p, _ = home c leaf in
  moving c (axis a (centroid c leaf)) (axis a p.velocity)

let distance2 c p q =
  let along a =
    let d = Polynomial.sub (coordinate c a p) (coordinate c a q) in
    Polynomial.mul d d
  in
  Polynomial.add (along X) (Polynomial.add (along Y) (along Z))

(* Exact: the closed interval of offsets at which the two closed parts meet. They never interpenetrate
   along a trajectory, so that meeting is touching. *)
let parts_touching c p q i j =
  let process_p, leaf_p = home c p and process_q, leaf_q = home c q in
  let offset =
    Vec.sub (State.part_position c.model leaf_q j) (State.part_position c.model leaf_p i)
  in
  let velocity = Vec.sub process_q.velocity process_p.velocity in
  match Obstacle.meeting (Model.obstacle c.model (p, i) (q, j)) offset velocity with
  | None -> Timeline.constant c.extent false
  | Some (low, high) ->
    let after t = match low with None -> true | Some l -> Rat.compare l t <= 0 in
    let before t = match high with None -> true | Some h -> Rat.compare t h <= 0 in
    Timeline.of_cuts c.extent (Option.to_list low @ Option.to_list high) Bool.equal (fun t ->
        after t && before t)

let touching c p q =
  if Int.equal p q then Timeline.constant c.extent Truth.False
  else if is_rigid c then Near.touching c.model c.extent (home c p) (home c q)
  else
    let indices leaf = List.init (Array.length c.model.leaves.(leaf).parts) (fun i -> i) in
    let pairs = List.concat_map (fun i -> List.map (fun j -> (i, j)) (indices q)) (indices p) in
    List.fold_left
      (fun acc (i, j) -> Timeline.map2 ( || ) acc (parts_touching c p q i j))
      (Timeline.constant c.extent false) pairs
    |> Timeline.map Truth.of_bool

(** {2 Motion of bodies that turn} *)

let for_ever c = match c.extent with Forever -> true | Instant | Lasts _ -> false

let spinning c leaf =
  let p, l = home c leaf in
  (Spinning.make ~for_ever:(for_ever c) c.model p, State.centroid c.model l)

(* What is a curve along a trajectory is its first value at an instant. *)
let curve c value =
  let at_start (v : Value.t) : Value.t =
    match (c.extent, v) with
    | Instant, Ratio (n, d) -> Value.of_rat (Rat.div (Polynomial.eval n Rat.zero) (Polynomial.eval d Rat.zero))
    | (Lasts _ | Forever), _ | _, Undefined _ -> v
  in
  Timeline.constant c.extent (at_start value)

let rigid_distance2 c p q =
  let of_p, from = spinning c p and of_q, towards = spinning c q in
  if same_process c p q then Value.of_rat (Vec.norm2 (Vec.sub from towards))
  else Spinning.distance2 of_p from of_q towards

(* A sum over the processes that turn. *)
let rigid_total c quantity =
  let add sum p = Value.add sum (quantity (Spinning.make ~for_ever:(for_ever c) c.model p)) in
  Array.fold_left add (Value.of_rat Rat.zero) c.state.processes

let rigid_num c (n : Property.num) =
  let of_leaf f leaf =
    let process, place = spinning c leaf in
    f process place
  in
  match n with
  | Quantity (Position (a, leaf)) -> Some (of_leaf (fun p -> Spinning.coordinate p a) leaf)
  | Quantity (Velocity (a, leaf)) -> Some (of_leaf (fun p -> Spinning.velocity p a) leaf)
  | Quantity (Speed2 leaf) -> Some (of_leaf Spinning.speed2 leaf)
  | Quantity (Distance2 (p, q)) -> Some (rigid_distance2 c p q)
  | Quantity (Angular a) -> Some (rigid_total c (fun p -> Spinning.angular p a))
  | Quantity Energy -> Some (rigid_total c Spinning.energy)
  | Quantity (Spin (a, leaf)) -> Some (of_leaf (fun p _ -> Spinning.spin p a) leaf)
  | Quantity (Spin2 leaf) -> Some (of_leaf (fun p _ -> Spinning.spin2 p) leaf)
  | Quantity (Bonds _ | Size _ | Processes | Momentum _ | Time)
  | Const _ | Count _ | Neg _ | Add _ | Sub _ | Mul _ | Div _ | If _ -> None

let time c =
  match c.state.time with
  | Some t -> moving c t Rat.one
  | None -> Scc_base.Bug.fail __POS__ "a property speaks of time, and the state does not keep it"

(** {2 Terms} *)

let all_false t =
  let is_false = function Truth.False -> true | Truth.True | Undecided _ -> false in
  match t.Timeline.rest with [] -> is_false t.start && is_false t.first | _ :: _ -> false

(* True at most at the instant at which the trajectory starts. *)
let at_the_start c holds =
  Timeline.refine
    ~roots:(fun () -> [])
    ~at:(fun _ () -> Truth.of_bool holds)
    ~inside:(fun _ () -> Truth.False)
    (Timeline.constant c.extent ())

let rec num c (n : Property.num) : Value.t Timeline.t =
  match if is_rigid c then rigid_num c n else None with
  | Some value -> curve c value
  | None -> straight_num c n

and straight_num c (n : Property.num) =
  let constant r = Timeline.constant c.extent (Value.of_rat r) in
  let integer k = Timeline.constant c.extent (Value.of_int k) in
  let line p = Timeline.constant c.extent (Value.polynomial p) in
  match n with
  | Const r -> constant r
  | Quantity (Bonds (name, ends)) -> integer (count_bonds c name ends)
  | Quantity (Size leaf) -> integer (State.size c.model (fst (home c leaf)))
  | Quantity Processes -> integer (Array.length c.state.processes)
  | Quantity (Position (a, leaf)) -> line (coordinate c a leaf)
  | Quantity (Velocity (a, leaf)) -> constant (axis a (fst (home c leaf)).velocity)
  | Quantity (Speed2 leaf) -> constant (Vec.norm2 (fst (home c leaf)).velocity)
  | Quantity (Distance2 (p, q)) -> line (distance2 c p q)
  | Quantity (Spin (a, leaf)) -> constant (axis a (fst (home c leaf)).spin)
  | Quantity (Spin2 leaf) -> constant (Vec.norm2 (fst (home c leaf)).spin)
  | Quantity (Momentum a) -> constant (total c (fun m p -> Rat.mul m (axis a p.velocity)))
  | Quantity (Angular a) ->
    let of_process m (p : State.process) =
      Rat.mul m (axis a (Vec.cross (State.centre_of_mass c.model p) p.velocity))
    in
    constant (total c of_process)
  | Quantity Energy -> constant (total c (fun m p -> Rat.div (Rat.mul m (Vec.norm2 p.velocity)) (Rat.of_int 2)))
  | Quantity Time -> line (time c)
  | Count props -> count c props
  | Neg a -> Timeline.map Value.neg (num c a)
  | Add (a, b) -> Timeline.map2 Value.add (num c a) (num c b)
  | Sub (a, b) -> Timeline.map2 Value.sub (num c a) (num c b)
  | Mul (a, b) -> Timeline.map2 Value.mul (num c a) (num c b)
  | Div (a, b) ->
    let reason = "division by zero in " ^ Show.num c.model n in
    Value.div ~reason c.extent (num c a) (num c b)
  | If (condition, a, b) ->
    let choose truth (x, y) =
      match truth with
      | Truth.True -> x
      | False -> y
      | Undecided reason -> Value.Undefined reason
    in
    Timeline.map2 choose (prop c condition) (Timeline.map2 (fun x y -> (x, y)) (num c a) (num c b))

and count c props =
  let add n truth =
    match (n, truth) with
    | Error reason, _ | Ok _, Truth.Undecided reason -> Error reason
    | Ok n, True -> Ok (n + 1)
    | Ok n, False -> Ok n
  in
  List.fold_left
    (fun acc p -> Timeline.map2 add acc (prop c p))
    (Timeline.constant c.extent (Ok 0))
    props
  |> Timeline.map (function Ok n -> Value.of_int n | Error reason -> Value.Undefined reason)

and prop c (p : Property.prop) : Truth.t Timeline.t =
  let constant b = Timeline.constant c.extent (Truth.of_bool b) in
  match p with
  | Bool b -> constant b
  | Compare (op, a, b) -> Value.compare op c.extent (num c a) (num c b)
  | Fact (Bound (p, q)) -> constant (count_bonds c None (Some (p, q)) > 0)
  | Fact (Same (p, q)) -> constant (same_process c p q)
  | Fact (Behaviour (leaf, k)) -> behavioural c leaf (is_called k)
  | Fact (Offers (leaf, polarity, name)) -> behavioural c leaf (fun b -> offers_in c b polarity name)
  | Fact (Touching (p, q)) -> touching c p q
  | Fact Quiescent -> constant (Scc_semantics.Network.quiescent c.model c.state)
  | Fact (Event e) -> at_the_start c (c.arrived e)
  | Not a -> Timeline.map Truth.not_ (prop c a)
  | And list -> conjunction c list
  | Or list -> Timeline.map Truth.not_ (conjunction c (List.map (fun p -> Property.Not p) list))

and conjunction c list =
  let rec go acc = function
    | [] -> acc
    | p :: later ->
      if all_false acc then acc
      else go (Timeline.simplify Truth.equal (Timeline.map2 Truth.and_ acc (prop c p))) later
  in
  go (Timeline.constant c.extent Truth.True) list

let holds model state p = (prop (make model state Timeline.Instant) p).Timeline.start
