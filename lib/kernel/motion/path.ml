open Scc_base
open Scc_exact
open Scc_rigid
open Scc_calculus
open Scc_semantics

type curve = Steady of Rat.t | Quotient of Polynomial.t * Polynomial.t | Not_followed

(* How a process of a rigid model turns. The denominator of all that turns with it is [bottom]. *)
type turning = { mover : Impact.mover Later.t; centre : Vec.t; bottom : Polynomial.t; for_ever : bool }

type kinematics = Straight | Turning of turning Later.t
type t = { model : Model.t; process : State.process; kinematics : kinematics }

(* A vector of polynomials. *)
type vector = { x : Polynomial.t; y : Polynomial.t; z : Polynomial.t }

let two = Rat.of_int 2
let quarter = Rat.make Z.one (Z.of_int 4)

let component (a : Vec.axis) c =
  match a with
  | X -> c.x
  | Y -> c.y
  | Z -> c.z

let dot (v : Vec.t) c = Polynomial.(add (scale v.x c.x) (add (scale v.y c.y) (scale v.z c.z)))
let product a b = Polynomial.(add (mul a.x b.x) (add (mul a.y b.y) (mul a.z b.z)))

(* The value of a + b s + c s^2 at s = since + t, as a polynomial in t. *)
let shifted since a b c =
  let linear = Rat.add b (Rat.mul two (Rat.mul c since)) in
  let constant = Rat.add a (Rat.mul since (Rat.add b (Rat.mul c since))) in
  Polynomial.of_coefficients [ constant; linear; c ]

let turning ~for_ever m (p : State.process) =
  {
    mover = Later.make (fun () -> Turn.mover m p);
    centre = State.centre_of_mass m p;
    bottom = shifted p.since Rat.one Rat.zero (Rat.mul quarter (Vec.norm2 p.spin));
    for_ever;
  }

let make ?(for_ever = false) (model : Model.t) process =
  let kinematics =
    match model.rigid with
    | None -> Straight
    | Some _ -> Turning (Later.make (fun () -> turning ~for_ever model process))
  in
  { model; process; kinematics }

let model t = t.model
let process t = t.process

(* {1 At an instant} *)

let at t d = Turn.pass t.model d t.process

let motions t (leaf : State.leaf) =
  let centre = State.centre_of_mass t.model t.process in
  let part i = (Turn.motion t.model t.process ~centre leaf i, Turn.reach t.model ~centre leaf i) in
  List.init (Array.length t.model.leaves.(leaf.leaf).parts) part

(* {1 Curves} *)

let now = function
  | Steady r -> Some r
  | Quotient (n, d) -> Some (Rat.div (Polynomial.eval n Rat.zero) (Polynomial.eval d Rat.zero))
  | Not_followed -> None

let polynomial p = Quotient (p, Polynomial.one)

(* {1 What turns} *)

(* Over [bottom]: where a vector goes that turns with a process of spin [w], and was [a] at the start of the turn,
   [since] ago. With u = w s/2 the Cayley map takes a to ((1 - |u|^2) a + 2 (u.a) u + 2 u x a) / (1 + |u|^2). *)
let turning_from ~since ~spin:w (a : Vec.t) =
  let b = Vec.cross w a in
  let c =
    Vec.scale quarter (Vec.sub (Vec.scale (Rat.mul two (Vec.dot w a)) w) (Vec.scale (Vec.norm2 w) a))
  in
  { x = shifted since a.x b.x c.x; y = shifted since a.y b.y c.y; z = shifted since a.z b.z c.z }

let spins t = Turn.spinning t.process
let turned t = Quaternion.cayley (Vec.scale (Rat.div t.process.since two) t.process.spin)

(* The same of a vector that is [r] now. *)
let turning_now t r =
  let { State.since; spin; _ } = t.process in
  if spins t then turning_from ~since ~spin (Quaternion.apply (Quaternion.inverse (turned t)) r)
  else turning_from ~since ~spin r

(* {2 For ever}

   The curves are those of one turn. Over the ray of a network in which nothing happens any more, turn follows on
   turn, spins may be computed anew and orientations rounded: what changes with that is not followed. *)

let isotropic (i : Mat.t) = Mat.equal i (Mat.scale i.r0.x Mat.identity)
let free t = Turn.is_free t.model

(* The inertia, and the angular momentum about the centre. *)
let own t k =
  match (Later.force k.mover).mass with
  | None -> (Mat.identity, Vec.zero)
  | Some mass -> (mass.inertia, if free t then t.process.kept else Mat.apply mass.inertia t.process.spin)

let along t r = Vec.is_zero (Vec.cross t.process.spin r)
let rounded t = Option.is_some (Turn.rigid t.model).round_orientation
let one_turn t k = not (k.for_ever && spins t)

let steady_spin t k =
  one_turn t k
  || (not (free t))
  ||
  let inertia, momentum = own t k in
  isotropic inertia || (along t momentum && not (rounded t))

(* A vector that turns with the process stays what it is when it lies along the spin. *)
let steady t k r = Vec.is_zero r || one_turn t k || (steady_spin t k && along t r && not (rounded t))
let steady_energy t k = one_turn t k || (steady_spin t k && ((not (rounded t)) || isotropic (fst (own t k))))
let followed so curve = if so then curve () else Not_followed

(* {1 Points} *)

let straight_coordinate t a place =
  let v = Vec.component a t.process.velocity and from = Vec.component a place in
  if Rat.sign v = 0 then Steady from else polynomial (Polynomial.of_coefficients [ from; v ])

let centre_line t k a =
  Polynomial.of_coefficients [ Vec.component a k.centre; Vec.component a t.process.velocity ]

let coordinate t a place =
  match t.kinematics with
  | Turning k when spins t ->
    let k = Later.force k in
    let arm = Vec.sub place k.centre in
    followed (steady t k arm) (fun () ->
        let arm = component a (turning_now t arm) in
        Quotient (Polynomial.add (Polynomial.mul (centre_line t k a) k.bottom) arm, k.bottom))
  | Straight | Turning _ -> straight_coordinate t a place

(* The velocity over [bottom], less that of the centre: w x r turns as r does. *)
let swing t arm = turning_now t (Vec.cross t.process.spin arm)

let velocity t a place =
  match t.kinematics with
  | Turning k when spins t ->
    let k = Later.force k in
    let arm = Vec.sub place k.centre in
    followed (steady t k arm) (fun () ->
        let own = Polynomial.scale (Vec.component a t.process.velocity) k.bottom in
        Quotient (Polynomial.add own (component a (swing t arm)), k.bottom))
  | Straight | Turning _ -> Steady (Vec.component a t.process.velocity)

(* |v|^2 + |w x r|^2 + 2 v.(w x r), of which the second does not change. *)
let speed2 t place =
  let v = t.process.velocity in
  match t.kinematics with
  | Turning k when spins t ->
    let k = Later.force k in
    let arm = Vec.sub place k.centre in
    followed (steady t k arm) (fun () ->
        let round = Vec.norm2 (Vec.cross t.process.spin arm) in
        let constant = Polynomial.scale (Rat.add (Vec.norm2 v) round) k.bottom in
        Quotient (Polynomial.add constant (Polynomial.scale two (dot v (swing t arm))), k.bottom))
  | Straight | Turning _ -> Steady (Vec.norm2 v)

let straight_distance2 p from q towards =
  let d = Vec.sub towards from and w = Vec.sub q.process.velocity p.process.velocity in
  if Vec.is_zero w then Steady (Vec.norm2 d)
  else polynomial (Polynomial.of_coefficients [ Vec.norm2 d; Rat.mul two (Vec.dot d w); Vec.norm2 w ])

(* |d + s - r|^2 for the vector d from centre to centre and the arms r and s, whose lengths do not change:
   |d|^2 + |r|^2 + |s|^2 + 2 d.s - 2 d.r - 2 r.s. *)
let turning_distance2 (p, k, from) (q, l, towards) =
  let from = Vec.sub from k.centre and towards = Vec.sub towards l.centre in
  followed (steady p k from && steady q l towards) @@ fun () ->
  let open Polynomial in
  let along a = sub (centre_line q l a) (centre_line p k a) in
  let d = { x = along X; y = along Y; z = along Z } in
  let r = turning_now p from and s = turning_now q towards in
  let lengths = Rat.add (Vec.norm2 from) (Vec.norm2 towards) in
  let bottom = mul k.bottom l.bottom in
  let straight = mul (add (product d d) (constant lengths)) bottom in
  let bent = sub (mul (product d s) k.bottom) (add (mul (product d r) l.bottom) (product r s)) in
  Quotient (add straight (scale two bent), bottom)

let distance2 p from q towards =
  match (p.kinematics, q.kinematics) with
  | Turning k, Turning l when spins p || spins q ->
    let k = Later.force k and l = Later.force l in
    turning_distance2 (p, k, from) (q, l, towards)
  | (Straight | Turning _), (Straight | Turning _) -> straight_distance2 p from q towards

(* {1 Processes} *)

let steadily t value =
  match t.kinematics with
  | Straight -> Steady value
  | Turning k -> followed (steady_spin t (Later.force k)) (fun () -> Steady value)

let spin t a = steadily t (Vec.component a t.process.spin)
let spin2 t = steadily t (Vec.norm2 t.process.spin)

let of_mass t quantity =
  match State.mass t.model t.process with
  | None -> Steady Rat.zero
  | Some mass -> Steady (quantity mass)

let momentum t a = of_mass t (fun mass -> Rat.mul mass (Vec.component a t.process.velocity))

(* That of a free body is kept. Else it is I w, and turns with the body. *)
let turning_angular t k a =
  match (Later.force k.mover).mass with
  | None -> Steady Rat.zero
  | Some mass ->
    let velocity = t.process.velocity in
    let still = Mass.angular_momentum mass ~velocity ~spin:Vec.zero ~about:Vec.zero in
    let still = Vec.component a still and inertia, own = own t k in
    let constant = free t || isotropic inertia || along t own in
    followed (free t || (isotropic inertia && steady_spin t k) || steady t k own) (fun () ->
        if constant then Steady (Rat.add still (Vec.component a own))
        else
          let orbit = Polynomial.scale still k.bottom in
          Quotient (Polynomial.add orbit (component a (turning_now t own)), k.bottom))

let angular t a =
  let of_point mass =
    let momentum = Vec.cross (State.centre_of_mass t.model t.process) t.process.velocity in
    Rat.mul mass (Vec.component a momentum)
  in
  match t.kinematics with
  | Straight -> of_mass t of_point
  | Turning k -> turning_angular t (Later.force k) a

(* m |v|^2 / 2 + (l . J l) / 2, with J the inverse of the inertia now, and l the angular momentum, which stays, as
   seen from the body, which turns: it turns the other way, C(since) C(since + t)^-1. *)
let free_energy t k (mass : Mass.t) =
  let { State.since; spin; kept; velocity; _ } = t.process in
  let here = Quaternion.to_mat (turned t) in
  let apply (m : Mat.t) c = { x = dot m.r0 c; y = dot m.r1 c; z = dot m.r2 c } in
  let l = apply here (turning_from ~since ~spin:(Vec.neg spin) kept) in
  let j = apply (Mass.inverse_inertia mass) l in
  let straight = Rat.mul mass.mass (Vec.norm2 velocity) in
  let bottom = Polynomial.mul k.bottom k.bottom in
  Quotient
    (Polynomial.add (Polynomial.scale straight bottom) (product l j), Polynomial.scale two bottom)

let turning_energy t k =
  match (Later.force k.mover).mass with
  | None -> Steady Rat.zero
  | Some mass ->
    let velocity = t.process.velocity and spin = (Later.force k.mover).spin in
    followed (steady_energy t k) (fun () ->
        if free t && not (isotropic mass.inertia || along t t.process.kept) then free_energy t k mass
        else Steady (Mass.energy mass ~velocity ~spin))

let energy t =
  match t.kinematics with
  | Straight -> of_mass t (fun mass -> Rat.mul Rat.half (Rat.mul mass (Vec.norm2 t.process.velocity)))
  | Turning k -> turning_energy t (Later.force k)
