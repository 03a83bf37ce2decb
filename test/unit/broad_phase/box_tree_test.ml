(* The tree of boxes against a plain list, over random histories. *)

open Scc_geometry
open Scc_broad_phase
module Gen = QCheck2.Gen

type place = Anew of Float_box.t | Shifted of float

type change =
  | Insert of Float_box.t
  | Remove of int  (** of those there, by number *)
  | Move of (int * place) list  (** a batch *)
  | Ask of Float_box.t

let box low high = Float_box.make ~low ~high

(* Mostly small boxes close together; some long ones, some points, some that reach to infinity. *)
let interval =
  let open Gen in
  let at low size = (low, low +. size) in
  frequency
    [
      (12, map2 at (float_range (-20.) 20.) (float_range 0. 3.));
      (1, map (fun x -> (x, x)) (float_range (-20.) 20.));
      (1, map2 at (float_range (-1e6) 0.) (float_range 0. 2e6));
      (1, map (fun x -> (x, infinity)) (float_range (-20.) 20.));
      (1, map (fun x -> (neg_infinity, x)) (float_range (-20.) 20.));
      (1, pure (neg_infinity, infinity));
    ]

let random_box =
  Gen.map
    (fun ((a, b), (c, d), (e, f)) -> box [| a; c; e |] [| b; d; f |])
    (Gen.triple interval interval interval)

let place =
  Gen.(oneof [ map (fun b -> Anew b) random_box; map (fun d -> Shifted d) (float_range (-2.) 2.) ])

let change =
  let open Gen in
  frequency
    [
      (5, map (fun b -> Insert b) random_box); (3, map (fun i -> Remove i) nat);
      (6, map (fun moves -> Move moves) (list_size (1 -- 20) (pair nat place)));
      (2, map (fun b -> Ask b) random_box);
    ]

let keys iter =
  let keys = ref [] in
  iter (fun k -> keys := k :: !keys);
  List.sort Int.compare !keys

let found tree b = keys (Box_tree.iter_meeting tree b)

let moved_pairs tree =
  let pairs = ref [] in
  Box_tree.iter_moved_pairs tree (fun i j -> pairs := (Int.min i j, Int.max i j) :: !pairs);
  List.sort compare !pairs

let expected_pairs there moved =
  let with_later (i, b) (j, c) =
    if i < j && (List.mem i moved || List.mem j moved) && Float_box.meet b c then Some (i, j) else None
  in
  List.sort compare (List.concat_map (fun one -> List.filter_map (with_later one) there) there)

let expected there b =
  List.filter (fun (_, c) -> Float_box.meet b c) there |> List.map fst |> List.sort Int.compare

(* With n leaves, at most so many levels. *)
let balanced tree n = float_of_int (Box_tree.height tree) <= 2.5 *. Float.log2 (float_of_int (n + 2))

(* Keys are used again as soon as they are free. *)
let play changes =
  let tree = Box_tree.create () in
  let free_key there =
    let rec from k = if List.mem_assoc k there then from (k + 1) else k in
    from 0
  in
  let step there = function
    | Insert b ->
      let key = free_key there in
      Box_tree.insert tree key b;
      (key, b) :: there
    | (Remove _ | Move _) when there = [] -> there
    | Remove i ->
      let key, _ = List.nth there (i mod List.length there) in
      Box_tree.remove tree key;
      List.remove_assoc key there
    | Move moves ->
      let moved (i, place) =
        let key, b = List.nth there (i mod List.length there) in
        let shifted d of_axis = Array.init 3 (fun axis -> of_axis b axis +. d) in
        match place with
        | Anew b -> (key, b)
        | Shifted d -> (key, box (shifted d Float_box.low) (shifted d Float_box.high))
      in
      let moves = List.sort_uniq (fun (i, _) (j, _) -> Int.compare i j) (List.map moved moves) in
      Box_tree.move tree moves;
      let moved = List.map fst moves in
      let there = moves @ List.filter (fun (key, _) -> not (List.mem key moved)) there in
      if moved_pairs tree <> expected_pairs there moved then
        QCheck2.Test.fail_report "other pairs than a list gives";
      there
    | Ask b ->
      if found tree b <> expected there b then QCheck2.Test.fail_report "another answer than a list gives";
      there
  in
  let there = List.fold_left step [] changes in
  List.for_all (fun (k, b) -> Box_tree.mem tree k && List.mem k (found tree b)) there
  && balanced tree (List.length there)
  && Box_tree.is_sound tree
  && List.length (found tree (box (Array.make 3 neg_infinity) (Array.make 3 infinity))) = List.length there

let agrees =
  QCheck2.Test.make ~name:"the boxes that meet, whatever came and went" ~count:300
    Gen.(list_size (0 -- 200) change)
    play

(* In a large grid a query looks at few boxes, also between walls much longer than anything else. *)
let large () =
  let tree = Box_tree.create () in
  let n = 20 in
  let cell i =
    let x = float_of_int (i mod n) and y = float_of_int (i / n mod n) and z = float_of_int (i / (n * n)) in
    box [| x; y; z |] [| x +. 0.5; y +. 0.5; z +. 0.5 |]
  in
  for i = 0 to (n * n * n) - 1 do
    Box_tree.insert tree i (cell i)
  done;
  let wall = box [| -1e9; -1e9; -1. |] [| 1e9; 1e9; 0. |] in
  Box_tree.insert tree (n * n * n) wall;
  Alcotest.(check bool) "height" true (balanced tree (n * n * n));
  Alcotest.(check int) "on the wall" ((n * n) + 1) (List.length (found tree wall));
  let near = box [| 4.9; 4.9; 4.9 |] [| 6.1; 6.1; 6.1 |] in
  Alcotest.(check int) "in the middle" 8 (List.length (found tree near));
  for i = 0 to (n * n * n) - 1 do
    if i mod 7 > 0 then Box_tree.remove tree i
  done;
  Alcotest.(check bool) "height after most have gone" true (balanced tree ((n * n * n / 7) + 2));
  Alcotest.(check bool) "nodes as small as may be" true (Box_tree.is_sound tree)

(* Boxes that come in order, the ways in which trees grow crooked: in a row, one inside the other. *)
let rows () =
  let check what make remove =
    let tree = Box_tree.create () in
    for i = 0 to 1999 do
      Box_tree.insert tree i (make (float_of_int i));
      if i mod 3 = 2 && remove i then Box_tree.remove tree (i / 2);
      if i mod 50 = 0 && not (Box_tree.is_sound tree && balanced tree (i + 1)) then
        Alcotest.failf "%s: out of balance after %d" what i
    done
  in
  let cube x y z size = box [| x; y; z |] [| x +. size; y +. size; z +. size |] in
  let never _ = false and seldom i = i mod 6 = 2 in
  check "in a row" (fun i -> cube i 0. 0. 1.) never;
  check "in a row that loses its middle" (fun i -> cube i 0. 0. 1.) seldom;
  check "nested" (fun i -> cube 0. 0. 0. (4. +. (i /. 1000.))) never;
  check "spreading" (fun i -> cube (Float.exp (i /. 100.)) 0. 0. 1.) never;
  check "to all sides" (fun i -> cube (i *. Float.cos i) (i *. Float.sin i) 0. (1.1 +. Float.sin i)) seldom

let twice () =
  let tree = Box_tree.create () in
  let b = box [| 0.; 0.; 0. |] [| 1.; 1.; 1. |] in
  Box_tree.insert tree 3 b;
  let refused f = match f () with () -> false | exception Scc_base.Bug.Bug _ -> true in
  Alcotest.(check bool) "no key twice" true (refused (fun () -> Box_tree.insert tree 3 b));
  Alcotest.(check bool) "nor one that is not there" true (refused (fun () -> Box_tree.remove tree 2))

let () =
  Alcotest.run "box tree"
    [
      ( "known",
        [
          Alcotest.test_case "a large grid" `Quick large;
          Alcotest.test_case "rows and nests" `Quick rows;
          Alcotest.test_case "misuse is a bug" `Quick twice;
        ] );
      ("properties", Scc_test_support.Property.cases [ agrees ]);
    ]
