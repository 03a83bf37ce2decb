(* Explorations that are kept, go on, or are worked on by several processes, against those of one process that
   does all at once: on small random graphs, told by all that a visitor hears. *)

open Scc_exact
open Scc_graph_search
open Scc_parallel
module Gen = QCheck2.Gen

open Toys

module Graph = Explore.Make (Toy)
module Journal = Journal.Make (Toy) (Exchange) (Graph)
module Compact = Compacted.Make (Toy)
module Compact_journal = Step_journal.Make (Toy) (Exchange) (Compact)
module Crew = Scc_parallel.Crew
module Crews = Crew.Make (Toy) (Graph)

(** {2 What is told of an exploration} *)

type case = {
  toy : toy;
  depth : int option;
  time : int option;
  states : int option;
  by_time : bool;
  keep_edges : bool;
  sees_edges : bool;
  reducing : bool;
}

let told ?expanding ?dies ?(first = 0) ?(stop = fun () -> None) case =
  let context = Toy.make ~reducing:case.reducing ?dies ~first case.toy in
  let heard = Buffer.create 256 in
  let say format = Printf.bprintf heard (format ^^ "\n") in
  let name g i = Toy.decode context (Graph.tuple g i) in
  let edge g (e : Graph.edge) =
    Printf.sprintf "%d@%s" (name g e.target) (Rat.to_string (Graph.duration g e))
  in
  let edges g list = String.concat " " (List.map (edge g) (Array.to_list list)) in
  let visitor =
    {
      Graph.blind with
      found = (fun g i tuple -> say "found %d: %d %d" i (Toy.decode context tuple) (Graph.depth g i));
      opened = (if case.sees_edges then Some (fun g i _ list -> say "opened %d: %s" i (edges g list)) else None);
      earlier = (fun g i -> say "earlier %d %s" i (Rat.to_string (Graph.arrival g i)));
    }
  in
  let order = if case.by_time then Graph.By_time else By_steps in
  let limits =
    { Limits.unlimited with depth = case.depth; time = Option.map Rat.of_int case.time; states = case.states }
  in
  let g =
    Graph.run ~visitor ~order ~keep_edges:case.keep_edges ?expanding limits { Limits.quiet with stop } context
  in
  let status = function Explore.Expanded -> "expanded" | Queued -> "queued" | Unexpanded _ -> "left" in
  say "%d transitions" (Graph.transitions g);
  for i = 0 to Graph.size g - 1 do
    say "%d: %d %s %d %s: %s" i (name g i) (status (Graph.status g i)) (Graph.depth g i)
      (Rat.to_string (Graph.arrival g i))
      (edges g (Graph.edges g i));
    (* Also where it has been noted that there are none. *)
    let numbered = List.mapi (fun k e -> (k, e)) (Array.to_list (Graph.edges g i)) in
    let at_once (k, (e : Graph.edge)) = if Rat.sign (Graph.duration g e) = 0 then Some (k, e.target) else None in
    let at_once = List.filter_map at_once numbered in
    if at_once <> Graph.edges_at_once g i then QCheck2.Test.fail_reportf "edges at once of %d" i
  done;
  Buffer.contents heard

let case_gen =
  let open Gen in
  let* n = int_range 1 12 in
  let edge = pair (int_range 0 (n - 1)) (int_range 0 5) in
  let node = frequency [ (12, map Option.some (list_size (int_range 0 3) edge)); (1, return None) ] in
  let* toy = array_repeat n node in
  let* depth = opt ~ratio:0.3 (int_range 0 8) in
  let* time = opt ~ratio:0.3 (int_range 0 20) in
  let* states = opt ~ratio:0.2 (int_range 1 10) in
  let* by_time = bool in
  let* keep_edges = bool in
  let* sees_edges = bool in
  let+ reducing = bool in
  { toy; depth; time; states; by_time; keep_edges; sees_edges; reducing }

let print case =
  let node = function
    | None -> "fault"
    | Some l -> String.concat " " (List.map (fun (t, d) -> Printf.sprintf "%d@%d" t d) l)
  in
  let bound = function None -> "-" | Some n -> string_of_int n in
  Printf.sprintf "depth %s time %s states %s by time %b edges %b seen %b reducing %b\n%s" (bound case.depth)
    (bound case.time) (bound case.states) case.by_time case.keep_edges case.sees_edges case.reducing
    (String.concat "\n" (Array.to_list (Array.mapi (fun i x -> Printf.sprintf "%d: %s" i (node x)) case.toy)))

let same case text expected =
  String.equal text expected
  || QCheck2.Test.fail_reportf "%s\n\n%s\n\ninstead of\n\n%s" (print case) text expected

(** {2 Edges that are not kept} *)

(* Also those of states of which some transitions are put off, in an exploration that goes on from its notes. *)
let remade case =
  let expected = told { case with keep_edges = true } in
  let anew = { case with keep_edges = false } in
  let log, kept = Kept_in_memory.log [] in
  let journal log = Journal.expanding ~block:1 log Graph.here in
  same anew (told anew) expected
  && same anew (told ~expanding:(journal log) anew) expected
  && same anew (told ~expanding:(journal (fst (Kept_in_memory.log (kept ())))) anew) expected

let remade =
  QCheck2.Test.make ~count:2000 ~name:"edges that are made anew are those that are kept" ~print case_gen remade

(** {2 What is kept} *)

let kept_from blocks = Kept_in_memory.log blocks
let by_journal log = Journal.expanding ~block:1 log Graph.here

let rec prefixes = function [] -> [ [] ] | x :: rest -> [] :: List.map (fun p -> x :: p) (prefixes rest)

let follows case =
  let expected = told case in
  let log, kept = kept_from [] in
  ignore (same case (told ~expanding:(by_journal log) case) expected);
  let all = kept () in
  let goes_on blocks =
    let log, kept = kept_from blocks in
    same case (told ~expanding:(by_journal log) ~first:7 case) expected
    && (kept () = all || QCheck2.Test.fail_reportf "%s\n\nother notes" (print case))
  in
  List.for_all goes_on (prefixes all)

let kept =
  QCheck2.Test.make ~count:600 ~name:"from whatever was kept the exploration is the same" ~print case_gen follows

let in_pieces (case, pieces) =
  let expected = told case in
  let stopping n =
    let looks = ref 0 in
    fun () ->
      incr looks;
      if !looks > n then Some Limits.Interrupted else None
  in
  let rec go blocks = function
    | [] ->
      let log, _ = kept_from blocks in
      told ~expanding:(by_journal log) case
    | n :: rest ->
      let log, kept = kept_from blocks in
      ignore (told ~expanding:(by_journal log) ~first:n ~stop:(stopping n) case);
      go (kept ()) rest
  in
  same case (go [] pieces) expected

let pieces =
  QCheck2.Test.make ~count:1200 ~name:"stopped and resumed, it is the same"
    ~print:(fun (c, _) -> print c)
    Gen.(pair case_gen (list_size (int_range 1 4) (int_range 0 12)))
    in_pieces

(* With hash compaction. *)
let compacted ?expanding ?(first = 0) ?(stop = fun () -> None) case =
  let context = Toy.make ~first case.toy in
  let heard = Buffer.create 256 in
  let say format = Printf.bprintf heard (format ^^ "\n") in
  let step (s : Lts.step) tuple =
    let target = Toy.decode context (Tuples.apply s.changes tuple) in
    Printf.sprintf "%d@%s" target (Rat.to_string (Toy.duration context s.label))
  in
  let opened i tuple steps = say "opened %d: %s" i (String.concat " " (List.map (fun s -> step s tuple) steps)) in
  let visitor =
    {
      Compact.opened;
      found = (fun i tuple -> say "found %d: %d" i (Toy.decode context tuple));
      enough = (fun () -> false);
    }
  in
  let limits = { Limits.unlimited with depth = case.depth; states = case.states } in
  let family = Exchange.family context and around = { Limits.quiet with stop } in
  let r = Compact.run ?expanding visitor ~capacity:100 ~family limits around context in
  say "%d states, %d transitions, depth %d, %d left, omission %h" r.size r.transitions r.depth (List.length r.left)
    r.omission;
  List.iter (fun i -> say "%s" (String.concat " " (List.map string_of_int (r.path i)))) (List.init r.size Fun.id);
  Buffer.contents heard

let compacted_follows case =
  let expected = compacted case in
  let by log = Compact_journal.expanding ~block:1 log in
  let log, kept = kept_from [] in
  ignore (same case (compacted ~expanding:(by log) case) expected);
  let all = kept () in
  let goes_on blocks =
    let log, kept = kept_from blocks in
    same case (compacted ~expanding:(by log) ~first:7 case) expected
    && (kept () = all || QCheck2.Test.fail_reportf "%s\n\nother notes" (print case))
  in
  List.for_all goes_on (prefixes all)

let compacted_kept =
  QCheck2.Test.make ~count:600 ~name:"the same with hash compaction" ~print case_gen compacted_follows

let compacted_unfit () =
  let case =
    {
      toy = [| Some [ (1, 0); (2, 0) ]; Some [ (2, 1) ]; Some [ (0, 1) ] |];
      depth = None; time = None; states = None; by_time = false; keep_edges = true; sees_edges = false;
      reducing = false;
    }
  in
  let log, kept = kept_from [] in
  ignore (compacted ~expanding:(Compact_journal.expanding ~block:1 log) case);
  let refuses what blocks =
    let log, _ = kept_from blocks in
    match compacted ~expanding:(Compact_journal.expanding ~block:1 log) case with
    | _ -> Alcotest.failf "%s: it was taken" what
    | exception Scc_parallel.Journal.Unfit _ -> ()
  in
  let all = kept () in
  let later block = "\001" ^ String.sub block 1 (String.length block - 1) in
  refuses "a note of a later state comes first" (List.map later all);
  refuses "a note that ends too early" [ String.sub (List.hd all) 0 2 ]

let unfit () =
  let case =
    {
      toy = [| Some [ (1, 0); (2, 0) ]; Some [ (2, 1) ]; Some [ (0, 1) ] |];
      depth = None; time = None; states = None; by_time = false; keep_edges = true; sees_edges = false;
      reducing = false;
    }
  in
  let log, kept = kept_from [] in
  ignore (told ~expanding:(by_journal log) case);
  let refuses what blocks case =
    let log, _ = kept_from blocks in
    match told ~expanding:(by_journal log) case with
    | _ -> Alcotest.failf "%s: it was taken" what
    | exception Scc_parallel.Journal.Unfit _ -> ()
  in
  let all = kept () in
  refuses "other questions" all { case with keep_edges = false };
  refuses "the first note is missing" (List.tl all) case;
  refuses "a note that ends too early" [ String.sub (List.hd all) 0 2 ] case

(** {2 Several processes} *)

let by_crew jobs = Crews.expanding ~jobs ~start:Crew.At_once

let together case = same case (told ~expanding:(by_crew 2) case) (told case)

let crews =
  QCheck2.Test.make ~count:120 ~name:"two processes find what one finds" ~print case_gen together

let crew_and_journal case =
  let expected = told case in
  let log, kept = kept_from [] in
  let run log = told ~expanding:(Journal.expanding ~block:1 log (by_crew 3)) case in
  ignore (same case (run log) expected);
  let some = List.filteri (fun i _ -> i < 2) (kept ()) in
  same case (run (fst (kept_from some))) expected

let both =
  QCheck2.Test.make ~count:60 ~name:"also while it is kept" ~print case_gen crew_and_journal

(* A process dies wherever it comes to such a state; in the end nobody is left but this one. *)
let mortal (case, k) =
  let dies s = s mod k = 0 in
  same case (told ~dies ~expanding:(by_crew 2) case) (told case)

let deaths =
  QCheck2.Test.make ~count:40 ~name:"processes that die lose nothing"
    ~print:(fun (c, _) -> print c)
    Gen.(pair case_gen (int_range 1 4))
    mortal

let zigzags =
  let n = 4000 in
  let edges i = [ (((i * 7) + 1) mod n, 1); (((i * 3) + 2) mod n, 0); ((i + 1) mod n, 2) ] in
  let toy = Array.init n (fun i -> Some (edges i)) in
  let case (by_time, reducing, all) =
    { toy; depth = None; time = None; states = None; by_time; keep_edges = all; sees_edges = all; reducing }
  in
  let same what case by = Alcotest.(check bool) what true (String.equal (told case) (told ~expanding:by case)) in
  fun () ->
    List.iter
      (fun kind ->
         let case = case kind in
         List.iter (fun jobs -> same "by processes" case (by_crew jobs)) [ 2; 5 ];
         let log, kept = kept_from [] and alone, kept_alone = kept_from [] in
         same "and kept" case (Journal.expanding ~block:1 log (by_crew 3));
         same "kept by one" case (Journal.expanding ~block:1 alone Graph.here);
         Alcotest.(check (list string)) "the same notes" (kept_alone ()) (kept ()))
      [ (false, false, true); (true, false, true); (false, true, true); (false, false, false) ]

(* After quick states come slow ones with many targets, and a bound on states ends the exploration among them. What
   is expanded, anywhere, is hardly more than one process expands, and nobody waits for what is not needed. *)
let slow_states () =
  let quick = 30 and many = 60 in
  let edges i =
    if i < quick then [ ((2 * i) + 1, 1); ((2 * i) + 2, 1) ]
    else if i < 100 then List.init many (fun k -> (100 + ((i - quick) * many) + k, 1))
    else []
  in
  let toy = Array.init (100 + (100 * many)) (fun i -> Some (edges i)) in
  let case =
    {
      toy; depth = None; time = None; states = Some 300;
      by_time = false; keep_edges = true; sees_edges = true; reducing = false;
    }
  in
  let count = Option.get (Scc_shared.Shared_memory.numbers 1) in
  let dies s =
    if s >= quick then begin
      ignore (Scc_shared.Shared_memory.add count 0 1);
      Unix.sleepf 0.1
    end;
    false
  in
  let measured expanding =
    Scc_shared.Shared_memory.write count 0 0;
    let start = Unix.gettimeofday () in
    let text = told ~dies ~expanding case in
    (text, Scc_shared.Shared_memory.read count 0, Unix.gettimeofday () -. start)
  in
  let alone, needed, seconds = measured Graph.here in
  Alcotest.(check int) "by one process" 4 needed;
  List.iter
    (fun jobs ->
       let text, begun, lasted = measured (by_crew jobs) in
       Alcotest.(check bool) "it is the same" true (String.equal alone text);
       if begun > needed + (2 * jobs) then Alcotest.failf "%d processes began %d slow states" jobs begun;
       if lasted > (2. *. seconds) +. 0.5 then Alcotest.failf "%d processes took %g seconds" jobs lasted)
    [ 2; 4 ]

let () =
  Alcotest.run "expand"
    [
      ("edges", Scc_test_support.Property.cases [ remade ]);
      ( "kept",
        Scc_test_support.Property.cases [ kept; pieces; compacted_kept ]
        @ [
          Alcotest.test_case "notes that do not fit" `Quick unfit;
          Alcotest.test_case "nor with hash compaction" `Quick compacted_unfit;
        ] );
      ( "several processes",
        Scc_test_support.Property.cases [ crews; both; deaths ]
        @ [
          Alcotest.test_case "a large graph" `Quick zigzags;
          Alcotest.test_case "slow states" `Quick slow_states;
        ] );
    ]
