open Scc_exact
open Scc_geometry
module Gen = QCheck2.Gen

let halves n = Rat.make (Z.of_int n) (Z.of_int 2)
let vector (x, y, z) = Vec.make (halves x) (halves y) (halves z)
let point = Gen.map vector Gen.(triple (-9 -- 9) (-9 -- 9) (-9 -- 9))
let size = Gen.map vector Gen.(triple (0 -- 5) (0 -- 5) (0 -- 5))
let box = Gen.map2 (fun low size -> (low, Vec.add low size)) point size

let all_pairs boxes =
  let n = Array.length boxes in
  let below j = List.filter (fun i -> Boxes.meet boxes.(i) boxes.(j)) (List.init j Fun.id) in
  List.concat_map (fun j -> List.map (fun i -> (i, j)) (below j)) (List.init n Fun.id)

let compare_pair (i, j) (k, l) = if Int.equal i k then Int.compare j l else Int.compare i k

let complete =
  QCheck2.Test.make ~name:"exactly the boxes that meet, in order" ~count:300
    Gen.(array_size (0 -- 40) box)
    (fun boxes -> Boxes.pairs boxes = List.sort compare_pair (all_pairs boxes))

(* Boxes whose coordinates differ by less than floats can tell. *)
let fine =
  let tiny = Rat.make Z.one (Z.pow (Z.of_int 10) 40) in
  let place k = Vec.make (Rat.add Rat.one (Rat.mul tiny (Rat.of_int k))) Rat.one Rat.one in
  let near = Gen.map place Gen.(-3 -- 3) in
  QCheck2.Test.make ~name:"exact where floats see no difference" ~count:300
    Gen.(array_size (0 -- 10) (map (fun p -> (p, p)) near))
    (fun boxes -> Boxes.pairs boxes = List.sort compare_pair (all_pairs boxes))

let contains (low, high) p = Boxes.meet (low, high) (p, p)

let swept =
  QCheck2.Test.make ~name:"a swept box holds both ends of the way" ~count:300
    Gen.(triple box point (0 -- 4))
    (fun ((low, high), d, k) ->
       let s = Boxes.swept (low, high) d and part = Vec.scale (Rat.make (Z.of_int k) (Z.of_int 4)) d in
       contains s (Vec.add low part) && contains s (Vec.add high part))

(* The floor meets every cube of the lowest layer, and unit cubes on a unit grid meet their neighbours. *)
let grid () =
  let cube i = Vec.of_ints (i mod 10) (i / 10 mod 10) (i / 100) in
  let unit = Vec.of_ints 1 1 1 in
  let boxes = Array.init 1000 (fun i -> (cube i, Vec.add (cube i) unit)) in
  let floor = (Vec.of_ints (-100) (-100) (-1), Vec.of_ints 100 100 0) in
  let found = Boxes.pairs (Array.append [| floor |] boxes) in
  (* ordered pairs of cells at distance at most 1 along each axis, without the cells themselves, halved *)
  Alcotest.(check int) "pairs" ((((28 * 28 * 28) - 1000) / 2) + 100) (List.length found);
  Alcotest.(check bool) "the floor first" true (List.hd found = (0, 1))

let () =
  Alcotest.run "boxes"
    [ ("known", [ Alcotest.test_case "a grid of cubes on a floor" `Quick grid ]);
      ("properties", Scc_test_support.Property.cases [ complete; fine; swept ]) ]
