open Scc_exact

type t = {
  at : Vec.t;
  distance : Rat.t;
  turn : Rat.t;
  height : Rat.t;
  parallel : bool;
  up : Vec.axis;
  aspect : Rat.t;
}

(* The tangent of 20 degrees, to 16 digits: half of the angle from below to above. *)
let slope = Rat.make (Z.of_string "36397023426620236") (Z.of_string "100000000000000000")

(* What is nearer than that part of the distance is cut off, as on the page. *)
let least = Rat.make Z.one (Z.of_int 100)

(* Short enough for exact arithmetic, and less than 1/100 of a pixel in a picture of some thousands. *)
let quantum = Rat.power_of_two (-22)

let turned angle =
  let c, s = Angle.cos_sin_radians angle in
  (Rat.round_to c ~quantum, Rat.round_to s ~quantum)

(* To the right, up and to the front of the page. *)
let on_page t right up front =
  match t.up with
  | X -> Vec.make up right (Rat.neg front)
  | Y -> Vec.make right up front
  | Z -> Vec.make right (Rat.neg front) up

let camera t =
  let c, s = turned t.turn and ch, sh = turned t.height in
  let direction = on_page t (Rat.mul ch s) sh (Rat.mul ch c) in
  let camera = Camera.make ~up:(on_page t Rat.zero Rat.one Rat.zero) direction in
  if t.parallel then camera
  else Camera.with_eye camera { at = Vec.axpy t.distance direction t.at; least = Rat.mul least t.distance }

let canvas t (camera : Camera.t) ~origin ~width ~top =
  let right, up = Camera.lengths camera in
  let half = Rat.mul t.distance slope in
  let height = max 1 (Z.to_int (Rat.floor (Rat.add Rat.half (Rat.div (Rat.of_int width) t.aspect)))) in
  let unit_length = Rat.div (Rat.of_int height) (Rat.mul (Rat.of_int 2) half) in
  let middle, half =
    match camera.eye with
    | None -> (Camera.flat camera (Vec.sub t.at (Ivec.to_vec origin)), half)
    | Some _ -> ((Rat.zero, Rat.zero), Rat.div slope (Camera.length_near camera))
  in
  let along axis = Rat.mul half axis in
  Canvas.framed ~width ~height ~top ~middle ~half:(Rat.mul t.aspect (along right), along up) ~unit_length
