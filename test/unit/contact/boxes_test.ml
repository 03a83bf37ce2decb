open Scc_geometry
open Scc_broad_phase
module Gen = QCheck2.Gen

let halves n = float_of_int n /. 2.
let interval = Gen.map2 (fun low size -> (halves low, halves (low + size))) Gen.(-9 -- 9) Gen.(0 -- 5)

let random_box =
  Gen.map
    (fun ((a, b), (c, d), (e, f)) -> Float_box.make ~low:[| a; c; e |] ~high:[| b; d; f |])
    (Gen.triple interval interval interval)

let all_pairs boxes =
  let n = Array.length boxes in
  let below j = List.filter (fun i -> Float_box.meet boxes.(i) boxes.(j)) (List.init j Fun.id) in
  List.concat_map (fun j -> List.map (fun i -> (i, j)) (below j)) (List.init n Fun.id)

let compare_pair (i, j) (k, l) = if Int.equal i k then Int.compare j l else Int.compare i k

let complete =
  QCheck2.Test.make ~name:"exactly the boxes that meet, in order" ~count:150
    Gen.(array_size (0 -- 40) random_box)
    (fun boxes -> Boxes.pairs boxes = List.sort compare_pair (all_pairs boxes))

(* The floor meets every cube of the lowest layer, and unit cubes on a unit grid meet their neighbours. *)
let grid () =
  let box x y z sx sy sz =
    Float_box.make ~low:[| x; y; z |] ~high:[| x +. sx; y +. sy; z +. sz |]
  in
  let cube i =
    box (float_of_int (i mod 10)) (float_of_int (i / 10 mod 10)) (float_of_int (i / 100)) 1. 1. 1.
  in
  let boxes = Array.init 1000 cube in
  let floor = box (-100.) (-100.) (-1.) 200. 200. 1. in
  let found = Boxes.pairs (Array.append [| floor |] boxes) in
  (* ordered pairs of cells at distance at most 1 along each axis, without the cells themselves, halved *)
  Alcotest.(check int) "pairs" ((((28 * 28 * 28) - 1000) / 2) + 100) (List.length found);
  Alcotest.(check bool) "the floor first" true (List.hd found = (0, 1))

(* A box at a time of a sweep, given exactly, is within what it sweeps: also where nothing is a float exactly. *)
let sweeps =
  let open Scc_exact in
  let thirds n = Rat.make (Z.of_int n) (Z.of_int 3) in
  let vector = Gen.map (fun (x, y, z) -> Vec.make (thirds x) (thirds y) (thirds z)) Gen.(triple (-9 -- 9) (-9 -- 9)
                                                                                           (-9 -- 9)) in
  let print (a, v, (n, d)) = Printf.sprintf "%s by %s, %d/7 of %d/3" (Vec.to_string a) (Vec.to_string v) n d in
  QCheck2.Test.make ~name:"a box is within what it sweeps" ~count:250 ~print
    Gen.(triple vector vector (pair (0 -- 7) (1 -- 9)))
    (fun (a, v, (n, d)) ->
       let until = thirds d in
       let time = Rat.mul until (Rat.make (Z.of_int n) (Z.of_int 7)) in
       let b = Vec.add a (Vec.of_ints 1 2 3) in
       let swept = Float_box.swept v ~until:(Float_box.up until) (Float_box.of_corners a b) in
       let exactly x = Rat.of_literal (Printf.sprintf "%.60f" x) |> Result.get_ok in
       let within axis =
         let at q = Rat.add (Vec.component axis q) (Rat.mul time (Vec.component axis v)) in
         let k = match axis with Vec.X -> 0 | Y -> 1 | Z -> 2 in
         let low = exactly (Float_box.low swept k) and high = exactly (Float_box.high swept k) in
         Rat.compare low (at a) <= 0
         && Rat.compare (at b) high <= 0
         (* and not by much: no more than the way, and what rounding adds *)
         && Rat.compare (Rat.sub high low)
           (Rat.add (thirds 10) (Rat.mul until (Rat.abs (Vec.component axis v)))) <= 0
       in
       List.for_all within [ Vec.X; Y; Z ])

let suite =
  ("boxes",
   [ ("known", [ Alcotest.test_case "a grid of cubes on a floor" `Quick grid ]);
     ("properties", Scc_test_support.Property.cases [ complete; sweeps ]) ])
