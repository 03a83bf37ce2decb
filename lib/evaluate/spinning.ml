open Scc_exact
open Scc_calculus
open Scc_property
open Scc_rigid
open Scc_semantics

(* [since] and [spin] say how it turns; the denominator of all that turns with it is [bottom]. *)
type t = {
  model : Model.t;
  process : State.process;
  mover : Impact.mover Lazy.t;
  centre : Vec.t;
  bottom : Polynomial.t;
  for_ever : bool;
}

(* A vector of polynomials. *)
type curve = { x : Polynomial.t; y : Polynomial.t; z : Polynomial.t }

let two = Rat.of_int 2
let quarter = Rat.make Z.one (Z.of_int 4)
let component (a : Property.axis) c = match a with X -> c.x | Y -> c.y | Z -> c.z
let of_vec (a : Property.axis) (v : Vec.t) = match a with X -> v.x | Y -> v.y | Z -> v.z
let dot (v : Vec.t) c = Polynomial.(add (scale v.x c.x) (add (scale v.y c.y) (scale v.z c.z)))

(* The value of a + b s + c s^2 at s = since + t, as a polynomial in t. *)
let shifted since a b c =
  let linear = Rat.add b (Rat.mul two (Rat.mul c since)) in
  let constant = Rat.add a (Rat.mul since (Rat.add b (Rat.mul c since))) in
  Polynomial.of_coefficients [ constant; linear; c ]

let make ?(for_ever = false) m (p : State.process) =
  {
    model = m;
    process = p;
    mover = lazy (Turn.mover m p);
    centre = State.centre_of_mass m p;
    bottom = shifted p.since Rat.one Rat.zero (Rat.mul quarter (Vec.norm2 p.spin));
    for_ever;
  }

let spins t = not (Vec.is_zero t.process.spin)

(* Over [t.bottom]: where a vector goes that turns with the process, and was [a] at the start of the turn, [since]
   ago; or is [r] now. With u = w s/2 the Cayley map takes a to
   ((1 - |u|^2) a + 2 (u.a) u + 2 u x a) / (1 + |u|^2). *)
let turning_from since t a =
  let w = t.process.spin in
  let b = Vec.cross w a in
  let c =
    Vec.scale quarter (Vec.sub (Vec.scale (Rat.mul two (Vec.dot w a)) w) (Vec.scale (Vec.norm2 w) a))
  in
  {
    x = shifted since a.x b.x c.x;
    y = shifted since a.y b.y c.y;
    z = shifted since a.z b.z c.z;
  }

let turning t r =
  let since = t.process.since in
  if spins t then
    let back = Quaternion.cayley (Vec.scale (Rat.div since two) t.process.spin) in
    turning_from since t (Quaternion.apply (Quaternion.inverse back) r)
  else turning_from since t r

(* {1 For ever}

   The curves are those of one turn. Over the ray of a network in which nothing happens any more, turn follows on
   turn, spins may be computed anew and orientations rounded: what changes with that is not followed. *)

let isotropic (i : Mat.t) = Mat.equal i (Mat.scale i.r0.x Mat.identity)

let free t = Turn.is_free t.model

(* The inertia, and the angular momentum about the centre. *)
let own t =
  match (Lazy.force t.mover).mass with
  | None -> (Mat.identity, Vec.zero)
  | Some mass ->
    (mass.inertia, if free t then t.process.kept else Mat.apply mass.inertia t.process.spin)

let along t r = Vec.is_zero (Vec.cross t.process.spin r)
let rounded t = Option.is_some (Turn.rigid t.model).round_orientation

let steady_spin t =
  (not (t.for_ever && spins t))
  || (not (free t))
  ||
  let inertia, momentum = own t in
  isotropic inertia || (along t momentum && not (rounded t))

(* A vector that turns with the process stays what it is when it lies along the spin. *)
let steady t r = Vec.is_zero r || (not (t.for_ever && spins t)) || (steady_spin t && along t r && not (rounded t))

let steady_energy t =
  (not (t.for_ever && spins t)) || (steady_spin t && ((not (rounded t)) || isotropic (fst (own t))))

let followed so value =
  if so then value () else Value.Undefined "what turns with a body that spins for ever is not followed"

let arm t place = Vec.sub place t.centre
let centre_curve t a = Polynomial.of_coefficients [ of_vec a t.centre; of_vec a t.process.velocity ]

let coordinate t a place =
  followed (steady t (arm t place)) (fun () ->
      let arm = turning t (arm t place) in
      Value.Ratio (Polynomial.add (Polynomial.mul (centre_curve t a) t.bottom) (component a arm), t.bottom))

(* The velocity over [t.bottom], less that of the centre: w x r turns as r does. *)
let swing t place = turning t (Vec.cross t.process.spin (Vec.sub place t.centre))

let velocity t a place =
  followed (steady t (arm t place)) (fun () ->
      let own = Polynomial.scale (of_vec a t.process.velocity) t.bottom in
      Value.Ratio (Polynomial.add own (component a (swing t place)), t.bottom))

(* |v|^2 + |w x r|^2 + 2 v.(w x r), of which the second does not change. *)
let speed2 t place =
  followed (steady t (arm t place)) @@ fun () ->
  let v = t.process.velocity in
  let round = Vec.norm2 (Vec.cross t.process.spin (Vec.sub place t.centre)) in
  let constant = Polynomial.scale (Rat.add (Vec.norm2 v) round) t.bottom in
  Value.Ratio (Polynomial.add constant (Polynomial.scale two (dot v (swing t place))), t.bottom)

(* |d + s - r|^2 for the vector d from centre to centre and the arms r and s, whose lengths do not change:
   |d|^2 + |r|^2 + |s|^2 + 2 d.s - 2 d.r - 2 r.s. *)
let distance2 p from q towards =
  followed (steady p (arm p from) && steady q (arm q towards)) @@ fun () ->
  let open Polynomial in
  let along a = sub (centre_curve q a) (centre_curve p a) in
  let d = { x = along X; y = along Y; z = along Z } in
  let product a b = add (mul a.x b.x) (add (mul a.y b.y) (mul a.z b.z)) in
  let r = turning p (arm p from) and s = turning q (arm q towards) in
  let lengths = Rat.add (Vec.norm2 (arm p from)) (Vec.norm2 (arm q towards)) in
  let bottom = mul p.bottom q.bottom in
  let straight = mul (add (product d d) (constant lengths)) bottom in
  let bent = sub (mul (product d s) p.bottom) (add (mul (product d r) q.bottom) (product r s)) in
  Value.Ratio (add straight (scale two bent), bottom)

let spin t a = followed (steady_spin t) (fun () -> Value.of_rat (of_vec a t.process.spin))
let spin2 t = followed (steady_spin t) (fun () -> Value.of_rat (Vec.norm2 t.process.spin))

(* That of a free body is kept. Else it is I w, and turns with the body. *)
let angular t a =
  match (Lazy.force t.mover).mass with
  | None -> Value.of_rat Rat.zero
  | Some mass ->
    let still =
      Mass.angular_momentum mass ~velocity:t.process.velocity ~spin:Vec.zero ~about:Vec.zero
    in
    let inertia, own = own t in
    let constant = free t || isotropic inertia || along t own in
    followed (free t || (isotropic inertia && steady_spin t) || steady t own) @@ fun () ->
    if constant then Value.of_rat (Rat.add (of_vec a still) (of_vec a own))
    else
      let orbit = Polynomial.scale (of_vec a still) t.bottom in
      Value.Ratio (Polynomial.add orbit (component a (turning t own)), t.bottom)

(* m |v|^2 / 2 + (l . J l) / 2, with J the inverse of the inertia now, and l the angular momentum, which stays, as
   seen from the body, which turns: it turns the other way, C(since) C(since + t)^-1. *)
let free_energy t (mass : Mass.t) =
  let back = { t with process = State.with_turn ~spin:(Vec.neg t.process.spin) ~since:Rat.zero t.process } in
  let l = turning_from t.process.since back t.process.kept in
  let here = Quaternion.to_mat (Quaternion.cayley (Vec.scale (Rat.div t.process.since two) t.process.spin)) in
  let apply (m : Mat.t) c = { x = dot m.r0 c; y = dot m.r1 c; z = dot m.r2 c } in
  let l = apply here l in
  let j = apply (Mass.inverse_inertia mass) l in
  let product = Polynomial.(add (mul l.x j.x) (add (mul l.y j.y) (mul l.z j.z))) in
  let straight = Rat.mul mass.mass (Vec.norm2 t.process.velocity) in
  let bottom = Polynomial.mul t.bottom t.bottom in
  Value.Ratio (Polynomial.add (Polynomial.scale straight bottom) product, Polynomial.scale two bottom)

let energy t =
  match (Lazy.force t.mover).mass with
  | None -> Value.of_rat Rat.zero
  | Some mass ->
    let velocity = t.process.velocity and spin = (Lazy.force t.mover).spin in
    followed (steady_energy t) (fun () ->
        if free t && not (isotropic mass.inertia || along t t.process.kept) then free_energy t mass
        else Value.of_rat (Mass.energy mass ~velocity ~spin))
