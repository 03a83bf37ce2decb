(* Means against the naive ones, on random small graphs. *)

open Scc_ctl
open Scc_exact
open Scc_chance
open Scc_test_ctl
module Gen = QCheck2.Gen

type case = {
  graph : Small.t;
  g : Timed_formula.t;
  side : Timed_formula.side;
  counts : (int * int) array array;  (** of each edge of each node, how often what is counted happens by it *)
  numbers : (int * int) array;
  time : int;
}

let print c =
  let pairs text row = String.concat " " (Array.to_list (Array.map (fun (a, b) -> text a b) row)) in
  Printf.sprintf "%s\ng = %s\n%s, at %d halves, %s, counts %s" (Small.print c.graph) (Small.print_formula c.g)
    (match c.side with Least -> "least" | Greatest -> "greatest")
    c.time
    (pairs (Printf.sprintf "%d+%dt") c.numbers)
    (String.concat "; " (Array.to_list (Array.map (pairs (Printf.sprintf "%d-%d")) c.counts)))

(* Mostly decided, and some of several things that happen at once. *)
let count_gen ~unsure =
  let open Gen in
  let* least = frequency [ (3, return 0); (3, return 1); (1, int_range 2 3) ] in
  let* more = if unsure then frequency [ (3, return 0); (1, int_range 1 2) ] else return 0 in
  return (least, least + more)

let gen ~unsure ~truncated =
  let open Gen in
  let* graph = Small.gen ~unsure ~truncated in
  let* g = Small.formula_gen graph.unit 1 in
  let of_node (x : Small.node) = array_repeat (List.length x.edges) (count_gen ~unsure) in
  let* counts = flatten_a (Array.map of_node graph.nodes) in
  let* side = oneofl [ Timed_formula.Least; Greatest ] in
  let* numbers = array_repeat (Array.length graph.nodes) (pair (int_range 0 9) (int_range 0 3)) in
  let* time = int_range 0 9 in
  return { graph; g; side; counts; numbers; time }

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

let counts_until c =
  let count s k = c.counts.(s).(k) in
  agrees (Naive_means.counts_until (Naive.make c.graph) c.side count c.g) (Counts_until (count, c.g)) c

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

(* Intervals contain what rationals say, and short rationals are intervals or the same. *)
let enclosed c =
  let time = Rat.mul (Rat.div (Rat.of_int c.time) (Rat.of_int 2)) c.graph.unit in
  let third s offset = Ok (Rat.sub (Rat.div (number c s offset) (Rat.of_int 3)) Rat.one) in
  let found effort = Expectation.find (Small.evaluator ~effort c.graph) c.side (Value_at (third, time)) in
  let contains x effort =
    match found effort with Known { least; most } -> least = most && Answer.contains least x | Unknown _ -> false
  in
  match found { Effort.default with engine = Exactly } with
  | Known { least = Exact x; most = Exact y } ->
    Rat.equal x y
    && contains x { Effort.default with engine = Nearly }
    && contains x { Effort.default with bits = 8 }
  | Known _ -> false
  | Unknown _ -> true

let law ?(unsure = false) ?(truncated = false) name f =
  Scc_test_support.Property.case (QCheck2.Test.make ~name ~count:800 ~print (gen ~unsure ~truncated) f)

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
         law "how often something happens" counts_until;
         law "a number at a time" value_at;
         law "a number at a time in intervals" enclosed;
         law ~unsure:true ~truncated:true "times on truncated graphs" time_until;
         law ~unsure:true ~truncated:true "counts on truncated graphs" counts_until;
         law ~truncated:true "numbers on truncated graphs" value_at;
       ] );
     ("by hand", [ Alcotest.test_case "an irrational instant" `Quick irrational ]);
   ])
