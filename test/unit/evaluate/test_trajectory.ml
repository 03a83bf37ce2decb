(* The evaluator over trajectories against the state at each instant: letting time pass to an offset and
   looking at the state there must tell the same as the timeline does at that offset. *)

open Scc_ctl
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_state_space
open Scc_test_networks

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

(* {1 Random predicates} *)

let axis_gen = Gen.oneofl Property.[ X; Y; Z ]
let comparison_gen = Gen.oneofl Law.[ Lt; Le; Gt; Ge; Eq; Ne ]
let constant_gen =
  Gen.map (fun n -> Property.Const (Rat.make (Z.of_int n) (Z.of_int 4))) (Gen.int_range (-24) 24)

let rec num_gen leaves depth : Property.num Gen.t =
  let open Gen in
  let leaf = int_range 0 (leaves - 1) in
  let atom =
    oneof
      [
        constant_gen;
        map2 (fun a l -> Property.Quantity (Position (a, l))) axis_gen leaf;
        map2 (fun a l -> Property.Quantity (Velocity (a, l))) axis_gen leaf;
        map2 (fun p q -> Property.Quantity (Distance2 (p, q))) leaf leaf;
        map (fun l -> Property.Quantity (Speed2 l)) leaf;
        map (fun l -> Property.Quantity (Size l)) leaf;
        return (Property.Quantity (Bonds (None, None)));
        return (Property.Quantity Processes);
        return (Property.Quantity Energy);
        map (fun a -> Property.Quantity (Momentum a)) axis_gen;
        map (fun a -> Property.Quantity (Angular a)) axis_gen;
        map2 (fun a l -> Property.Quantity (Spin (a, l))) axis_gen leaf;
        map (fun l -> Property.Quantity (Spin2 l)) leaf;
      ]
  in
  if depth = 0 then atom
  else
    let sub = num_gen leaves (depth - 1) in
    frequency
      [
        (3, atom);
        (2, map2 (fun a b -> Property.Add (a, b)) sub sub);
        (2, map2 (fun a b -> Property.Sub (a, b)) sub sub);
        (2, map2 (fun a b -> Property.Mul (a, b)) sub sub);
        (1, map2 (fun a b -> Property.Div (a, b)) sub sub);
        (1, map (fun a -> Property.Neg a) sub);
        (1, map (fun l -> Property.Count l) (list_size (int_range 1 3) (prop_gen leaves (depth - 1))));
        (1, map3 (fun c a b -> Property.If (c, a, b)) (prop_gen leaves (depth - 1)) sub sub);
      ]

and prop_gen leaves depth : Property.prop Gen.t =
  let open Gen in
  let leaf = int_range 0 (leaves - 1) in
  let numbers = num_gen leaves (Int.max 0 (depth - 1)) in
  let atom =
    frequency
      [
        (5, map3 (fun op a b -> Property.Compare (op, a, b)) comparison_gen numbers numbers);
        (2, map2 (fun p q -> Property.Fact (Touching (p, q))) leaf leaf);
        (1, map2 (fun p q -> Property.Fact (Same (p, q))) leaf leaf);
        (1, map2 (fun p q -> Property.Fact (Bound (p, q))) leaf leaf);
        ( 2,
          let* l = leaf and* polarity = oneofl Behaviour.[ None; Some Name; Some Co_name ] in
          let* name = oneofl [ "a"; "b" ] in
          return (Property.Fact (Offers (l, polarity, name))) );
        (1, map2 (fun l k -> Property.Fact (Behaviour (l, k))) leaf (int_range 0 3));
        (1, return (Property.Fact Quiescent));
        (1, map (fun l -> Property.Fact (Gone l)) leaf);
        (1, return (Property.Fact (Event (Bounce Any))));
      ]
  in
  if depth = 0 then atom
  else
    let sub = prop_gen leaves (depth - 1) in
    frequency
      [
        (3, atom);
        (1, map (fun a -> Property.Not a) sub);
        (2, map (fun l -> Property.And l) (list_size (int_range 1 3) sub));
        (2, map (fun l -> Property.Or l) (list_size (int_range 1 3) sub));
      ]

(* {1 A naive evaluation at one instant} *)

exception Undefined

let is_there s l = Option.is_some (State.home s l)
let process_of (s : State.t) l = match State.home s l with Some p -> p | None -> raise Undefined
let leaf_of s l = State.leaf_of (process_of s l) l
let axis (a : Property.axis) (v : Vec.t) = match a with X -> v.x | Y -> v.y | Z -> v.z
let centroid (m : Model.t) s l = Vec.add (leaf_of s l).position (Model.leaf_centroid m.leaves.(l))

let touching (m : Model.t) s p q =
  let parts l = List.init (Array.length m.leaves.(l).parts) (fun i -> i) in
  p <> q && is_there s p && is_there s q
  && List.exists
    (fun i ->
       List.exists
         (fun j ->
            let offset =
              Vec.sub (State.part_position m (leaf_of s q) j) (State.part_position m (leaf_of s p) i)
            in
            let solid l i = m.leaves.(l).parts.(i).solid in
            match Obstacle.relation (Obstacle.make (solid p i) (solid q j)) offset with
            | Touching -> true
            | Apart | Interpenetrating -> false)
         (parts q))
    (parts p)

let total m (s : State.t) f =
  Array.fold_left
    (fun acc (p : State.process) ->
       match State.mass m p with Some k -> Rat.add acc (f k p.velocity) | None -> acc)
    Rat.zero s.processes

let rec num m s (n : Property.num) =
  match n with
  | Const r -> r
  | Quantity (Parameter _) -> Alcotest.fail "a parameter that is not known"
  | Quantity (Bonds _) ->
    let add k (p : State.process) = k + Array.length p.bonds in
    Rat.of_int (Array.fold_left add 0 s.State.processes)
  | Quantity (Size l) -> if is_there s l then Rat.of_int (State.size m (process_of s l)) else Rat.zero
  | Quantity Processes -> Rat.of_int (Array.length s.processes)
  | Quantity (Position (a, l)) -> axis a (centroid m s l)
  | Quantity (Velocity (a, l)) -> axis a (process_of s l).velocity
  | Quantity (Speed2 l) -> Vec.norm2 (process_of s l).velocity
  | Quantity (Distance2 (p, q)) -> Vec.norm2 (Vec.sub (centroid m s p) (centroid m s q))
  | Quantity (Spin (_, l) | Spin2 l) -> Vec.norm2 (process_of s l).spin
  | Quantity (Angular a) ->
    (* Every leaf by itself: nothing turns. *)
    let of_leaf sum l =
      let leaf = m.Model.leaves.(l) in
      if (not (is_there s l)) || leaf.fixed || State.mass m (process_of s l) = None then sum
      else
        let v = (process_of s l).velocity in
        Rat.add sum (Rat.mul leaf.mass (axis a (Vec.cross (centroid m s l) v)))
    in
    List.fold_left of_leaf Rat.zero (List.init (Array.length m.leaves) Fun.id)
  | Quantity (Momentum a) -> total m s (fun k v -> Rat.mul k (axis a v))
  | Quantity Energy -> total m s (fun k v -> Rat.div (Rat.mul k (Vec.norm2 v)) (Rat.of_int 2))
  | Quantity Time -> Option.get s.time
  | Count l ->
    (* Every one is looked at: what is undefined makes the count undefined. *)
    Rat.of_int (List.length (List.filter (fun b -> b) (List.map (prop m s) l)))
  | Neg a -> Rat.neg (num m s a)
  | Add (a, b) -> Rat.add (num m s a) (num m s b)
  | Sub (a, b) -> Rat.sub (num m s a) (num m s b)
  | Mul (a, b) -> Rat.mul (num m s a) (num m s b)
  | Div (a, b) ->
    let b = num m s b in
    if Rat.sign b = 0 then raise Undefined else Rat.div (num m s a) b
  | If (c, a, b) -> if prop m s c then num m s a else num m s b

and prop m s (p : Property.prop) =
  match p with
  | Bool b -> b
  | Compare (op, a, b) -> Law.compare_rationals op (num m s a) (num m s b)
  | Fact (Bound (p, q)) ->
    let joins (b : State.bond) = (b.one.at = p && b.two.at = q) || (b.one.at = q && b.two.at = p) in
    Array.exists (fun (p : State.process) -> Array.exists joins p.bonds) s.State.processes
  | Fact (Gone l) -> not (is_there s l)
  | Fact (Same (p, q)) -> is_there s p && State.has_leaf (process_of s p) q
  | Fact (Behaviour (l, k)) -> is_there s l && (leaf_of s l).behaviour.origin = Some k
  | Fact (Offers (l, polarity, name)) ->
    let named (c : Behaviour.channel) = String.equal c.name name in
    is_there s l
    && List.exists
      (function
        | Behaviours.Offer_open (p, c, _) -> named c && (polarity = None || polarity = Some p)
        | Offer_weak (c, _, _) -> polarity = None && named c
        | Offer_strong (list, _, _) -> polarity = None && List.exists named list)
      (Behaviours.offers m.Model.definitions (leaf_of s l).behaviour)
  | Fact (Touching (p, q)) -> touching m s p q
  | Fact Quiescent -> Network.quiescent (standard m) s
  | Fact (Event _) -> false  (* nothing has led here *)
  | Not a -> not (prop m s a)
  | And l -> connect m s ~absorbing:false l
  | Or l -> connect m s ~absorbing:true l

(* Kleene: one absorbing truth decides, whatever is undefined beside it. *)
and connect m s ~absorbing list =
  let truths = List.map (fun p -> match prop m s p with b -> Some b | exception Undefined -> None) list in
  if List.exists (fun t -> t = Some absorbing) truths then absorbing
  else if List.exists Option.is_none truths then raise Undefined
  else not absorbing

let naive m s p = match prop m s p with b -> Truth.of_bool b | exception Undefined -> Truth.Undecided ""

let agree a b =
  match (a, b) with
  | Truth.True, Truth.True | False, False | Undecided _, Undecided _ -> true
  | (Truth.True | False | Undecided _), _ -> false

(* {1 Along random runs} *)

(* The cuts themselves when they are rational, and points between and around them. *)
let offsets (timeline : _ Timeline.t) =
  let cuts = List.map (fun (p : _ Timeline.piece) -> p.cut) timeline.rest in
  let after cut = Rat.add (Rat.of_int 5) (snd (Algebraic.enclose cut ~width:Rat.one)) in
  let until =
    match timeline.extent with
    | Instant -> Rat.zero
    | Lasts d -> d
    | Forever -> List.fold_left (fun u cut -> Rat.max u (after cut)) (Rat.of_int 20) cuts
  in
  let bounds = (Algebraic.zero :: cuts) @ [ Algebraic.of_rat until ] in
  let rec between = function
    | a :: (b :: _ as rest) -> Algebraic.between a b :: between rest
    | _ -> []
  in
  let even = List.init 12 (fun i -> Rat.div (Rat.mul until (Rat.of_int (i + 1))) (Rat.of_int 13)) in
  Rat.zero :: even @ between bounds @ List.filter_map Algebraic.to_rat cuts

let trajectory_agrees m s extent p =
  let timeline = Trajectory.prop (Trajectory.make (standard m) s extent) p in
  let at r =
    let later = if Rat.sign r = 0 then s else Time.pass (standard m) r s in
    agree (Timeline.at timeline (Algebraic.of_rat r)) (naive m later p)
  in
  match List.find_opt (fun r -> not (at r)) (offsets timeline) with
  | None -> true
  | Some r -> QCheck2.Test.fail_reportf "at offset %s" (Rat.to_string r)

let run_agrees (network, (p : Property.prop)) =
  let m, start = Random_network.start network in
  List.for_all
    (fun (s, transitions) ->
       agree (Trajectory.holds (standard m) s p) (naive m s p)
       && List.for_all
         (fun (t : Transition.t) ->
            match t.label with
            | Time d -> trajectory_agrees m s (Timeline.Lasts d) p
            | _ -> true)
         transitions
       && (transitions <> [] || trajectory_agrees m s Timeline.Forever p))
    (Reach.states m start ~limit:6)

let gen =
  let open Gen in
  let* network = oneof [ Random_network.generate (); Random_network.absorbing () ] in
  let m = Random_network.model network in
  let* p = prop_gen (Array.length m.leaves) 3 in
  return (network, p)

let print (network, p) =
  Random_network.print network ^ "\n" ^ Show.prop (Random_network.model network) p

(* What is judged by components, against the same naive truth. *)
let components_agree (network, (p : Property.prop)) =
  let m, start = Random_network.start network in
  let context = Network_lts.make ~events:(Formula.events (State p)) ~memory:4 (standard m) start in
  let predicate = Predicate.make context p in
  let tuple s = Catalogue.encode (Network_lts.catalogue context) s in
  let agrees_along s extent =
    match predicate.along with
    | Some along ->
      let timeline = along (tuple s) extent in
      let expected = Trajectory.prop (Trajectory.make (standard m) s extent) p in
      List.for_all
        (fun r ->
           let r = Algebraic.of_rat r in
           agree (Timeline.at timeline r) (Timeline.at expected r))
        (offsets expected)
    | None ->
      (* It does not change on the way. *)
      let now = predicate.at (tuple s) in
      let expected = Trajectory.prop (Trajectory.make (standard m) s extent) p in
      List.for_all (fun r -> agree now (Timeline.at expected (Algebraic.of_rat r))) (offsets expected)
  in
  List.for_all
    (fun (s, transitions) ->
       agree (predicate.at (tuple s)) (naive m s p)
       && List.for_all
         (fun (t : Transition.t) ->
            match t.label with
            | Time d -> agrees_along s (Timeline.Lasts d)
            | _ -> true)
         transitions)
    (Reach.states m start ~limit:6)

let random =
  QCheck2.Test.make ~count:5000 ~name:"a timeline tells what the states at its instants do" ~print gen
    run_agrees

let components =
  QCheck2.Test.make ~count:3000 ~name:"predicates by components tell the same" ~print gen components_agree

(* {1 Timelines alone} *)

let int = Rat.of_int

let pieces () =
  let f r =
    if Rat.equal r (int 1) then "one" else if Rat.compare r (int 2) >= 0 then "late" else "early"
  in
  let t = Timeline.of_cuts (Lasts (int 3)) [ int 2; int 1; int 7; int 0 ] String.equal f in
  let cuts = List.map (fun (p : _ Timeline.piece) -> Algebraic.to_string p.cut) t.rest in
  Alcotest.(check (list string)) "cuts" [ "1"; "2" ] cuts;
  let first test =
    match Timeline.first_after_start test t with
    | None -> "never"
    | Some m -> (if m.attained then "at " else "after ") ^ Algebraic.to_string m.offset
  in
  Alcotest.(check string) "one" "at 1" (first (String.equal "one"));
  Alcotest.(check string) "late" "at 2" (first (String.equal "late"));
  Alcotest.(check string) "early" "after 0" (first (String.equal "early"));
  Alcotest.(check string) "other" "never" (first (String.equal "other"))

(* t^2 = 2 on (0, 2), through both the comparison and the division. *)
let irrational () =
  let extent = Timeline.Lasts (int 2) in
  let curve l = Timeline.constant extent (Value.polynomial (Polynomial.of_coefficients (List.map int l))) in
  let show t =
    let text = function Truth.True -> "T" | False -> "F" | Undecided _ -> "?" in
    String.concat " "
      (text t.Timeline.start :: text t.first
       :: List.concat_map
         (fun (p : _ Timeline.piece) -> [ Algebraic.to_decimal ~digits:3 p.cut; text p.at; text p.after ])
         t.rest)
  in
  let square = curve [ 0; 0; 1 ] and two = curve [ 2 ] in
  Alcotest.(check string) "=" "F F 1.414 T F" (show (Value.compare Eq extent square two));
  Alcotest.(check string) "<=" "T T 1.414 T F" (show (Value.compare Le extent square two));
  let quotient = Value.div ~reason:"zero" extent two (Timeline.map2 Value.sub square two) in
  Alcotest.(check string) "2 / (t^2 - 2) < 0" "T T 1.414 ? F"
    (show (Value.compare Lt extent quotient (curve [ 0 ])));
  let self = Value.div ~reason:"zero" extent (curve [ 0; 1 ]) (curve [ 0; 1 ]) in
  Alcotest.(check string) "t / t = 1" "? T" (show (Value.compare Eq extent self (curve [ 1 ])))

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("trajectory",
   [
     ("random runs", Scc_test_support.Property.cases [ random; components ]);
     ("cases", [ quick "pieces" pieces; quick "irrational instants" irrational ]);
   ])
