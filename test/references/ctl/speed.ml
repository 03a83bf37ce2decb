(* How long formulas take on a random graph: dune exec --profile release test/references/ctl/speed.exe -- NODES *)

open Scc_ctl
open Scc_exact
open Timed_formula

(* A linear congruential generator, the same everywhere. *)
let state = ref 1

let random n =
  state := ((!state * 25214903917) + 11) land ((1 lsl 48) - 1);
  (!state lsr 17) mod n

(* Three ways a node: two edges and a flow at most, as far as they exist. Most nodes lead to those near them. *)
let graph size : Timed_graph.t =
  let ways = Scc_data.Int_array.make (3 * size) (-1) in
  for s = 0 to size - 1 do
    let put k t = Scc_data.Int_array.set ways ((3 * s) + k) t in
    let target () = if random 10 = 0 then random size else Int.min (size - 1) (s + random 50) in
    for k = 0 to 1 do
      if random 3 > 0 then put k (target ())
    done;
    if random 2 = 0 then put 2 (target ())
  done;
  let way s k = Scc_data.Int_array.get ways ((3 * s) + k) in
  let times = Array.init 16 (fun k -> Rat.make (Z.of_int (k + 1)) (Z.of_int 7)) in
  let edges s =
    match (way s 0, way s 1) with
    | -1, -1 -> [||]
    | t, -1 | -1, t -> [| t |]
    | t, u -> [| t; u |]
  in
  let flow s =
    match way s 2 with
    | -1 -> if s land 63 = 0 then Timed_graph.Forever else No_flow
    | t -> Lasts (times.(s land 15), [| t |])
  in
  { size; known = (fun _ -> true); edges; drawn = (fun _ -> None); flow }

let predicates : Eval.predicates =
  let at p s = Truth.of_bool (s * 7919 land 1023 < if p = 0 then 1 else 900) in
  {
    at;
    along = (fun p s extent -> Timeline.constant extent (at p s));
    steady = (fun _ -> false);
  }

let timed name f =
  let before = Sys.time () in
  let result = f () in
  Printf.printf "%-28s %6.2f s\n%!" name (Sys.time () -. before);
  result

let words () =
  let s = Gc.quick_stat () in
  s.top_heap_words * 8 / 1_000_000

let () =
  let size = if Array.length Sys.argv > 1 then int_of_string Sys.argv.(1) else 1_000_000 in
  let graph = timed "graph" (fun () -> graph size) in
  let index = timed "edges backwards" (fun () -> Timed_graph.index graph) in
  let e = Eval.create index predicates in
  let p = Predicate 0 and q = Predicate 1 in
  let always = { Timed_formula.low = Rat.zero; high = None } in
  let within n = { always with high = Some (Rat.of_int n) } in
  let run f =
    let name = Timed_formula.to_string (fun p -> if p = 0 then "p" else "q") f in
    let v = timed name (fun () -> Eval.value e f) in
    let n = ref 0 in
    for s = 0 to size - 1 do
      if Positions.at v.lower s then incr n
    done;
    Printf.printf "  at %d nodes, perhaps: %b\n%!" !n (not (v.lower == v.upper))
  in
  List.iter run
    [
      p;
      q;
      Finally (Exists, always, p);
      Finally (All, always, p);
      Globally (Exists, always, q);
      Globally (All, always, Finally (Exists, always, p));
      Until (Exists, always, q, p);
      Next (Exists, p);
      Finally (Exists, within 3, p);
      Finally (All, within 3, q);
    ];
  Printf.printf "heap: %d MB\n" (words ());
  ignore
    (timed "explanation of EF p" (fun () ->
         Explanation.explain e (Finally (Exists, always, p)) (Positions.start 1)));
  ignore (timed "doubts" (fun () -> Doubts.find e (Finally (All, always, p)) (Positions.start 1)))
