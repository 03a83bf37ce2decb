(* Atoms over a rigid step against the state at each instant (rules Turn and Instants): letting the processes turn
   to an offset and looking there must tell the same as the timeline does. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

(* Two boxes bound off-centre, a compound, a slanted wedge and a wall. *)
let model =
  lazy
    (Scc_test_models.Load.exactly
       (Scc_test_models.Load.text
          {|shape Box {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
shape Wedge {
  vertices a (0,0,0)  b (2,0,0)  c (0,2,0)  d (0,0,1)
  faces    f1 [a,c,b]  f2 [a,b,d]  f3 [a,d,c]  f4 [b,c,d]
}
compound Pair { part l : Box mass 1  part r : Box scaled (1, 2, 1) mass 2 at translate (2, 1/2, 0)
  glue l.right ~ r.left }
process p = p1 : Box mass 1 [nil] <x, {p1.right, p2.left}> p2 : Box mass 3 at translate (2, 1, 1/2) [nil]
process q = Pair at translate (0, 7, 0) [nil]
process r = Wedge mass 2 at translate (-6, 0, 0) * rotate quaternion (3, 1, 0, 1) [nil]
fixed w = Box at translate (0, -5, 0)
dynamics free_body
resolution 1/8
|}))

let elaborated () = (Lazy.force model : Scc_elaborate.Elaborate.t)
let same_vec = Vec.equal

let rational = Gen.map2 (fun n d -> Rat.make (Z.of_int n) (Z.of_int d)) (Gen.int_range (-9) 9) (Gen.int_range 1 5)
let positive = Gen.map Rat.abs rational
let vector = Gen.map3 Vec.make rational rational rational
let or_zero g = Gen.frequency [ (3, g); (1, Gen.return Vec.zero) ]

(* The declared places with any motion, the turns begun some time ago: as after a step. *)
let state =
  let open Gen in
  let moving (p : State.process) =
    let fixed = Option.is_none (State.mass (elaborated ()).model p) in
    let* velocity = vector and* spin = or_zero vector and* since = positive in
    return
      (if fixed then p
       else
         State.with_velocity velocity (State.with_turn ~spin ~since:Rat.zero ~lasts:None p)
         |> Turn.pass (elaborated ()).model (if same_vec spin Vec.zero then Rat.zero else since))
  in
  let* processes = flatten_l (List.map moving (Array.to_list (elaborated ()).declared.processes)) in
  return (State.make ~processes ~step:None ~time:None)

let pass t (s : State.t) =
  let processes = List.map (Turn.pass (elaborated ()).model t) (Array.to_list s.processes) in
  State.make ~processes ~step:None ~time:None

let process_of (s : State.t) l = Option.get (State.home s l)
let centroid s l = State.centroid (elaborated ()).model (State.leaf_of (Option.get (State.home s l)) l)
let axis (a : Property.axis) (v : Vec.t) = match a with X -> v.x | Y -> v.y | Z -> v.z

let velocity s l =
  let p = process_of s l in
  let arm = Vec.sub (centroid s l) (State.centre_of_mass (elaborated ()).model p) in
  Vec.add p.velocity (Vec.cross p.spin arm)

(* By the masses and inertias of the parts where they are. *)
let total m (s : State.t) f =
  Array.fold_left
    (fun sum (p : State.process) ->
       match Turn.mover m p with
       | { mass = Some mass; velocity; spin } -> Rat.add sum (f mass ~velocity ~spin)
       | { mass = None; _ } -> sum)
    Rat.zero s.processes

let expected m s : Property.quantity -> Rat.t = function
  | Position (a, l) -> axis a (centroid s l)
  | Velocity (a, l) -> axis a (velocity s l)
  | Speed2 l -> Vec.norm2 (velocity s l)
  | Distance2 (p, q) -> Vec.norm2 (Vec.sub (centroid s p) (centroid s q))
  | Spin (a, l) -> axis a (process_of s l).spin
  | Spin2 l -> Vec.norm2 (process_of s l).spin
  | Momentum a -> total m s (fun mass ~velocity ~spin:_ -> axis a (Scc_rigid.Mass.momentum mass ~velocity))
  | Angular a ->
    total m s (fun mass ~velocity ~spin ->
        axis a (Scc_rigid.Mass.angular_momentum mass ~velocity ~spin ~about:Vec.zero))
  | Energy -> total m s Scc_rigid.Mass.energy
  | _ -> Alcotest.fail "not generated"

let leaf = Gen.int_range 0 4

let atom =
  let open Gen in
  let axis = oneofl Property.[ X; Y; Z ] in
  oneof
    [
      map2 (fun a l -> Property.Position (a, l)) axis leaf; map2 (fun a l -> Property.Velocity (a, l)) axis leaf;
      map (fun l -> Property.Speed2 l) leaf; map2 (fun p q -> Property.Distance2 (p, q)) leaf leaf;
      map2 (fun a l -> Property.Spin (a, l)) axis leaf; map (fun l -> Property.Spin2 l) leaf;
      map (fun a -> Property.Momentum a) axis; map (fun a -> Property.Angular a) axis; return Property.Energy;
    ]

let four = Timeline.Lasts (Rat.of_int 4)

let value (v : Value.t) t =
  match v with
  | Ratio (n, d) -> Rat.div (Polynomial.eval n t) (Polynomial.eval d t)
  | Undefined reason -> Alcotest.fail reason

let print (s, n, t) =
  let m = (elaborated ()).model in
  let motion (p : State.process) =
    Printf.sprintf "velocity %s spin %s since %s" (Vec.to_string p.velocity) (Vec.to_string p.spin)
      (Rat.to_string p.since)
  in
  String.concat "\n" (Array.to_list (Array.map motion s.State.processes))
  ^ Printf.sprintf "\n%s at %s" (Show.num m (Quantity n)) (Rat.to_string t)

(* What a process keeps may belong to another spin than that of its turn. *)
let keeping (s : State.t) kept =
  State.make ~processes:(List.map2 State.with_kept kept (Array.to_list s.processes)) ~step:None ~time:None

let with_dynamics dynamics =
  let m = (elaborated ()).model in
  { m with rigid = Option.map (fun r -> { r with Model.dynamics }) m.rigid }

let curves name dynamics kept =
  QCheck2.Test.make ~count:1000 ~name ~print
    (Gen.triple (Gen.map2 keeping state kept) atom positive)
    (fun (s, n, t) ->
       let m = with_dynamics dynamics in
       let value_of s extent = Trajectory.num (Trajectory.make (standard m) s extent) (Quantity n) in
       let along = Timeline.at (value_of s four) (Algebraic.of_rat Rat.one) in
       let later = pass t s in
       let now = Timeline.at (value_of later Timeline.Instant) Algebraic.zero in
       Rat.equal (value along t) (expected m later n) && Rat.equal (value now Rat.zero) (expected m later n))

let of_constant_spin =
  curves "the value of an atom along a turn is that in the state there" Constant_spin
    (Gen.return [ Vec.zero; Vec.zero; Vec.zero; Vec.zero ])

let of_free_body =
  let moving = or_zero vector in
  curves "also of a free body" Free_body
    (Gen.flatten_l [ moving; moving; moving; Gen.return Vec.zero ])

(* {1 Contact within resolution} *)

let eighth = Rat.make Z.one (Z.of_int 8)

let vertices s l =
  let m = (elaborated ()).model in
  let leaf = State.leaf_of (Option.get (State.home s l)) l in
  List.init (Array.length m.leaves.(l).parts) (fun i -> Scc_rigid.Placed.vertices (State.placed m leaf i))

let near s p q =
  let close a b = Rat.compare (Scc_rigid.Closest.distance2 a b) (Rat.mul eighth eighth) <= 0 in
  p <> q && List.exists (fun a -> List.exists (close a) (vertices s q)) (vertices s p)

(* Instants over a step, among them those next to the cuts. *)
let instants d (timeline : _ Timeline.t) =
  let cut (p : _ Timeline.piece) = Option.to_list (Algebraic.to_rat p.cut) in
  let cuts = List.concat_map cut timeline.rest in
  let tiny = Rat.make Z.one (Z.shift_left Z.one 24) in
  let even = List.init 8 (fun i -> Rat.div (Rat.mul d (Rat.of_int i)) (Rat.of_int 8)) in
  even @ List.concat_map (fun c -> [ c; Rat.sub c tiny; Rat.add c tiny ]) cuts

let touching =
  QCheck2.Test.make ~count:400 ~name:"touching along a turn is being within resolution there"
    (Gen.quad state leaf leaf positive)
    (fun (s, p, q, wait) ->
       let m = (elaborated ()).model in
       let s = pass wait s in
       let d = Rat.one in
       let timeline = Trajectory.prop (Trajectory.make (standard m) s (Lasts d)) (Fact (Touching (p, q))) in
       List.for_all
         (fun t ->
            Rat.sign t < 0 || Rat.compare t d >= 0
            ||
            match Timeline.at timeline (Algebraic.of_rat t) with
            | True -> near (pass t s) p q
            | False -> not (near (pass t s) p q)
            | Undecided _ ->
              (* Only where the distance is about the resolution. *)
              let before = Rat.max Rat.zero (Rat.sub t eighth) in
              List.exists (fun t -> near (pass t s) p q) [ before; t; Rat.add t eighth ])
         (instants d timeline))

(* A box that turns about y leaves a wall along y: at 1/4 the gap is the resolution. *)
let text =
  {|shape Box {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
fixed w = Box
process p = Box mass 1 velocity (0, 1, 0) spin (0, 1, 0) at translate (0, 9/4, 0) [nil]
process q = Box mass 1 velocity (0, 1, 0) at translate (5, 0, 0) [nil]
resolution 1/2
dynamics constant_spin
|}

let leaving () =
  let t = Scc_test_models.Load.exactly (Scc_test_models.Load.text text) in
  let timeline p q =
    Trajectory.prop (Trajectory.make (standard t.model) t.declared (Lasts Rat.one)) (Fact (Touching (p, q)))
  in
  let at timeline n d =
    Truth.to_string (Timeline.at timeline (Algebraic.of_rat (Rat.make (Z.of_int n) (Z.of_int d))))
  in
  let check name expected found = Alcotest.(check string) name expected found in
  let spun = timeline 0 1 in
  check "at the start" "true" (at spun 0 1);
  check "within" "true" (at spun 23 100);
  check "beyond" "false" (at spun 27 100);
  check "at the end" "false" (at spun 9 10);
  let cuts = List.length spun.rest in
  if cuts > 4 then Alcotest.failf "%d cuts" cuts;
  check "far" "false" (at (timeline 0 2) 1 2)

let suite =
  ("atoms over turns",
   [
     ("random", Scc_test_support.Property.cases [ of_constant_spin; of_free_body; touching ]);
     ("cases", [ Alcotest.test_case "leaving" `Quick leaving ]);
   ])
