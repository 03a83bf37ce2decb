open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property

type quantity =
  | Of_process of int * (Path.t -> Path.curve)
  | Counted of int * (State.process -> int)
  | Of_two of int * int * (Path.t -> Path.t -> Path.curve)
  | Sum of (Path.t -> Path.curve)
  | Number of Property.quantity * (State.process -> int)
  | Time
  | Parameter of int

type fact =
  | Missing of int
  | In_process of int * (State.process -> bool)
  | In_behaviour of int * (Behaviour.aged -> bool)
  | Touch of int * int * (Timeline.extent -> Path.t -> Path.t -> Truth.t Timeline.t)
  | Rest of (State.t -> bool)
  | Arrival of Property.event

let joins p q (b : State.bond) = (b.one.at = p && b.two.at = q) || (b.one.at = q && b.two.at = p)

let named name (b : State.bond) =
  match name with
  | None -> true
  | Some n -> String.equal n b.name

let count test (p : State.process) = Array.fold_left (fun n b -> if test b then n + 1 else n) 0 p.bonds

(* Of the shape of a leaf, where it is now. *)
let centroid leaf path = State.centroid (Path.model path) (State.leaf_of (Path.process path) leaf)

let distance2 i j p q =
  let from = centroid i p and towards = centroid j q in
  if State.has_leaf (Path.process p) j then Path.Steady (Vec.norm2 (Vec.sub from towards))
  else Path.distance2 p from q towards

let of_the_gone (model : Model.t) leaf =
  Printf.sprintf "`%s` is gone, and nowhere: ask for `gone(%s)` first" model.leaves.(leaf).name
    model.leaves.(leaf).name

let is_called k (b : Behaviour.aged) =
  match b.origin with
  | Some o -> Int.equal o k
  | None -> false

let same_polarity (p : Behaviour.polarity) (q : Behaviour.polarity) =
  match (p, q) with
  | Name, Name | Co_name, Co_name -> true
  | (Name | Co_name), _ -> false

let offers definitions polarity name b =
  let named (c : Behaviour.channel) = String.equal c.name name in
  let wanted (o : Behaviours.offer) =
    match (o, polarity) with
    | Offer_open (p, c, _), Some wanted -> named c && same_polarity p wanted
    | Offer_open (_, c, _), None | Offer_weak (c, _, _), None -> named c
    | Offer_strong (list, _, _), None -> List.exists named list
    | (Offer_weak _ | Offer_strong _), Some _ -> false
  in
  List.exists wanted (Behaviours.offers definitions b)

let quantity model (q : Property.quantity) =
  match q with
  | Bonds (name, None) -> Number (q, count (named name))
  | Bonds (name, Some (i, j)) ->
    let wanted b = named name b && joins i j b in
    Counted (i, count wanted)
  | Size i -> Counted (i, State.size model)
  | Processes -> Number (q, fun _ -> 1)
  | Position (a, i) -> Of_process (i, fun p -> Path.coordinate p a (centroid i p))
  | Velocity (a, i) -> Of_process (i, fun p -> Path.velocity p a (centroid i p))
  | Speed2 i -> Of_process (i, fun p -> Path.speed2 p (centroid i p))
  | Spin (a, i) -> Of_process (i, fun p -> Path.spin p a)
  | Spin2 i -> Of_process (i, Path.spin2)
  | Distance2 (i, j) -> Of_two (i, j, distance2 i j)
  | Momentum a -> Sum (fun p -> Path.momentum p a)
  | Angular a -> Sum (fun p -> Path.angular p a)
  | Energy -> Sum Path.energy
  | Time -> Time
  | Parameter i -> Parameter i

let fact semantics : Property.fact -> fact = function
  | Bound (i, j) -> In_process (i, fun p -> Array.exists (joins i j) p.bonds)
  | Same (i, j) -> In_process (i, fun p -> State.has_leaf p j)
  | Behaviour (i, k) -> In_behaviour (i, is_called k)
  | Offers (i, polarity, name) -> In_behaviour (i, offers (Semantics.model semantics).definitions polarity name)
  | Touching (i, j) when Int.equal i j -> In_process (i, fun _ -> false)
  | Touching (i, j) -> Touch (i, j, Touching.along semantics i j)
  | Gone i -> Missing i
  | Quiescent -> Rest (Network.quiescent semantics)
  | Event e -> Arrival e
