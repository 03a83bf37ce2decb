(* Draws of one instant as one transition: by hand; and at random, that it does not matter in which order they
   come. *)

open Scc_exact
open Scc_equivalence
module Gen = QCheck2.Gen

let graph ?(unknown = []) ~size edges =
  let b = Graph.builder () in
  List.iter (fun (source, label, target) -> Graph.add b ~source ~label:(Graph.intern b label) ~target) edges;
  Graph.finish b ~size ~initial:0 ~unknown:(fun s -> List.mem s unknown)

let edges (g : Graph.t) =
  let all = ref [] in
  for s = g.size - 1 downto 0 do
    Graph.iter g s (fun label target -> all := (s, g.labels.(label), target) :: !all)
  done;
  List.sort compare !all

let joined ?(hidden = []) ?(renamed = Label.canonical) g =
  let told label = let label = renamed label in if List.mem label hidden then Graph.tau else label in
  Draws.joined ~told g

let case name g ?hidden ?renamed ?(unknown = []) expected =
  Alcotest.test_case name `Quick (fun () ->
      let found = joined ?hidden ?renamed g in
      Alcotest.(check (list (triple int string int))) "transitions" (List.sort compare expected) (edges found);
      let known s = not (List.mem s unknown) in
      List.iter (fun s -> Alcotest.(check bool) "known" (known s) (Graph.known found s))
        (List.init found.size Fun.id))

let two =
  [
    (0, "release(b, q, p) chance(1/3)", 1); (0, "keep(b, p, q) chance(2/3)", 2);
    (1, "release(a, r, s) chance(1/2)", 3);
    (1, "keep(a, r, s) chance(1/2)", 4); (2, "release(a, r, s) chance(1/2)", 5);
    (2, "keep(a, r, s) chance(1/2)", 6);
    (3, "choose(b, p, q)", 7); (3, "choose(b, p, q)", 8); (7, "weak({<b, {q, p}>, <a, {s, r}>})", 9);
    (8, "weak({<b, {q, p}>, <a, {s, r}>})", 10); (4, "weak(b, p, q)", 10); (5, "weak(a, s, r)", 10);
    (6, "time(1)", 0);
  ]

let both = "weak({<a, {r, s}>, <b, {p, q}>})"

let by_hand =
  [
    case "two lots, and who chooses" (graph ~size:11 two)
      [
        (0, "{release(a, r, s), release(b, p, q)} chance(1/6)", 1);
        (0, "{keep(a, r, s), release(b, p, q)} chance(1/6)", 2);
        (0, "{keep(b, p, q), release(a, r, s)} chance(1/3)", 3);
        (0, "{keep(a, r, s), keep(b, p, q)} chance(1/3)", 4);
        (1, both, 5); (1, both, 6); (2, "weak(b, p, q)", 6); (3, "weak(a, r, s)", 6); (4, "time(1)", 0);
      ];
    case "one is hidden"
      ~hidden:[ "release(b, p, q) chance(1/3)"; "keep(b, p, q) chance(2/3)" ]
      (graph ~size:11 (List.filter (fun (s, _, _) -> s < 3) two))
      [
        (0, "release(a, r, s) chance(1/6)", 1); (0, "keep(a, r, s) chance(1/6)", 2);
        (0, "release(a, r, s) chance(1/3)", 3);
        (0, "keep(a, r, s) chance(1/3)", 4);
      ];
    case "all is hidden" ~hidden:[ "d(1) chance(1/2)"; "d(2) chance(1/2)" ]
      (graph ~size:3 [ (0, "d(1) chance(1/2)", 1); (0, "d(2) chance(1/2)", 2) ])
      [ (0, "tau", 1); (0, "tau", 2) ];
    case "a name without a chance"
      ~renamed:(fun l -> if String.length l > 4 && String.sub l 0 4 = "d(1)" then "one" else l)
      (graph ~size:5
         [
           (0, "d(1) chance(1/2)", 1); (0, "d(2) chance(1/2)", 2); (1, "e chance(1)", 3); (2, "e chance(1)", 4);
         ])
      [ (0, "{e, one}", 1); (0, "{d(2), e} chance(1/2)", 2) ];
    case "two ways to one state"
      (graph ~size:4
         [
           (0, "d(1) chance(1/2)", 1); (0, "d(1) chance(1/3)", 2); (0, "d(2) chance(1/6)", 3);
           (1, "e chance(1)", 3);
           (2, "e chance(1)", 3);
         ])
      [ (0, "d(2) chance(1/6)", 1); (0, "{d(1), e} chance(5/6)", 1) ];
    case "not known to the end" ~unknown:[ 0 ]
      (graph ~size:5 ~unknown:[ 2 ]
         [ (0, "d(1) chance(1/2)", 1); (0, "d(2) chance(1/2)", 2); (1, "e chance(1/2)", 3);
           (1, "f chance(1/2)", 4) ])
      [ (0, "{d(1), e} chance(1/4)", 1); (0, "{d(1), f} chance(1/4)", 2) ];
    case "round for ever"
      (graph ~size:3 [ (0, "d chance(1/2)", 1); (0, "e chance(1/2)", 2); (1, "d chance(1)", 0) ])
      [ (0, "d chance(1/2)", 1); (0, "e chance(1/2)", 2); (1, "d chance(1)", 0) ];
    case "some have no chance" (graph ~size:3 [ (0, "d chance(1/2)", 1); (0, "e", 2); (1, "d chance(1)", 2) ])
      [ (0, "d chance(1/2)", 1); (0, "e", 2); (1, "d chance(1)", 2) ];
    case "choices of others" (graph ~size:4 [ (0, "choose(x)", 1); (0, "choose(y)", 2); (1, "send", 3) ])
      [ (0, "choose(x)", 1); (0, "choose(y)", 2); (1, "send", 3) ];
  ]

(* {1 At random} *)

(* Of each draw the weights of what may come, and two orders of the draws. *)
type draws = { chances : int list list; order : int list; other : int list }

let gen =
  let open Gen in
  let* n = int_range 1 4 in
  let* chances = list_repeat n (list_size (int_range 1 3) (int_range 1 4)) in
  let shuffled = shuffle_l (List.init n Fun.id) in
  map2 (fun order other -> { chances; order; other }) shuffled shuffled

let print d =
  let ints l = String.concat " " (List.map string_of_int l) in
  Printf.sprintf "%s; in the orders %s and %s"
    (String.concat ", " (List.map ints d.chances))
    (ints d.order) (ints d.other)

(* A tree of draws in an order; after them a transition that tells what all have drawn. *)
let in_order d order =
  let all = ref [] and size = ref 1 in
  let next () = incr size; !size - 1 in
  let rec grow s drawn = function
    | [] -> all := (s, "got " ^ String.concat " " (List.sort String.compare drawn), next ()) :: !all
    | i :: rest ->
      let weights = List.nth d.chances i in
      let total = List.fold_left ( + ) 0 weights in
      List.iteri
        (fun k w ->
           let t = next () and text = Printf.sprintf "d(%d, %d)" i k in
           all := (s, Label.with_chance text (Rat.make (Z.of_int w) (Z.of_int total)), t) :: !all;
           grow t (text :: drawn) rest)
        weights
  in
  grow 0 [] order;
  graph ~size:!size !all

let orders =
  QCheck2.Test.make ~name:"the order of draws is not seen" ~count:100 ~print gen (fun d ->
      let prepared order = Compare.prepare Strong (joined (in_order d order)) in
      let effort = Effort.make ~stop:(fun () -> false) in
      match (Compare.run effort Strong (prepared d.order) (prepared d.other)).verdict with
      | Equivalent -> true
      | Different _ | Undecided _ -> false)

let suite = ("draws", [ ("by hand", by_hand); ("at random", Scc_test_support.Property.cases [ orders ]) ])
