(* Rotations by an axis and an angle, and which of them are exact. *)
open Scc_exact
open Scc_mesh

(* A rotation in floats, by the formula of Rodrigues. *)
let rotated (ax, ay, az) angle (x, y, z) =
  let l = sqrt ((ax *. ax) +. (ay *. ay) +. (az *. az)) in
  let ax = ax /. l and ay = ay /. l and az = az /. l in
  let c = cos angle and s = sin angle in
  let d = (ax *. x) +. (ay *. y) +. (az *. z) in
  ( (x *. c) +. (s *. ((ay *. z) -. (az *. y))) +. (ax *. d *. (1. -. c)),
    (y *. c) +. (s *. ((az *. x) -. (ax *. z))) +. (ay *. d *. (1. -. c)),
    (z *. c) +. (s *. ((ax *. y) -. (ay *. x))) +. (az *. d *. (1. -. c)) )

let rotations =
  let open QCheck2 in
  let part = Gen.map (fun n -> Rat.make (Z.of_int n) (Z.of_int 1000)) (Gen.int_range (-5000) 5000) in
  let quarters k = Rat.make (Z.of_int (k * 15708)) (Z.of_int 10000) in
  let angle = Gen.oneof [ part; Gen.map quarters (Gen.int_range (-9) 9) ] in
  Test.make ~name:"rotations are within their bound of the rotations by floats" ~count:2000
    (Gen.pair (Gen.triple part part part) angle)
    (fun ((x, y, z), angle) ->
       let axis = Vec.make x y z in
       match Turn.rotation axis angle with
       | None -> Vec.is_zero axis
       | Some (m, bound) ->
         let f = Rat.to_float in
         let far (p, q, r) =
           let v = Mat.apply m (Vec.of_ints p q r) in
           let a, b, c = rotated (f x, f y, f z) (f angle) (float p, float q, float r) in
           let d u w = (f u -. w) ** 2. in
           sqrt (d v.x a +. d v.y b +. d v.z c)
         in
         let identity = Mat.equal (Mat.mul m (Mat.transpose m)) Mat.identity in
         let near p = far p <= f bound +. 3e-7 in
         let units = [ (1, 0, 0); (0, 1, 0); (0, 0, 1) ] in
         identity && Rat.equal (Mat.det m) Rat.one && (Vec.is_zero axis || List.for_all near units))

let exact_of x =
  let m, e = Float.frexp x in
  Rat.mul (Rat.make (Z.of_float (ldexp m 53)) Z.one) (Rat.power_of_two (e - 53))

(* Which angles are multiples of a right angle, by the 32-bit numbers of the machine: only these are read without a
   distance, and only 0 as 0. The
   32-bit number itself is not the multiple: it is off by up to half a step. *)
let multiples =
  let open QCheck2 in
  let bits x = Int32.bits_of_float x in
  let quarter k = Int32.float_of_bits (bits (float k *. acos (-1.) /. 2.)) in
  let step = Gen.oneofl [ 0.; 1e-3; 1e-6; 1e-9; 1e-12; 0.5; 1.; 2. ] in
  let gen = Gen.(triple (int_range (-40) 40) step (int_range (-9) 9)) in
  Test.make ~name:"no rotation is dropped" ~count:2000 gen (fun (k, step, n) ->
      (* Steps of neighbouring 32-bit numbers, or of their own. *)
      let here = quarter k in
      let unit = if step < 0.5 then 1. else Float.abs here *. ldexp 1. (-24) in
      let angle = here +. (float n *. step *. unit) in
      let exact = angle = 0. || (k <> 0 && bits angle = bits here) in
      match Turn.rotation (Vec.of_ints 0 0 1) (exact_of angle) with
      | Some (m, off) ->
        let told = Rat.sign off > 0 in
        let far = Float.hypot (Rat.to_float m.Mat.r0.y +. sin angle) (Rat.to_float m.r0.x -. cos angle) in
        if told = exact then Test.fail_reportf "%.17g: told %b" angle told;
        if told then far <= Rat.to_float off +. 1e-15 else far <= Float.abs angle *. ldexp 1. (-23)
      | None -> false)

let suite = ("turn", [ ("rotations", List.map Scc_test_support.Property.case [ rotations; multiples ]) ])
