open Scc_exact

type part = { body : Placed.t; mass : Rat.t }
type t = { mass : Rat.t; centre : Vec.t; inertia : Mat.t }

let of_part (p : part) =
  let solid = p.body.solid in
  let own = Mat.scale (Rat.div p.mass solid.volume) solid.inertia in
  let inertia =
    if Quaternion.is_identity p.body.turned then own
    else
      let r = Quaternion.to_mat p.body.turned in
      Mat.mul r (Mat.mul own (Mat.transpose r))
  in
  { mass = p.mass; centre = Placed.centroid p.body; inertia }

(* The inertia of a point mass at r from the axes: m (|r|^2 - r r^T). *)
let of_point mass (r : Vec.t) =
  let square = Mat.diagonal (let s = Vec.norm2 r in Vec.make s s s) in
  let dyad = Mat.make (Vec.scale r.x r) (Vec.scale r.y r) (Vec.scale r.z r) in
  Mat.scale mass (Mat.add square (Mat.scale (Rat.of_int (-1)) dyad))

(* By the parallel axis theorem. *)
let inertia_about b point =
  let r = Vec.sub b.centre point in
  if Vec.is_zero r then b.inertia else Mat.add b.inertia (of_point b.mass r)

let join = function
  | [] -> Scc_base.Bug.fail __POS__ "the mass of nothing"
  | [ b ] -> b
  | first :: rest as bodies ->
    let mass = List.fold_left (fun m b -> Rat.add m b.mass) first.mass rest in
    let moment = List.fold_left (fun s b -> Vec.axpy b.mass b.centre s) Vec.zero bodies in
    let centre = Vec.scale (Rat.div Rat.one mass) moment in
    let add sum b = Mat.add sum (inertia_about b centre) in
    { mass; centre; inertia = List.fold_left add (inertia_about first centre) rest }

let of_parts parts = join (List.map of_part parts)

let inverse_inertia b =
  match Mat.inverse b.inertia with
  | Some inverse -> inverse
  | None -> Scc_base.Bug.fail __POS__ "the inertia of a solid has no inverse"

let scale b =
  let trace = Rat.add b.inertia.r0.x (Rat.add b.inertia.r1.y b.inertia.r2.z) in
  let rec below e = if Rat.compare (Rat.power_of_two e) trace <= 0 then Rat.power_of_two e else below (e - 1) in
  below (Z.numbits trace.num - Z.numbits trace.den + 1)

let turn_rate b l = Mat.apply (inverse_inertia b) l

let momentum (b : t) ~velocity = Vec.scale b.mass velocity

let angular_momentum b ~velocity ~spin ~about =
  Vec.add (Mat.apply b.inertia spin) (Vec.cross (Vec.sub b.centre about) (momentum b ~velocity))

let energy (b : t) ~velocity ~spin =
  let twice = Rat.add (Rat.mul b.mass (Vec.norm2 velocity)) (Vec.dot spin (Mat.apply b.inertia spin)) in
  Rat.mul Rat.half twice
