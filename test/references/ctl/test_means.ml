(* Means against the naive ones, on random small graphs. *)

open Scc_ctl
open Scc_exact
open Scc_chance
open Scc_test_ctl
module Gen = QCheck2.Gen

type case = { graph : Small.t; f : Formula.t; g : Formula.t; side : Formula.side; numbers : (int * int) array; time
              : int }

let print c =
  Printf.sprintf "%s\nf = %s\ng = %s\n%s, at %d halves, %s" (Small.print c.graph) (Small.print_formula c.f)
    (Small.print_formula c.g)
    (match c.side with Least -> "least" | Greatest -> "greatest")
    c.time
    (String.concat " " (Array.to_list (Array.map (fun (a, b) -> Printf.sprintf "%d+%dt" a b) c.numbers)))

let gen ~unsure ~truncated =
  let open Gen in
  let* graph = Small.gen ~unsure ~truncated in
  let* f = Small.formula_gen graph.unit 0 and* g = Small.formula_gen graph.unit 1 in
  let* side = oneofl [ Formula.Least; Greatest ] in
  let* numbers = array_repeat (Array.length graph.nodes) (pair (int_range 0 9) (int_range 0 3)) in
  let* time = int_range 0 9 in
  return { graph; f; g; side; numbers; time }

let same (a : Answer.t) (b : Answer.t) =
  match (a, b) with
  | Exact x, Exact y -> Rat.equal x y
  | Infinite, Infinite -> true
  | (Exact _ | Infinite | Within _ | At_least _), _ -> false

let agrees naive what c =
  match (Expectation.find (Small.evaluator c.graph) c.side what, naive) with
  | Known { least; most }, (low, high) -> same least low && same most high
  | Unknown _, _ -> false

let time_until c = agrees (Naive_means.time_until (Naive.make c.graph) c.side c.g) (Time_until c.g) c

let changes_until c =
  agrees (Naive_means.changes_until (Naive.make c.graph) c.side c.f c.g) (Changes_until (c.f, c.g)) c

(* Where something lasts for ever, the naive one does not know for how long it has. *)
let number c s offset =
  let a, b = c.numbers.(s) in
  let slope = match c.graph.nodes.(s).flow with Ray _ -> 0 | No_flow | Lasts _ -> b in
  Rat.add (Rat.of_int a) (Rat.mul (Rat.of_int slope) offset)

let value_at c =
  let time = Rat.mul (Rat.div (Rat.of_int c.time) (Rat.of_int 2)) c.graph.unit in
  let below s offset = Ok (Rat.sub (number c s offset) (Rat.of_int 5)) in
  match
    ( Expectation.find (Small.evaluator c.graph) c.side (Value_at (below, time)),
      Naive_means.value_at (Naive.make c.graph) c.side (number c) c.time )
  with
  | Known { least = Exact x; most = Exact y }, Is (Exact z) ->
    Rat.equal x y && Rat.equal (Rat.add x (Rat.of_int 5)) z
  | Unknown { reason; unexplored }, Never_decided -> reason <> None || unexplored <> []
  | (Known _ | Unknown _), _ -> false

let law ?(unsure = false) ?(truncated = false) name f =
  Scc_test_support.Property.case (QCheck2.Test.make ~name ~count:1600 ~print (gen ~unsure ~truncated) f)

(* A flow that meets g at no rational instant: the time is enclosed. *)
let irrational () =
  let two = Rat.of_int 2 in
  let root = List.hd (Algebraic.roots (Polynomial.of_coefficients [ Rat.neg two; Rat.zero; Rat.one ]) ~low:Rat.zero
                        ~high:None) in
  let graph : Timed_graph.t =
    {
      size = 2;
      known = (fun _ -> true);
      edges = (fun _ -> [||]);
      drawn = (fun _ -> None);
      flow = (fun s -> if s = 0 then Lasts (two, [| 1 |]) else Forever);
    }
  in
  let along _ s extent =
    if s > 0 then Timeline.constant extent Truth.False
    else
      Timeline.refine
        ~roots:(fun () -> [ root ])
        ~at:(fun r () -> Truth.of_bool (Algebraic.compare r root >= 0))
        ~inside:(fun r () -> Truth.of_bool (Algebraic.compare_rat root r < 0))
        (Timeline.constant extent ())
  in
  let predicates = { Eval.at = (fun _ _ -> Truth.False); along; steady = (fun _ -> false) } in
  let e = Eval.create (Timed_graph.index graph) predicates in
  match Expectation.find e Greatest (Time_until (Predicate 0)) with
  | Known { least = Exact x; most = Exact y } ->
    let below = Algebraic.compare_rat root x > 0 and above = Algebraic.compare_rat root y < 0 in
    Alcotest.(check bool) "around the root" true (below && above);
    let narrow = Rat.compare (Rat.sub y x) (Rat.make Z.one (Z.of_int 1_000_000)) < 0 in
    Alcotest.(check bool) "narrow" true narrow
  | _ -> Alcotest.fail "no interval"

let suite =
  ("means",
   [
     ( "random graphs",
       [
         law "the time until something" time_until;
         law "how often something happens" changes_until;
         law "a number at a time" value_at;
         law ~unsure:true ~truncated:true "times on truncated graphs" time_until;
         law ~unsure:true ~truncated:true "counts on truncated graphs" changes_until;
         law ~truncated:true "numbers on truncated graphs" value_at;
       ] );
     ("by hand", [ Alcotest.test_case "an irrational instant" `Quick irrational ]);
   ])
