(* Moving boxes in floats against the exact ones that they stand for. *)

open Scc_exact
open Scc_geometry
open Scc_broad_phase
module Gen = QCheck2.Gen

let ratio n d = Rat.make (Z.of_int n) (Z.of_int d)

let power n =
  if n >= 0 then Rat.make (Z.shift_left Z.one n) Z.one else Rat.make Z.one (Z.shift_left Z.one (-n))

(* From tiny to beyond what a float holds, and often simple. *)
let number =
  let open Gen in
  let simple = map2 ratio (-12 -- 12) (1 -- 4) in
  let scaled = map2 (fun q e -> Rat.mul q (power e)) simple (oneofl [ -1100; -60; 40; 1030 ]) in
  frequency [ (12, simple); (1, scaled); (2, map2 Rat.add simple scaled) ]

let vector = Gen.map3 Vec.make number number number

type moving = { low : Vec.t; high : Vec.t; velocity : Vec.t }

let moving =
  let make low size velocity =
    { low; high = Vec.add low (Vec.make (Rat.abs size.Vec.x) (Rat.abs size.y) (Rat.abs size.z)); velocity }
  in
  Gen.map3 make vector vector vector

let at t b = (Vec.axpy t b.velocity b.low, Vec.axpy t b.velocity b.high)

(* The boxes in a table, both until a time. *)
let table boxes ~until =
  let t = Moving_boxes.create (List.length boxes) in
  List.iteri
    (fun i b ->
       Moving_boxes.set t i (Float_box.of_corners b.low b.high) ~at:Vec.zero ~velocity:b.velocity;
       Moving_boxes.set_until t i until)
    boxes;
  t

let sweep_of b ~from ~until = Moving_boxes.swept (table [ b ] ~until) 0 ~from
let may_meet a b ~from ~until = Moving_boxes.may_meet (table [ a; b ] ~until) 0 1 ~from

(* Two times in order, and one between. *)
let times =
  let open Gen in
  let+ a = map Rat.abs number and+ b = map Rat.abs number and+ k = 0 -- 4 in
  let from = Rat.min a b and until = Rat.max a b in
  (from, until, Rat.add from (Rat.mul (ratio k 4) (Rat.sub until from)))

let print_vec = Vec.to_string
let print_box b = Printf.sprintf "%s..%s moving by %s" (print_vec b.low) (print_vec b.high) (print_vec b.velocity)
let print_times (a, b, t) = Printf.sprintf "[%s, %s], %s" (Rat.to_string a) (Rat.to_string b) (Rat.to_string t)

let until_float q = if Rat.sign q = 0 then Float.min_float else Float_box.up q

let rounding =
  QCheck2.Test.make ~name:"numbers lie between their floats" ~count:1000 ~print:Rat.to_string number (fun q ->
      let below = Float_box.down q and above = Float_box.up q in
      let at_most a b = Rat.compare a b <= 0 in
      (below = neg_infinity || at_most (Q.of_float below) q)
      && (above = infinity || at_most q (Q.of_float above))
      && below < infinity && above > neg_infinity)

let holds box ((low : Vec.t), (high : Vec.t)) =
  let one axis low high =
    let x0 = Float_box.low box axis and x1 = Float_box.high box axis in
    (x0 = neg_infinity || Rat.compare (Q.of_float x0) low <= 0)
    && (x1 = infinity || Rat.compare high (Q.of_float x1) <= 0)
    && x0 < infinity && x1 > neg_infinity
  in
  one 0 low.x high.x && one 1 low.y high.y && one 2 low.z high.z

let placed =
  QCheck2.Test.make ~name:"a placed box holds the exact one" ~count:1000
    ~print:(fun (b, p) -> print_box b ^ " at " ^ print_vec p)
    (Gen.pair moving vector)
    (fun (b, p) -> holds (Float_box.at p (Float_box.of_corners b.low b.high)) (Vec.add p b.low, Vec.add p b.high))

let swept =
  QCheck2.Test.make ~name:"a swept box holds the box all along" ~count:1000
    ~print:(fun (b, t) -> print_box b ^ " at " ^ print_times t)
    (Gen.pair moving times)
    (fun (b, (from, until, t)) ->
       holds (sweep_of b ~from:(Float_box.down from) ~until:(until_float until)) (at t b))

let meet_at t a b =
  let (low, high), (low', high') = (at t a, at t b) in
  let overlap x0 x1 y0 y1 = Rat.compare x0 y1 <= 0 && Rat.compare y0 x1 <= 0 in
  overlap low.x high.x low'.x high'.x && overlap low.y high.y low'.y high'.y
  && overlap low.z high.z low'.z high'.z

let never_misses =
  QCheck2.Test.make ~name:"what meets is let through" ~count:2000
    ~print:(fun (a, b, t) -> print_box a ^ "\n" ^ print_box b ^ "\n" ^ print_times t)
    (Gen.triple moving moving times)
    (fun (a, b, (from, until, t)) ->
       let let_through =
         may_meet a b ~from:(Float_box.down from) ~until:(until_float until)
         && may_meet b a ~from:(Float_box.down from) ~until:infinity
       in
       let_through || not (meet_at t a b || meet_at from a b || meet_at until a b))

(* Boxes made to meet exactly at a corner at the time t, in the midst of the interval. *)
let corner =
  QCheck2.Test.make ~name:"boxes that graze at a corner are let through" ~count:1000
    ~print:(fun (a, b, t) -> print_box a ^ "\n" ^ print_box b ^ "\n" ^ print_times t)
    (Gen.triple moving moving times)
    (fun (a, b, (from, until, t)) ->
       let _, high = at t a and low, _ = at t b in
       let shift = Vec.sub high low in
       let b = { b with low = Vec.add b.low shift; high = Vec.add b.high shift } in
       may_meet a b ~from:(Float_box.down from) ~until:(until_float until))

let bounds =
  QCheck2.Test.make ~name:"what meets does not do so before the bound" ~count:2000
    ~print:(fun (a, b, t) -> print_box a ^ "\n" ^ print_box b ^ "\n" ^ print_times t)
    (Gen.triple moving moving times)
    (fun (a, b, (from, until, t)) ->
       let bound = Moving_boxes.not_before (table [ a ] ~until:1.) 0 (table [ b ] ~until:1.) 0 in
       let agrees t = (not (meet_at t a b)) || (bound < infinity && Rat.compare (Q.of_float bound) t <= 0) in
       List.for_all agrees [ Rat.zero; from; until; t ])

let inside_at t a b =
  let (low, high), (low', high') = (at t a, at t b) in
  let overlap x0 x1 y0 y1 = Rat.compare x0 y1 < 0 && Rat.compare y0 x1 < 0 in
  overlap low.Vec.x high.Vec.x low'.Vec.x high'.Vec.x
  && overlap low.y high.y low'.y high'.y
  && overlap low.z high.z low'.z high'.z

(* Also of two that touch at the time [from], where one side meets another. *)
let bounds_of_interiors =
  QCheck2.Test.make ~name:"nor do interiors that meet" ~count:4000
    ~print:(fun (a, b, (t, _)) -> print_box a ^ "\n" ^ print_box b ^ "\n" ^ print_times t)
    (Gen.triple moving moving (Gen.pair times Gen.bool))
    (fun (a, b, ((from, until, t), touching)) ->
       let b =
         if not touching then b
         else
           let x = Rat.sub (snd (at from a)).x (fst (at from b)).x in
           let shift = Vec.make x Rat.zero Rat.zero in
           { b with low = Vec.add b.low shift; high = Vec.add b.high shift }
       in
       let bound = Moving_boxes.not_inside_before (table [ a ] ~until:1.) 0 (table [ b ] ~until:1.) 0 in
       let agrees t = (not (inside_at t a b)) || (bound < infinity && Rat.compare (Q.of_float bound) t <= 0) in
       List.for_all agrees [ Rat.zero; from; until; t; Rat.add from (ratio 1 1000) ])

let unit x velocity = { low = Vec.of_ints x 0 0; high = Vec.of_ints (x + 1) 1 1; velocity }

let filters () =
  let check what expected a b ~from ~until =
    Alcotest.(check bool) what expected (may_meet a b ~from ~until)
  in
  let still = unit 0 Vec.zero and left = unit 11 (Vec.of_ints (-1) 0 0) in
  check "not yet" false still left ~from:0. ~until:9.5;
  check "in time" true still left ~from:0. ~until:10.5;
  check "no more" false still left ~from:12.5 ~until:infinity;
  check "past one another" false still (unit 11 (Vec.of_ints (-1) 1 0)) ~from:0. ~until:100.;
  let t = table [ still; left ] ~until:100. in
  Moving_boxes.set_until t 1 9.5;
  Alcotest.(check bool) "only as long as both move so" false (Moving_boxes.may_meet t 0 1 ~from:0.);
  check "nothing moves" false still (unit 3 Vec.zero) ~from:0. ~until:1e9;
  let bound a b = Moving_boxes.not_before (table [ a ] ~until:1.) 0 (table [ b ] ~until:1.) 0 in
  Alcotest.(check bool) "in ten" true (bound still left > 9.99 && bound still left <= 10.);
  Alcotest.(check bool) "never" true (bound still (unit 3 Vec.zero) = infinity);
  let inside a b = Moving_boxes.not_inside_before (table [ a ] ~until:1.) 0 (table [ b ] ~until:1.) 0 in
  let touching = unit 1 in
  let never what a b = Alcotest.(check (float 0.)) what infinity (inside a b) in
  never "touching, and going apart" still (touching (Vec.of_ints 1 0 0));
  never "touching, side by side" still (touching (Vec.of_ints 0 1 0));
  never "touching, at rest" still (touching Vec.zero);
  never "touching in passing" (unit 0 (Vec.of_ints 1 0 0)) (unit 5 (Vec.of_ints 0 (-1) 0));
  Alcotest.(check (float 0.)) "touching, and going on" 0. (inside still (touching (Vec.of_ints (-1) 0 0)));
  Alcotest.(check (float 0.)) "touching is meeting" 0. (bound still (touching (Vec.of_ints 1 0 0)));
  Alcotest.(check bool) "later" true (inside still left > 9.99 && inside still left <= 10.);
  let sweep = sweep_of left ~from:0. ~until:infinity in
  Alcotest.(check bool) "for ever to the left" true (Float_box.low sweep 0 = neg_infinity);
  Alcotest.(check bool) "and nowhere else" true (Float_box.high sweep 0 < 12.1 && Float_box.high sweep 1 < 1.1)

let () =
  Alcotest.run "moving boxes"
    [
      ("known", [ Alcotest.test_case "what a filter stops" `Quick filters ]);
      ( "properties",
        Scc_test_support.Property.cases
          [ rounding; placed; swept; never_misses; corner; bounds; bounds_of_interiors ] );
    ]
