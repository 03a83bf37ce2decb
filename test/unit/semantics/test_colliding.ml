(* Who collides, against a list of pairs. *)

open Scc_engine
module Gen = QCheck2.Gen

type body = { first : int; mutable age : int }

type step =
  | Meet of int * int
  | Part of int
  | Change of int  (** it becomes another one, and the pairs are told *)
  | Tell of int  (** they are told, and it is as it was *)
  | Find

let leaves = 9

let step =
  let open Gen in
  let leaf = int_bound (leaves - 1) in
  frequency
    [
      (8, map2 (fun a b -> Meet (a, b)) leaf leaf); (2, map (fun a -> Part a) leaf);
      (3, map (fun a -> Change a) leaf); (1, map (fun a -> Tell a) leaf); (4, pure Find);
    ]

let print = function
  | Meet (a, b) -> Printf.sprintf "meet %d %d" a b
  | Part a -> Printf.sprintf "part %d" a
  | Change a -> Printf.sprintf "change %d" a
  | Tell a -> Printf.sprintf "tell %d" a
  | Find -> "find"

(* None to three for each pair, which depend on how old both are. *)
let outcomes p q =
  let count = (p.first + q.first + p.age + q.age) mod 4 in
  List.init count (fun k -> (p.first, q.first, p.age, q.age, k))

(* Some pairs stop one or both of their bodies, and others keep theirs from stopping. *)
let of_pair p q =
  let n = (p.first + (2 * q.first) + p.age + q.age) mod 7 in
  let stops = match n with 0 | 1 -> [ p.first ] | 2 -> [ p.first; q.first ] | 3 -> [ q.first ] | _ -> [] in
  { Colliding.outcomes = outcomes p q; busy = n = 4; stops }

let stopping bodies pairs =
  let all = List.map (fun (a, b) -> (a, b, of_pair bodies.(a) bodies.(b))) pairs in
  let is_busy first = List.exists (fun (a, b, found) -> found.Colliding.busy && (a = first || b = first)) all in
  let stops = List.concat_map (fun (_, _, found) -> found.Colliding.stops) all in
  List.sort_uniq compare (List.filter (fun first -> not (is_busy first)) stops)

let as_a_list =
  QCheck2.Test.make ~count:500 ~name:"pairs and what comes of them"
    ~print:QCheck2.Print.(list print)
    Gen.(list_size (0 -- 80) step)
    (fun steps ->
       let bodies = Array.init leaves (fun first -> { first; age = 0 }) in
       let colliding = Colliding.create leaves ~first:(fun b -> b.first) ~age:(fun b -> b.age) in
       let found = ref 0 in
       let take pairs = function
         | Meet (a, b) when a = b -> pairs
         | Meet (a, b) ->
           let a, b = (Int.min a b, Int.max a b) in
           Colliding.meet colliding bodies.(a) bodies.(b);
           List.sort_uniq compare ((a, b) :: pairs)
         | Part a ->
           Colliding.part colliding a;
           List.filter (fun (b, c) -> a <> b && a <> c) pairs
         | Change a ->
           bodies.(a).age <- bodies.(a).age + 1;
           Colliding.changed colliding a;
           pairs
         | Tell a ->
           Colliding.changed colliding a;
           pairs
         | Find ->
           Colliding.find colliding (fun p q ->
               incr found;
               of_pair p q);
           let expected = List.concat_map (fun (a, b) -> outcomes bodies.(a) bodies.(b)) pairs in
           let told = List.init (Colliding.count colliding) (Colliding.nth colliding) in
           let involved = List.sort_uniq compare (List.concat_map (fun (a, b) -> [ a; b ]) pairs) in
           if told <> expected then QCheck2.Test.fail_report "other outcomes";
           if List.map (fun b -> b.first) (Colliding.bodies colliding) <> involved then
             QCheck2.Test.fail_report "other bodies";
           if Colliding.stopping colliding <> stopping bodies pairs then
             QCheck2.Test.fail_report "others that stop";
           pairs
       in
       let pairs = List.fold_left take [] (steps @ [ Find ]) in
       (* Once all is known, nothing is found again, whoever is told. *)
       found := 0;
       ignore (List.fold_left take pairs [ Tell 3; Tell 4; Find ]);
       !found = 0)

let none () =
  let colliding = Colliding.create 2 ~first:(fun b -> b.first) ~age:(fun b -> b.age) in
  Colliding.meet colliding { first = 0; age = 0 } { first = 1; age = 0 };
  Alcotest.(check int) "none is found before it is looked for" 0 (Colliding.count colliding);
  match Colliding.nth colliding 0 with
  | exception Scc_base.Bug.Bug _ -> ()
  | (_ : int) -> Alcotest.fail "an outcome"

let suite =
  ( "colliding",
    [
      ("cases", [ Alcotest.test_case "nothing is found by itself" `Quick none ]);
      ("as a list", Scc_test_support.Property.cases [ as_a_list ]);
    ] )
