(* Time that passes: refinements of a passing change nothing, other changes are found. *)

open Scc_equivalence
open Scc_naive_equivalence

let run relation g h =
  Compare.run (Effort.unlimited ()) relation (Compare.prepare relation g) (Compare.prepare relation h)

let verdict relation g h =
  match (run relation g h).verdict with
  | Compare.Equivalent -> "equivalent"
  | Different { formula = Some _; _ } -> "different"
  | Different { formula = None; _ } -> "different, no formula"
  | Undecided _ -> "undecided"

let check name relation expected g h =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check string) name expected (verdict relation g h);
      Alcotest.(check string) (name ^ ", the other way") expected (verdict relation h g))

let time d = "time(" ^ d ^ ")"
let one_two = Naive.make 4 [ (0, time "1", 1); (1, time "2", 2); (2, "a", 3) ]
let three = Naive.make 3 [ (0, time "3", 1); (1, "a", 2) ]
let halves = Naive.make 4 [ (0, time "5/2", 1); (1, time "1/2", 2); (2, "a", 3) ]
let choice = Naive.make 4 [ (0, time "1", 1); (1, time "2", 2); (1, "b", 3); (2, "a", 3) ]
let four = Naive.make 3 [ (0, time "4", 1); (1, "a", 2) ]
let rest = Naive.make 1 [ (0, "time(forever)", 0) ]
let dead = Naive.make 1 []
let cycle = Naive.make 2 [ (0, time "1", 1); (1, time "1/3", 0) ]
let dead_later = Naive.make 2 [ (0, time "3", 1) ]
let rest_later = Naive.make 2 [ (0, time "3", 1); (1, "time(forever)", 1) ]

(* Time passes in two ways; the ways part at once, or after 1. *)
let parting = Naive.make 5 [ (0, time "2", 1); (0, time "2", 2); (1, "a", 3); (2, "b", 4) ]
let parting_later = Naive.make 6 [ (0, time "1", 1); (1, time "1", 2); (1, time "1", 3); (2, "a", 4); (3, "b", 5) ]
let parting_in_steps =
  Naive.make 7
    [ (0, time "1", 1); (0, time "3/2", 2); (1, time "1", 3); (2, time "1/2", 4); (3, "a", 5); (4, "b", 6) ]

let by_hand =
  [
    check "1 + 2 = 3" Timed "equivalent" one_two three;
    check "5/2 + 1/2 = 3" Timed "equivalent" halves three;
    check "a choice in the middle" Timed "different" choice three;
    check "3 is not 4" Timed "different" three four;
    check "rest is no dead end" Timed "different" rest dead;
    check "a cycle of time is rest" Timed "equivalent" rest cycle;
    check "a dead end later is no rest" Timed "different" dead_later rest;
    check "a dead end later is none now" Timed "different" dead_later dead;
    check "rest later is rest" Timed "equivalent" rest_later rest;
    check "ways that part later" Timed "different" parting parting_later;
    check "ways that part at once, cut" Timed "equivalent" parting parting_in_steps;
    check "durations are not seen by strong" Strong "equivalent" three four;
    check "strong sees that time passes" Strong "different" rest dead;
    check "branching does not" Branching "equivalent" rest dead;
    check "a choice in the middle, strong" Strong "different" choice three;
  ]

let texts relation g h =
  match (run relation g h).verdict with
  | Different { formula = Some f; trace; _ } ->
    let line (t, first) = String.concat " " t ^ if first then "" else " !" in
    ((run relation g h).show f, Option.map line trace)
  | _ -> ("", None)

let explanations () =
  let check name expected (g, h) =
    Alcotest.(check (pair string (option string))) name expected (texts Timed g h)
  in
  check "3 and 4" ("<time(3)><a>true", Some "time(3) a") (three, four);
  check "1, then b" ("<time(1)><b>true", Some "time(1) b") (choice, three);
  check "rest" ("<time(1)>true", Some "time(1)") (rest, dead);
  check "rest for longer than 3" ("<time(4)>true", Some "time(4)") (rest, dead_later);
  check "the other way round" ("[time(4)]false", Some "time(4) !") (dead_later, rest)

(* {1 Random graphs} *)

(* Durations are multiples of 1/2. *)
let graph_gen ~deterministic =
  let open QCheck2.Gen in
  let* size = int_range 1 5 in
  let state = int_range 0 (size - 1) in
  let* actions = list_size (int_range 0 size) (triple state (oneofl [ "a"; "b"; "tau" ]) state) in
  let halves n = Label.of_passing (For Scc_exact.Rat.(div (of_int n) (of_int 2))) in
  let passing = frequency [ (5, map halves (int_range 1 4)); (1, return "time(forever)") ] in
  let+ times = list_size (int_range 0 size) (triple state passing state) in
  let times = List.map (fun (s, l, t) -> if l = "time(forever)" then (s, l, s) else (s, l, t)) times in
  let first_only =
    List.fold_left
      (fun acc (s, l, t) -> if List.exists (fun (s', _, _) -> s = s') acc then acc else (s, l, t) :: acc)
      [] times
  in
  (size, actions @ if deterministic then first_only else times)

let print (size, edges) =
  Printf.sprintf "%d states: %s" size
    (String.concat " " (List.map (fun (s, l, t) -> Printf.sprintf "%d-%s->%d" s l t) edges))

(* An edge of time cut in two, at a new state. *)
let cut which (size, edges) =
  let is_finite l = match Label.passing l with Some (For _) -> true | _ -> false in
  let n = List.length (List.filter (fun (_, l, _) -> is_finite l) edges) in
  if n = 0 then (size, edges)
  else
    let index = ref (-1) in
    let half l =
      match Label.passing l with
      | Some (For d) -> Label.of_passing (For (Scc_exact.Rat.div d (Scc_exact.Rat.of_int 2)))
      | _ -> l
    in
    ( size + 1,
      List.concat_map
        (fun (s, l, t) ->
           if is_finite l then incr index;
           if is_finite l && !index = which mod n then [ (s, half l, size); (size, half l, t) ] else [ (s, l, t) ])
        edges )

let make (size, edges) = Naive.make size edges

let refinement deterministic name =
  QCheck2.Test.make ~name ~count:1000
    ~print:(fun (g, _, _) -> print g)
    QCheck2.Gen.(triple (graph_gen ~deterministic) small_nat small_nat)
    (fun (g, i, j) -> verdict Timed (make g) (make (cut i (cut j g))) = "equivalent")

(* Against strong bisimilarity of steps of 1/4: half of the shortest duration, since a place on the way must be
   told from its ends. *)
let definition deterministic name =
  let open QCheck2.Gen in
  let gen =
    let* g = graph_gen ~deterministic in
    let* other = graph_gen ~deterministic in
    let* how = int_range 0 3 in
    let+ which = small_nat in
    match how with
    | 0 -> (g, other)
    | 1 -> (g, cut which g)
    | 2 -> (g, (fst g, match snd g with _ :: rest -> rest | [] -> []))
    | _ ->
      let longer (s, l, t) = if l = "time(1)" then (s, "time(3/2)", t) else (s, l, t) in
      (g, (fst g, List.map longer (snd g)))
  in
  QCheck2.Test.make ~name ~count:750
    ~print:(fun (g, h) -> print g ^ "\n" ^ print h)
    gen
    (fun (g, h) ->
       let g = make g and h = make h in
       let steps = Naive.time_steps ~unit_:4 in
       let expected = Naive.related Strong (steps g) (steps h) in
       verdict Timed g h = if expected then "equivalent" else "different")

(* What is said of the known part holds of the whole. *)
let truncated deterministic name =
  let open QCheck2.Gen in
  let gen =
    let* g = graph_gen ~deterministic in
    let* h = graph_gen ~deterministic in
    let* how = bool in
    let h = if how then cut 0 g else h in
    let* i = int_range 0 (fst g - 1) in
    let+ j = int_range 0 (fst h - 1) in
    ((g, i), (h, j))
  in
  let known ((size, edges), unknown) =
    Naive.make ~unknown:[ unknown ] size (List.filter (fun (s, _, _) -> s <> unknown) edges)
  in
  QCheck2.Test.make ~name ~count:1000
    ~print:(fun ((g, i), (h, j)) -> Printf.sprintf "%s cut at %d\n%s cut at %d" (print g) i (print h) j)
    gen
    (fun (g, h) ->
       let steps x = Naive.time_steps ~unit_:4 (make (fst x)) in
       let same = Naive.related Strong (steps g) (steps h) in
       match verdict Timed (known g) (known h) with
       | "equivalent" -> same
       | "undecided" -> true
       | _ -> not same)

let suite =
  ("timed",
   [
     ("by hand", by_hand @ [ Alcotest.test_case "explanations" `Quick explanations ]);
     ( "random",
       Scc_test_support.Property.cases
         [
           refinement true "a passing of time may be cut";
           refinement false "also where time passes in several ways";
           truncated true "nothing is claimed of what is not known";
           truncated false "nor where time passes in several ways";
           definition true "agrees with steps of a unit";
           definition false "agrees with steps of a unit where time passes in several ways";
         ] );
   ])
