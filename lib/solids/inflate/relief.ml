open Scc_exact

type profile = Diffused | Round

let quanta = 256
let most = 1 lsl 16

type t = {
  shape : Silhouette.t;
  heights : int array;
  radius : Rat.t;
  highest : int;
  off : Rat.t;
}

(* The least n with n^2 >= z. *)
let root_up z =
  let r = Z.sqrt z in
  if Z.equal (Z.mul r r) z then r else Z.succ r

(* Rounded up to 1/256, which is at most 1/256 too large and so at least the distance to what is outside. *)
let radius shape =
  Rat.make (root_up (Z.of_int (Silhouette.depth shape * quanta * quanta))) (Z.of_int quanta)

(* [numerator v / denominator] to the nearest integer, for v >= 0. *)
let nearest numerator denominator =
  Z.fdiv (Z.add (Z.shift_left numerator 1) denominator) (Z.shift_left denominator 1)

(* A height in quanta is at least 1, so that the two sides of the solid meet at its outline alone; and how far it
   may be off, in quanta: what the fixed point may be off included. *)
let diffused ~scale:(n, d) ~error v =
  let exact = Z.mul n (Z.of_int v) in
  let q = Z.max Z.one (nearest exact d) in
  let off = Z.add (Z.abs (Z.sub (Z.mul q d) exact)) (Z.mul n (Z.of_int error)) in
  (q, Rat.make off d)

(* Roots are bounded in units of 2^-16 of a quantum. *)
let fine = 16

let round ~scale:(n, d) ~error v =
  let square v = Z.mul n (Z.of_int v) in
  let shifted v = Z.shift_left (square v) (2 * fine) in
  let low = Z.sqrt (Z.fdiv (shifted (max 0 (v - error))) d) in
  let high = root_up (Z.cdiv (shifted (v + error)) d) in
  let q = Z.max Z.one (nearest (Z.sqrt (Z.fdiv (shifted v) d)) (Z.shift_left Z.one fine)) in
  let at = Z.shift_left q fine in
  let off = Z.max (Z.abs (Z.sub at low)) (Z.abs (Z.sub high at)) in
  (q, Rat.make off (Z.shift_left Z.one fine))

let make profile shape (found : Diffusion.t) ~greatest =
  let radius = radius shape in
  let unit = Rat.div greatest (Rat.of_int (1 lsl found.bits)) in
  let scale, height =
    match profile with
    | Diffused -> (Rat.div (Rat.mul unit (Rat.of_int quanta)) radius, diffused)
    | Round -> (Rat.mul unit (Rat.of_int (quanta * quanta)), round)
  in
  let height = height ~scale:(scale.num, scale.den) ~error:found.error in
  let off = ref Rat.zero and highest = ref Z.zero in
  let heights = Array.make (Array.length found.values) 0 in
  let limit = Z.of_int (most * quanta) in
  let one i v =
    if Bytes.get shape.Silhouette.inside i <> '\000' then begin
      let q, far = height v in
      highest := Z.max !highest q;
      off := Rat.max !off far;
      if Z.leq q limit then heights.(i) <- Z.to_int q
    end
  in
  Array.iteri one found.values;
  if Z.gt !highest limit then None
  else Some { shape; heights; radius; highest = Z.to_int !highest; off = Rat.div !off (Rat.of_int quanta) }

(* The heights of the pixels of another shape of the same picture, by those here. *)
let moved r (shape : Silhouette.t) height =
  let place i =
    let x = (i mod shape.width) + shape.left - r.shape.Silhouette.left in
    let y = (i / shape.width) + shape.top - r.shape.top in
    if Silhouette.is_inside r.shape x y then r.heights.((y * r.shape.width) + x) else 0
  in
  let inside i = Bytes.get shape.inside i <> '\000' in
  let heights = Array.init (Bytes.length shape.inside) (fun i -> if inside i then height (place i) else 0) in
  { r with shape; heights; highest = Array.fold_left Int.max 0 heights }

let part r shape = moved r shape Fun.id
let on_plate r ~margin ~plate = moved r (Silhouette.surrounded r.shape ~margin) (( + ) plate)
