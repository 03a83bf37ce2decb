(* Classic pairs, laws, and what is said about them. *)

open Scc_equivalence
open Scc_naive_equivalence

let run relation g h =
  Compare.run (Effort.unlimited ()) relation (Compare.prepare relation g) (Compare.prepare relation h)

let equivalent relation g h =
  match (run relation g h).verdict with
  | Compare.Equivalent -> true
  | Different _ -> false
  | Undecided _ -> Alcotest.fail "undecided"

let relations =
  [ ("strong", Compare.Strong); ("branching", Branching); ("weak", Weak); ("trace", Trace) ]

(* The finest relation that holds decides; none when even traces differ. *)
let pair name finest g h =
  Alcotest.test_case name `Quick (fun () ->
      let rec check holds = function
        | [] -> ()
        | (r, relation) :: rest ->
          let holds = holds || String.equal r finest in
          Alcotest.(check bool) r holds (equivalent relation g h);
          Alcotest.(check bool) (r ^ ", the other way") holds (equivalent relation h g);
          check holds rest
      in
      check false relations)

let make = Naive.make

(* a.(b + c), a.b + a.c and a.b + a.(b + c) *)
let late = make 4 [ (0, "a", 1); (1, "b", 2); (1, "c", 3) ]
let early = make 5 [ (0, "a", 1); (0, "a", 2); (1, "b", 3); (2, "c", 4) ]
let absorbed = make 4 [ (0, "a", 1); (0, "a", 2); (1, "b", 3); (2, "b", 3); (2, "c", 3) ]
let unrolled = make 3 [ (0, "a", 1); (1, "a", 2); (2, "a", 0) ]
let rolled = make 1 [ (0, "a", 0) ]

(* The laws of tau. *)
let a = make 2 [ (0, "a", 1) ]
let tau_a = make 3 [ (0, "tau", 1); (1, "a", 2) ]
let a_tau = make 3 [ (0, "a", 1); (1, "tau", 2) ]
let a_tau_b = make 4 [ (0, "a", 1); (1, "tau", 2); (2, "b", 3) ]
let a_b = make 3 [ (0, "a", 1); (1, "b", 2) ]

(* second law: p + tau.p = tau.p, with p = a + b *)
let second_left = make 4 [ (0, "tau", 1); (1, "a", 2); (1, "b", 3); (0, "a", 2); (0, "b", 3) ]
let second_left_part = make 4 [ (0, "tau", 1); (1, "a", 2); (1, "b", 3); (0, "a", 2) ]
let second_right = make 4 [ (0, "tau", 1); (1, "a", 2); (1, "b", 3) ]

(* third law: a.(b + tau.c) = a.(b + tau.c) + a.c, which branching bisimilarity does not have *)
let third_left = make 4 [ (0, "a", 1); (1, "b", 2); (1, "tau", 3); (3, "c", 2) ]
let third_right = make 5 [ (0, "a", 1); (1, "b", 2); (1, "tau", 3); (3, "c", 2); (0, "a", 4); (4, "c", 2) ]

(* a.b + a.c and tau.a.b + tau.a.c; an internal choice that is made, and one that is not *)
let inner = make 3 [ (0, "tau", 1); (0, "tau", 2); (1, "a", 2) ]
let outer = make 2 [ (0, "a", 1) ]
let diverging = make 2 [ (0, "tau", 0); (0, "a", 1) ]
let diverging_cycle = make 3 [ (0, "tau", 1); (1, "tau", 0); (1, "a", 2) ]

let pairs =
  [
    pair "a graph and itself" "strong" late late;
    pair "a.(b + c) and a.b + a.c" "trace" late early;
    pair "a.(b + c) and a.b + a.(b + c)" "trace" late absorbed;
    pair "a loop unrolled" "strong" unrolled rolled;
    pair "a and tau.a" "branching" a tau_a;
    pair "a and a.tau" "branching" a a_tau;
    pair "a.b and a.tau.b" "branching" a_b a_tau_b;
    pair "p + tau.p = tau.p" "branching" second_left second_right;
    pair "part of p will do" "branching" second_left_part second_right;
    pair "a.(b + tau.c) = a.(b + tau.c) + a.c" "weak" third_left third_right;
    pair "tau.a + tau and a" "trace" inner outer;
    pair "divergence is not looked at" "branching" diverging outer;
    pair "nor in a cycle" "branching" diverging_cycle diverging;
    pair "a and b" "none" a (make 2 [ (0, "b", 1) ]);
    pair "a and nothing" "none" a (make 1 []);
    pair "a and a.a" "none" a (make 3 [ (0, "a", 1); (1, "a", 2) ]);
  ]

(* {1 What is said} *)

let explanation relation g h =
  let report = run relation g h in
  match report.verdict with
  | Different d ->
    let formula = match d.formula with Some f -> report.show f | None -> "" in
    let trace =
      match d.trace with
      | Some (t, first) -> (if first then "first: " else "second: ") ^ String.concat " " t
      | None -> "none"
    in
    (formula, trace)
  | Equivalent | Undecided _ -> ("", "")

let says name relation g h expected =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check (pair string string)) name expected (explanation relation g h))

let explanations =
  [
    says "a.(b + c), strong" Strong late early ("[a]<b>true", "none");
    says "a.b + a.c, strong" Strong early late ("<a>[b]false", "none");
    says "a.(b + c), weak" Weak late early ("[[a]]<<c>>true", "none");
    says "a.(b + c), branching" Branching late early ("not (true until <a>not (true until <b>true))", "none");
    says "the third law, branching" Branching third_left third_right
      ("not (true until <a>not (true until <b>true))", "none");
    says "an inner choice" Weak inner outer ("<<tau>>[[a]]false", "none");
    says "an inner choice, branching" Branching inner outer ("(true until not (true until <a>true))", "none");
    says "a and a.a" Weak a (make 3 [ (0, "a", 1); (1, "a", 2) ]) ("[[a]][[a]]false", "second: a a");
    says "a.b and a" Trace a_tau_b a ("<<a>><<b>>true", "first: a b");
    says "silent steps are steps" Strong a_tau a ("[a]<tau>true", "first: a tau");
  ]

(* {1 Graphs not all of whose states are known} *)

let verdict relation g h =
  match (run relation g h).verdict with
  | Equivalent -> "equivalent"
  | Different _ -> "different"
  | Undecided Unknown_states -> "unknown states"
  | Undecided _ -> "undecided"

let known name relation g h expected =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check string) name expected (verdict relation g h);
      Alcotest.(check string) (name ^ ", the other way") expected (verdict relation h g))

let cut_after_a = make ~unknown:[ 1 ] 2 [ (0, "a", 1) ]
let cut_at_once = make ~unknown:[ 0 ] 1 []
let cut_elsewhere = make ~unknown:[ 2 ] 3 [ (0, "a", 1); (0, "c", 2) ]
let out_of_reach = make ~unknown:[ 2 ] 3 [ (0, "a", 1) ]

let truncated =
  List.concat_map
    (fun (name, relation) ->
       [
         known (name ^ ": never equivalent") relation cut_after_a cut_after_a "unknown states";
         known (name ^ ": beyond what is known") relation cut_after_a a_b "unknown states";
         known (name ^ ": nothing known") relation cut_at_once a "unknown states";
         known (name ^ ": for certain") relation cut_elsewhere a "different";
         known (name ^ ": what is not reached does not matter") relation out_of_reach a "equivalent";
       ])
    relations

(* {1 Effort} *)

let exhausted () =
  let chain n = make n (List.init (n - 1) (fun i -> (i, "a", i + 1))) in
  let g = chain 200_000 in
  let effort = Effort.make ~stop:(fun () -> true) in
  match (Compare.run effort Strong (Compare.prepare Strong g) (Compare.prepare Strong g)).verdict with
  | Undecided Effort_spent -> ()
  | _ -> Alcotest.fail "it was to stop"

(* Long paths take neither the stack nor quadratic time. *)
let long_chain relation label () =
  let n = 50_000 in
  let chain n = make n (List.init (n - 1) (fun i -> (i, label, i + 1))) in
  Alcotest.(check bool) "equivalent" true (equivalent relation (chain n) (chain n));
  Alcotest.(check bool) "different" (label = "tau") (equivalent relation (chain n) (chain (n - 1)))

let efforts =
  [
    Alcotest.test_case "a limit" `Quick exhausted;
    Alcotest.test_case "long chains, strong" `Quick (long_chain Strong "a");
    Alcotest.test_case "long chains, branching" `Quick (long_chain Branching "a");
    Alcotest.test_case "long chains, weak" `Quick (long_chain Weak "a");
    Alcotest.test_case "long silent chains, branching" `Quick (long_chain Branching "tau");
    Alcotest.test_case "long silent chains, weak" `Quick (long_chain Weak "tau");
  ]

(* Made of several, an until is printed as the one that it is. *)
let nested () =
  let open Modal_formula in
  let s = store () in
  let yes = yes s and tau = 0 and a = 1 in
  let prints expected f =
    Alcotest.(check string) expected expected (to_string ~label:(fun i -> if i = tau then "tau" else "a") f)
  in
  let step phi = until s phi a yes in
  let not_a = negation s (step yes) in
  prints "(true until <a>true)" (until s yes tau (until s yes tau (step yes)));
  prints "true" (until s (step yes) tau yes);
  prints "(not (true until <a>true) until <a>true)" (until s not_a tau (step not_a));
  prints "(true until (not (true until <a>true) until <a>true))" (until s yes tau (step not_a))

let suite =
  ("relations",
   [
     ("formulas", [ Alcotest.test_case "an until of untils" `Quick nested ]);
     ("pairs", pairs);
     ("explanations", explanations);
     ("unknown states", truncated);
     ("effort", efforts);
   ])
