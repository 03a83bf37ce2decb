open Scc_exact
open Scc_geometry

open Scc_calculus
open Scc_property
open Scc_test_networks

module Linear = Scc_polyhedra.Linear

type model = {
  model : Model.t;
  declared : State.t;
  uncertain : Uncertain.t option;
  checks : Property.check list;
}

type t = { name : string; time : Rat.t; right : bool; see : model -> model }

let of_elaborated ({ model; declared; uncertain; checks; _ } : Scc_elaborate.Elaborate.t) =
  { model; declared; uncertain; checks }

(* A point p is seen at length * turn p + by, at a time that is [time] times as late. *)
type view = { turn : Mat.t; by : Vec.t; length : Rat.t; time : Rat.t; mass : Rat.t }

let plain = { turn = Mat.identity; by = Vec.zero; length = Rat.one; time = Rat.one; mass = Rat.one }
let axes : Vec.axis list = [ X; Y; Z ]

let row (m : Mat.t) : Vec.axis -> Vec.t = function X -> m.r0 | Y -> m.r1 | Z -> m.r2
let entry m i j = Vec.component j (row m i)

(** {1 Expressions} *)

(* Sums of multiples, of formulas and of laws alike; nothing is written that changes nothing. *)
type 'a algebra = { const : Rat.t -> 'a; neg : 'a -> 'a; add : 'a -> 'a -> 'a; mul : 'a -> 'a -> 'a }

let times a k n =
  if Rat.equal k Rat.one then n else if Rat.equal k (Rat.neg Rat.one) then a.neg n else a.mul (a.const k) n

let sum a = function [] -> a.const Rat.zero | n :: rest -> List.fold_left a.add n rest

(* The sum of k.n over all axes. *)
let combination a k n =
  let term axis = if Rat.sign (k axis) = 0 then None else Some (times a (k axis) (n axis)) in
  sum a (List.filter_map term axes)

let plus a n c = if Rat.sign c = 0 then n else a.add n (a.const c)

(* A component of what was a vector, in terms of those of its image: [by] is added to the image of a place. *)
let component a v ~by ~scale axis image =
  let k j = Rat.mul scale (entry v.turn j axis) in
  let shift = List.fold_left (fun s j -> Rat.sub s (Rat.mul (k j) (Vec.component j by))) Rat.zero axes in
  plus a (combination a k image) shift

let speed v = Rat.div v.length v.time
let inverse = Rat.div Rat.one

let nums =
  {
    const = (fun c -> Property.Const c);
    neg = (fun n -> Property.Neg n);
    add = (fun m n -> Property.Add (m, n));
    mul = (fun m n -> Property.Mul (m, n));
  }

let square x = Rat.mul x x

(* Spins and angular momenta are seen the other way round in a mirror. *)
let handed v = Mat.det v.turn

let quantity v (q : Property.quantity) : Property.num =
  let vector ?(by = Vec.zero) scale axis image = component nums v ~by ~scale axis (fun j -> Quantity (image j)) in
  let scaled k = times nums k (Property.Quantity q) in
  match q with
  | Position (axis, i) -> vector ~by:v.by (inverse v.length) axis (fun j -> Position (j, i))
  | Velocity (axis, i) -> vector (inverse (speed v)) axis (fun j -> Velocity (j, i))
  | Momentum axis -> vector (inverse (Rat.mul v.mass (speed v))) axis (fun j -> Momentum j)
  | Spin (axis, i) -> vector (Rat.mul (handed v) v.time) axis (fun j -> Spin (j, i))
  | Angular axis ->
    (* About what was the origin: L - by x P. *)
    let times_p j k : Property.num =
      nums.mul (nums.const (Vec.component j v.by)) (Quantity (Momentum k))
    in
    let of_image (j : Vec.axis) : Property.num =
      if Vec.is_zero v.by then Quantity (Angular j)
      else
        let (k, l) : Vec.axis * Vec.axis = match j with X -> (Y, Z) | Y -> (Z, X) | Z -> (X, Y) in
        Add (Sub (Quantity (Angular j), times_p k l), times_p l k)
    in
    let scale = Rat.div (handed v) (Rat.mul v.mass (Rat.mul v.length (speed v))) in
    component nums v ~by:Vec.zero ~scale axis of_image
  | Speed2 _ -> scaled (inverse (square (speed v)))
  | Spin2 _ -> scaled (square v.time)
  | Distance2 _ -> scaled (inverse (square v.length))
  | Energy -> scaled (inverse (Rat.mul v.mass (square (speed v))))
  | Time -> scaled (inverse v.time)
  | Bonds _ | Size _ | Processes | Parameter _ -> Quantity q

let rec num v : Property.num -> Property.num = function
  | Const c -> Const c
  | Quantity q -> quantity v q
  | Count ps -> Count (List.map (prop v) ps)
  | Neg a -> Neg (num v a)
  | Add (a, b) -> Add (num v a, num v b)
  | Sub (a, b) -> Sub (num v a, num v b)
  | Mul (a, b) -> Mul (num v a, num v b)
  | Div (a, b) -> Div (num v a, num v b)
  | If (p, a, b) -> If (prop v p, num v a, num v b)

and prop v : Property.prop -> Property.prop = function
  | Bool b -> Bool b
  | Fact f -> Fact f
  | Compare (c, a, b) -> Compare (c, num v a, num v b)
  | Not p -> Not (prop v p)
  | And ps -> And (List.map (prop v) ps)
  | Or ps -> Or (List.map (prop v) ps)

let bound v ({ low; high } : Property.bound) : Property.bound =
  { low = Rat.mul v.time low; high = Option.map (Rat.mul v.time) high }

let rec temporal v : Property.temporal -> Property.temporal = function
  | State p -> State (prop v p)
  | Temporal_not f -> Temporal_not (temporal v f)
  | Temporal_and fs -> Temporal_and (List.map (temporal v) fs)
  | Temporal_or fs -> Temporal_or (List.map (temporal v) fs)
  | Next (q, f) -> Next (q, temporal v f)
  | Finally (q, b, f) -> Finally (q, bound v b, temporal v f)
  | Globally (q, b, f) -> Globally (q, bound v b, temporal v f)
  | Until (q, b, f, g) -> Until (q, bound v b, temporal v f, temporal v g)

let asked v (a : Property.asked) : Property.asked =
  match a with
  | Whether | How_likely _ -> a
  | Expected (sides, Time_until g, test) ->
    let than (b : Scc_chance.Answer.bound) = { b with than = Rat.mul v.time b.than } in
    Expected (sides, Time_until (temporal v g), Option.map than test)
  | Expected (sides, Events_until (e, g), test) -> Expected (sides, Events_until (prop v e, temporal v g), test)
  | Expected (sides, Value_at (n, at), test) -> Expected (sides, Value_at (num v n, Rat.mul v.time at), test)

let check v (c : Property.check) = { c with asked = asked v c.asked; formula = temporal v c.formula }

(** {1 Laws} *)

let exprs =
  {
    const = (fun c -> Law.Const c);
    neg = (fun n -> Law.Neg n);
    add = (fun m n -> Law.Add (m, n));
    mul = (fun m n -> Law.Mul (m, n));
  }

let place : Vec.axis -> Law.expr = function X -> Var X | Y -> Var Y | Z -> Var Z
let velocity : Vec.axis -> Law.expr = function X -> Var Vx | Y -> Var Vy | Z -> Var Vz

let variable v (x : Law.variable) : Law.expr =
  let at axis = component exprs v ~by:v.by ~scale:(inverse v.length) axis place in
  let fast axis = component exprs v ~by:Vec.zero ~scale:(inverse (speed v)) axis velocity in
  match x with
  | X -> at X
  | Y -> at Y
  | Z -> at Z
  | Vx -> fast X
  | Vy -> fast Y
  | Vz -> fast Z
  | Wx | Wy | Wz -> Var x
  | Mass -> times exprs (inverse v.mass) (Law.Var Mass)
  | Time -> times exprs (inverse v.time) (Law.Var Time)
  | Dt -> times exprs (inverse v.time) (Law.Var Dt)

let rec expr v : Law.expr -> Law.expr = function
  | (Const _ | Open _) as e -> e
  | Var x -> variable v x
  | Neg a -> Neg (expr v a)
  | Add (a, b) -> Add (expr v a, expr v b)
  | Sub (a, b) -> Sub (expr v a, expr v b)
  | Mul (a, b) -> Mul (expr v a, expr v b)
  | Div (a, b) -> Div (expr v a, expr v b)
  | Round (a, b) -> Round (expr v a, expr v b)
  | If (c, a, b) -> If (cond v c, expr v a, expr v b)

and cond v : Law.cond -> Law.cond = function
  | Bool b -> Bool b
  | Compare (c, a, b) -> Compare (c, expr v a, expr v b)
  | And (c, d) -> And (cond v c, cond v d)
  | Or (c, d) -> Or (cond v c, cond v d)
  | Not c -> Not (cond v c)

let vector v (x, y, z) =
  let of_axis : Vec.axis -> Law.expr = function X -> expr v x | Y -> expr v y | Z -> expr v z in
  let image j = combination exprs (fun axis -> Rat.mul (speed v) (entry v.turn j axis)) of_axis in
  (image X, image Y, image Z)

(* Of models in which nothing turns. *)
let law v : Law.t -> Law.t =
  let motion (m : Law.motion) = Law.velocity_alone (vector v m.velocity) in
  function
  | Inertial -> Inertial
  | Gives m -> Gives (motion m)
  | Choose kicks ->
    let kick (k : Law.kick) : Law.kick = { motion = motion k.motion; weight = expr v k.weight } in
    Choose (List.map kick kicks)

(** {1 All of it} *)

let form_of_place v ((x, y, z) : Uncertain.place) : Uncertain.place =
  let form : Vec.axis -> Linear.t = function X -> x | Y -> y | Z -> z in
  let image j =
    let term axis = Linear.scale (Rat.mul v.length (entry v.turn j axis)) (form axis) in
    List.fold_left Linear.add (Linear.constant (Linear.dimension x) (Vec.component j v.by)) (List.map term axes)
  in
  (image X, image Y, image Z)

let uncertain v (u : Uncertain.t) = { u with Uncertain.places = Array.map (form_of_place v) u.places }

let seen name ~right v (symmetry : Symmetry.t) =
  let of_model m =
    let m = symmetry.model m in
    let offset = Option.map (form_of_place { v with by = Vec.zero }) in
    let part (p : Model.part) = { p with open_offset = offset p.open_offset } in
    let leaf (l : Model.leaf) = { l with parts = Array.map part l.parts; law = law v l.law } in
    { m with leaves = Array.map leaf m.leaves }
  in
  let see { model; declared; uncertain = u; checks } =
    {
      model = of_model model;
      declared = symmetry.state declared;
      uncertain = Option.map (uncertain v) u;
      checks = List.map (check v) checks;
    }
  in
  { name; time = v.time; right; see }

let rotation q =
  let symmetry = Symmetry.any_rotation q in
  seen symmetry.name ~right:false { plain with turn = Quaternion.to_mat q } symmetry

let rotations =
  let turned (s : Symmetry.t) =
    let image x y z = s.velocity (Vec.of_ints x y z) in
    let turn = Mat.transpose (Mat.make (image 1 0 0) (image 0 1 0) (image 0 0 1)) in
    seen s.name ~right:true { plain with turn } s
  in
  List.map turned Symmetry.rotations

let displacement by =
  let symmetry = Symmetry.translation by in
  seen symmetry.name ~right:true { plain with by } symmetry

let units ~length ~time ~mass =
  let symmetry = Symmetry.scaling ~length ~time ~mass in
  seen symmetry.name ~right:true { plain with length; time; mass } symmetry

(* The template is seen in the mirror as well, its faces turned over; what is done to it keeps its sense. *)
let mirror =
  let turn = Mat.diagonal (Vec.of_ints (-1) 1 1) in
  let reflected = Mat.apply turn in
  let polyhedron p =
    let { Polyhedron.ifs_vertices; ifs_faces } = Polyhedron.to_ifs p in
    let over corners = Array.of_list (List.rev (Array.to_list corners)) in
    let image =
      {
        Polyhedron.ifs_vertices = Array.map (fun (name, v) -> (name, reflected v)) ifs_vertices;
        ifs_faces = Array.map (fun (name, corners) -> (name, over corners)) ifs_faces;
      }
    in
    match Polyhedron.of_ifs image with Ok p -> p | Error _ -> failwith "a mirror image is no solid"
  in
  let model (m : Model.t) =
    let part (p : Model.part) =
      let s = p.solid in
      let linear = Mat.mul turn (Mat.mul s.Solid.linear turn) in
      { p with solid = Solid.make ~id:s.id (polyhedron s.polyhedron) linear; offset = reflected p.offset }
    in
    let leaf (l : Model.leaf) = { l with parts = Array.map part l.parts } in
    { m with leaves = Array.map leaf m.leaves }
  in
  let state (s : State.t) =
    let place (l : State.leaf) = { l with position = reflected l.position } in
    let process p = State.with_velocity (reflected p.State.velocity) (State.map_leaves place p) in
    State.make ~processes:(List.map process (Array.to_list s.processes)) ~step:s.step ~time:s.time
  in
  seen "a mirror" ~right:true { plain with turn } (Symmetry.make "a mirror" ~model ~velocity:reflected state)

(** {1 At random} *)

module Gen = QCheck2.Gen

let turned =
  let open Gen in
  let digit = map Z.of_int (int_range (-3) 3) in
  let+ w = map Z.of_int (int_range 1 4) and+ x = digit and+ y = digit and+ z = digit in
  rotation (Quaternion.make w x y z)

let moved =
  let open Gen in
  let+ x = int_range (-20) 20 and+ y = int_range (-9) 9 and+ z = int_range (-9) 9 in
  displacement (Vec.of_ints x y z)

let in_other_units =
  let open Gen in
  let half = Rat.make Z.one (Z.of_int 2) in
  let power = oneofl [ Rat.mul half half; half; Rat.one; Rat.of_int 2; Rat.of_int 8 ] in
  let+ length = power and+ time = power and+ mass = power in
  units ~length ~time ~mass

let any =
  Gen.frequency
    [ (4, turned); (3, Gen.oneofl rotations); (1, moved); (1, in_other_units); (1, Gen.return mirror) ]
