(* Graphs in a few letters. *)

open Scc_ctl
open Scc_exact
open Timed_formula

(* The letters of p and of q: T, F as "." and undecided as "?". *)
let truths text =
  Array.init (String.length text) (fun i ->
      match text.[i] with 'T' -> Small.T | '.' -> F | '?' -> U | _ -> failwith "no truth value")

let node ?(edges = []) ?(drawn = false) ?(flow = Small.No_flow) ?(p = "") ?(q = "") ?(known = true) at : Small.node
  =
  { at = truths at; cells = [| truths p; truths q |]; edges; drawn; others = 0; flow; known }

let graph nodes : Small.t = { nodes = Array.of_list nodes; unit = Rat.one }
let p = Predicate 0
let q = Predicate 1
let bound ?high low = { Timed_formula.low = Rat.of_int low; high = Option.map Rat.of_int high }
let always = bound 0
let ef ?(b = always) f = Finally (Exists, b, f)
let af ?(b = always) f = Finally (All, b, f)
let eg ?(b = always) f = Globally (Exists, b, f)
let ag ?(b = always) f = Globally (All, b, f)
let eu ?(b = always) f g = Until (Exists, b, f, g)
let au ?(b = always) f g = Until (All, b, f, g)
let ex f = Next (Exists, f)
let ax f = Next (All, f)
let letter = function Some true -> "T" | Some false -> "." | None -> "?"

(* The truth at all nodes, and along a flow cell by cell. *)
let row g f =
  let e = Small.evaluator g in
  let node s = letter (Eval.truth e f (Positions.start s)) in
  String.concat "" (List.init (Array.length g.nodes) node)

let along g f s =
  let e = Small.evaluator g in
  let cell i = letter (Eval.truth e f { node = s; offset = Small.offset g i }) in
  String.concat "" (List.init (Small.cells g.nodes.(s)) cell)

(* {1 Those of the tables} *)

(* One flow of time 3 from node 0 to node 1, which is a dead end. *)
let one_flow p q = graph [ node ".." ~flow:(Lasts (3, [ 1 ])) ~p ~q; node ".." ]

let from_start p q at =
  let g = one_flow p q in
  { g with nodes = [| { (g.nodes.(0)) with at = truths at }; g.nodes.(1) |] }

(* 0 chooses between 1, which rests and gets p after 2, and 2, a loop of time 1. 3 leads to a dead end with p in
   no time, 4 is that one. 5 and 6 go round in no time, and 6 may leave to 4. 7 rests with p for ever, from the
   start on. *)
let runs =
  graph
    [
      node ".." ~edges:[ 1; 2 ];
      node ".." ~flow:(Ray 2) ~p:"...T." ~q:".....";
      node ".." ~flow:(Lasts (1, [ 2 ])) ~p:"." ~q:".";
      node ".." ~edges:[ 4 ];
      node "T.";
      node ".." ~edges:[ 6 ];
      node ".." ~edges:[ 5; 4 ];
      node "T." ~flow:(Ray 0) ~p:"T" ~q:".";
    ]

(* 0 and 1 go round in no time; 1 may also let time pass, to 2. Whether that matters depends on 2. *)
let zeno_then last =
  let first = node ".." ~edges:[ 1 ] in
  graph [ first; node ".." ~edges:[ 0 ] ~flow:(Lasts (1, [ 2 ])) ~p:"." ~q:"."; last ]

(* 0 lets 2 pass to 1 and then 1 more to 2, where p holds: at 3. The other way, 3 with p in (1, 2) of its flow
   of 4. *)
let line =
  graph
    [
      node ".." ~flow:(Lasts (2, [ 1 ])) ~p:"..." ~q:"...";
      node ".." ~flow:(Lasts (1, [ 2 ])) ~p:"." ~q:".";
      node "T.";
      node ".." ~flow:(Lasts (4, [ 2 ])) ~p:"..T...." ~q:".......";
      node ".." ~edges:[ 0; 3 ];
    ]

(* 0 has edges to 1, of which nothing is known, and to 2, which rests without p. 3 lets 5 pass to 1; 4 leads to
   1 only. *)
let truncated =
  graph
    [
      node ".." ~edges:[ 1; 2 ];
      node ".." ~known:false;
      node ".." ~flow:(Ray 0) ~p:"." ~q:".";
      node ".." ~flow:(Lasts (5, [ 1 ])) ~p:"........." ~q:".........";
      node ".." ~edges:[ 1 ];
    ]

