(* What a process remembers of its answers, against a list of all of them; and where states came up. *)

open Scc_parallel
open Scc_graph_search
module Gen = QCheck2.Gen

(* Of each answer its tuple and the changes of its steps: places and numbers. *)
let answers =
  let open Gen in
  let* width = 1 -- 40 in
  let changes = list_size (0 -- 5) (pair (0 -- (width - 1)) (0 -- 1000)) in
  let answer = pair (array_size (return width) (0 -- 1000)) (list_size (0 -- 6) changes) in
  let+ list = list_size (1 -- 40) answer and+ copies = oneofl [ 1; 1; 1; 200 ] in
  (width, List.concat (List.init copies (fun _ -> list)))

let step changes =
  let keep known (i, v) = if List.mem_assoc i known then known else (i, v) :: known in
  let once = List.fold_left keep [] changes in
  { Lts.label = 0; changes = Array.of_list (List.concat_map (fun (i, v) -> [ i; v ]) once) }

(* Each end of each step, by its places: what it is, and how far back its answer begins. *)
let remembered (width, list) =
  let a = Answered.create ~width in
  let ends = ref [] and place = ref 0 in
  List.iter
    (fun (tuple, changes) ->
       let steps = List.map step changes in
       Answered.keep a tuple steps;
       let answer = !place and at = ref (!place + Answered.first_step ~width) in
       List.iter
         (fun (s : Lts.step) ->
            ends := (answer, !at, Tuples.apply s.changes tuple) :: !ends;
            at := !at + Answered.room_of_step s)
         steps;
       place := !place + Answered.room ~width steps)
    list;
  List.for_all
    (fun (answer, step, expected) ->
       match Answered.tuple a ~answer ~step with
       | Some tuple -> tuple = expected
       | None -> !place - answer > Answered.surely)
    !ends
  && Answered.tuple a ~answer:!place ~step:!place = None

let remembers =
  QCheck2.Test.make ~count:200 ~name:"states are found by where they came up, or are known to be gone"
    ~print:(fun (width, list) -> Printf.sprintf "width %d, %d answers" width (List.length list))
    answers remembered

let overwritten () =
  let width = 1000 in
  let a = Answered.create ~width and s = { Lts.label = 0; changes = [| 3; 7 |] } in
  let tuple k = Array.make width k in
  let room = Answered.room ~width [ s ] in
  let last = 10_000 in
  Answered.keep a (tuple 0) [ s ];
  Alcotest.(check int) "two numbers a word" (room / 2) (Answered.words a);
  for k = 1 to last do Answered.keep a (tuple k) [ s ] done;
  Alcotest.(check int) "16 MiB at most" (1 lsl 21) (Answered.words a);
  let found k = Answered.tuple a ~answer:(k * room) ~step:((k * room) + width) in
  Alcotest.(check bool) "the first one is gone" true (found 0 = None);
  let back = Answered.surely / room in
  let expected = tuple (last - back + 1) in
  expected.(3) <- 7;
  Alcotest.(check (option (array int))) "not so far back" (Some expected) (found (last - back + 1))

let origins () =
  let o = Origins.create () in
  Origins.put o 5 ~worker:1 ~answer:100 ~step:110;
  let found = Alcotest.(check (option (pair int int))) in
  found "as it was put" (Some (100, 110)) (Origins.find o 5 ~worker:1);
  found "another process" None (Origins.find o 5 ~worker:2);
  found "another state" None (Origins.find o 6 ~worker:1);
  Origins.put o (5 + (1 lsl 20)) ~worker:1 ~answer:7 ~step:8;
  found "in the same place" None (Origins.find o 5 ~worker:1)

let () =
  Alcotest.run "answered"
    [
      ("random", Scc_test_support.Property.cases [ remembers ]);
      ( "cases",
        [ Alcotest.test_case "overwritten" `Quick overwritten; Alcotest.test_case "origins" `Quick origins ] );
    ]
