(* The explorer on small explicit graphs, against definitions worked out naively. *)

open Scc_exact
open Scc_graph_search
module Gen = QCheck2.Gen

(* A graph: for each state its transitions (target, duration) or a fault. *)
type toy = (int * int) list option array

module Toy = struct
  type context = toy
  type fault = string

  let width _ = 1
  let initial _ = [| 0 |]

  (* The label of a transition is its duration. *)
  let successors g s =
    match g.(s.(0)) with
    | Some l -> Ok (List.map (fun (target, d) -> { Lts.label = d; changes = [| 0; target |] }) l)
    | None -> Error "broken"

  let reduced _ _ = None
  let entered _ _ = ()
  let transitions _ _ = 1
  let duration _ d = Rat.of_int d

  (* The number of a state is as long as it says. *)
  let longest = Array.length
  let bits _ s = s.(0)

  include Lts.Alone
end

module Graph = Explore.Make (Toy)

let none = Limits.unlimited

let explore ?visitor ?order ?keep_edges ?(limits = none) ?(around = Limits.quiet) g =
  Graph.run ?visitor ?order ?keep_edges limits around g

let state g i = (Graph.tuple g i).(0)
let find g s = List.find_opt (fun i -> state g i = s) (List.init (Graph.size g) Fun.id)

(** {2 Random graphs against a fixed point} *)

(* A state is expanded iff its labels over the edges of expanded states are within the bounds: adding
   states until nothing changes gives the least such set. *)
let naive ~depth ~time (g : toy) =
  let n = Array.length g in
  let expanded = Array.make n false in
  let labels () =
    let best = Array.make n None in
    best.(0) <- Some (0, 0);
    for _ = 0 to n do
      Array.iteri
        (fun s edges ->
           match (best.(s), edges) with
           | Some (d, t), Some list when expanded.(s) ->
             List.iter
               (fun (target, w) ->
                  let nd, nt = match best.(target) with Some x -> x | None -> (max_int, max_int) in
                  best.(target) <- Some (Int.min nd (d + 1), Int.min nt (t + w)))
               list
           | _ -> ())
        g
    done;
    best
  in
  let rec grow () =
    let best = labels () in
    let changed = ref false in
    Array.iteri
      (fun s label ->
         match label with
         | Some (d, t) when (not expanded.(s)) && d <= depth && t <= time && Option.is_some g.(s) ->
           expanded.(s) <- true;
           changed := true
         | _ -> ())
      best;
    if !changed then grow () else best
  in
  let best = grow () in
  (best, expanded)

let dense_gen =
  let open Gen in
  let* n = int_range 1 9 in
  let edge = pair (int_range 0 (n - 1)) (int_range 0 5) in
  let node = frequency [ (12, map Option.some (list_size (int_range 0 3) edge)); (1, return None) ] in
  array_repeat n node

(* Long lines, with long ways round to their beginnings: better labels come late and go far. *)
let lines_gen =
  let open Gen in
  let* n = int_range 8 20 in
  let node i =
    let next = pair (return (Int.min (i + 1) (n - 1))) (int_range 0 9) in
    let jump = pair (int_range 0 (n - 1)) (int_range 0 40) in
    map2 (fun a l -> Some (a :: l)) next (frequency [ (3, return []); (1, map (fun j -> [ j ]) jump) ])
  in
  let start = list_size (int_range 2 3) (pair (int_range 1 (n - 1)) (int_range 0 30)) in
  let rest = flatten_l (List.init (n - 1) (fun i -> node (i + 1))) in
  map2 (fun l rest -> Array.of_list (Some l :: rest)) start rest

let graph_gen = Gen.oneof [ dense_gen; lines_gen ]

let case_gen =
  Gen.triple graph_gen (Gen.opt (Gen.int_range 0 12)) (Gen.opt (Gen.int_range 0 40))

let print (g, depth, time) =
  let node = function
    | None -> "fault"
    | Some l -> String.concat " " (List.map (fun (t, d) -> Printf.sprintf "%d@%d" t d) l)
  in
  let bound = function None -> "-" | Some n -> string_of_int n in
  Printf.sprintf "depth %s time %s\n%s" (bound depth) (bound time)
    (String.concat "\n" (Array.to_list (Array.mapi (fun i x -> Printf.sprintf "%d: %s" i (node x)) g)))

let path_totals g path =
  List.fold_left
    (fun (n, t) (s : Graph.step) ->
       (n + 1, Rat.add t (Graph.duration g (Graph.edges g s.source).(s.choice))))
    (0, Rat.zero) path

(* The order decides which depths are seen first; without a bound on them, both find the same times. *)
let agrees ?order ~keep_edges (toy, depth, time) =
  let limits = { none with Limits.depth; time = Option.map Rat.of_int time } in
  let g = explore ?order ~keep_edges ~limits toy in
  let big = Option.value ~default:max_int in
  let best, expanded = naive ~depth:(big depth) ~time:(big time) toy in
  let state_agrees s =
    match (best.(s), find g s) with
    | None, None -> true
    | Some (d, t), Some i ->
      let is_expanded = match Graph.status g i with Explore.Expanded -> true | _ -> false in
      let edges = match toy.(s) with Some l when is_expanded -> l | _ -> [] in
      Graph.depth g i = d
      && Rat.equal (Graph.arrival g i) (Rat.of_int t)
      && Bool.equal is_expanded expanded.(s)
      && fst (path_totals g (Graph.shortest_path g i)) = d
      && Rat.equal (snd (path_totals g (Graph.earliest_path g i))) (Rat.of_int t)
      && edges
         = List.map (fun (e : Graph.edge) -> (state g e.target, e.label)) (Array.to_list (Graph.edges g i))
    | None, Some _ | Some _, None -> false
  in
  List.for_all state_agrees (List.init (Array.length toy) (fun s -> s))

let random =
  QCheck2.Test.make ~count:5000 ~name:"labels and bounds are those of the definition" ~print case_gen
    (agrees ~keep_edges:true)

let random_anew =
  QCheck2.Test.make ~count:5000 ~name:"also when edges are made anew" ~print case_gen (agrees ~keep_edges:false)

let random_by_time =
  QCheck2.Test.make ~count:5000 ~name:"also in the order of time" ~print case_gen
    (agrees ~order:By_time ~keep_edges:true)

let random_by_time_anew =
  QCheck2.Test.make ~count:5000 ~name:"in the order of time, and made anew" ~print case_gen
    (agrees ~order:By_time ~keep_edges:false)

(* In the order of time, states are opened in the order of their earliest arrivals. *)
let in_order (toy, _, time) =
  let last = ref Rat.zero in
  let opened g i _ _ =
    assert (Rat.compare !last (Graph.arrival g i) <= 0);
    last := Graph.arrival g i
  in
  let limits = { none with Limits.time = Option.map Rat.of_int time } in
  ignore (explore ~visitor:{ Graph.blind with opened = Some opened } ~order:By_time ~limits toy);
  true

let ordered = QCheck2.Test.make ~count:2000 ~name:"the order of time" ~print case_gen in_order

(* Each cycle without duration leads through a state where one is suspected. *)
let turns (toy, _, _) =
  let g = explore toy in
  let n = Graph.size g in
  let reach = Array.make_matrix n n false in
  let instant i = List.filter (fun (e : Graph.edge) -> e.label = 0) (Array.to_list (Graph.edges g i)) in
  for i = 0 to n - 1 do List.iter (fun (e : Graph.edge) -> reach.(i).(e.target) <- true) (instant i) done;
  for k = 0 to n - 1 do
    for i = 0 to n - 1 do
      for j = 0 to n - 1 do
        if reach.(i).(k) && reach.(k).(j) then reach.(i).(j) <- true
      done
    done
  done;
  let is_suspected i =
    match Graph.turning g with
    | Anywhere -> true
    | At targets ->
      let through k =
        let t = Scc_data.Int_vector.get targets k in
        reach.(i).(t) && reach.(t).(i)
      in
      List.exists through (List.init (Scc_data.Int_vector.length targets) Fun.id)
  in
  List.for_all (fun i -> is_suspected i || not reach.(i).(i)) (List.init n Fun.id)

let turning = QCheck2.Test.make ~count:2000 ~name:"cycles without duration are suspected" ~print case_gen turns

(* What the visitor is told is true when it is told, and enough to follow the labels. *)
let visited (toy, depth, time) =
  let limits = { none with Limits.depth; time = Option.map Rat.of_int time } in
  let arrivals = Hashtbl.create 8 and opened_states = Hashtbl.create 8 in
  let found g i tuple =
    assert (tuple = Graph.tuple g i);
    Hashtbl.add arrivals i (Graph.arrival g i)
  in
  let earlier g i =
    assert (Rat.compare (Graph.arrival g i) (Hashtbl.find arrivals i) < 0);
    Hashtbl.replace arrivals i (Graph.arrival g i)
  in
  let opened g i tuple edges =
    assert (not (Hashtbl.mem opened_states i));
    assert (tuple = Graph.tuple g i && edges = Graph.edges g i);
    Hashtbl.add opened_states i ();
    Array.iter (fun (e : Graph.edge) -> assert (Hashtbl.mem arrivals e.target)) edges
  in
  let g = explore ~visitor:{ Graph.blind with found; opened = Some opened; earlier } ~limits toy in
  List.for_all
    (fun i ->
       Rat.equal (Hashtbl.find arrivals i) (Graph.arrival g i)
       && Bool.equal (Hashtbl.mem opened_states i)
         (match Graph.status g i with Explore.Expanded -> true | _ -> false))
    (List.init (Graph.size g) (fun i -> i))

let events =
  QCheck2.Test.make ~count:2000 ~name:"the visitor hears of every state, edge and label" ~print case_gen visited

(* Hash compaction finds the same states at the same depths, on graphs so small that nothing collides. *)
module Compact = Compacted.Make (Toy)

let compacted (toy, depth, _) =
  let limits = { none with Limits.depth } in
  let found = Hashtbl.create 8 in
  let visitor =
    {
      Compact.found = (fun i tuple -> Hashtbl.add found tuple.(0) i);
      opened = (fun _ _ _ -> ());
      enough = (fun () -> false);
    }
  in
  let r = Compact.run visitor ~capacity:100 ~family:(fun _ -> 0) limits Limits.quiet toy in
  let g = explore ~limits toy in
  let follow s choice = match toy.(s) with Some l -> fst (List.nth l choice) | None -> -1 in
  r.size = Graph.size g
  && r.transitions = Graph.transitions g
  && r.depth = Graph.greatest_depth g
  && Hashtbl.fold
    (fun s i good ->
       let path = r.path i in
       good && List.fold_left follow 0 path = s
       && match find g s with Some j -> List.length path = Graph.depth g j | None -> false)
    found true

let hashed =
  QCheck2.Test.make ~count:3000 ~name:"hash compaction finds the same" ~print case_gen compacted

(** {2 Particular cases} *)

let reason = function
  | Explore.Depth -> "depth"
  | Time -> "time"
  | Instant -> "instant"
  | States -> "states"
  | Bits -> "bits"
  | Seconds -> "seconds"
  | Memory -> "memory"
  | Interrupted -> "interrupted"
  | Stopped -> "stopped"
  | Fault f -> "fault " ^ f

let left g = List.map (fun (i, r) -> (state g i, reason r)) (List.of_seq (Graph.unexpanded g))

(* What is counted as states are put off and expanded is what there is. *)
let check_left what expected g =
  let reasons = List.of_seq (Seq.map snd (Graph.unexpanded g)) in
  let count reason = List.length (List.filter (( = ) reason) reasons) in
  Alcotest.(check (list (pair int string))) what expected (left g);
  Alcotest.(check int) (what ^ ": count") (List.length expected) (Graph.left g);
  List.iter (fun r -> Alcotest.(check int) (what ^ ": " ^ reason r) (count r) (Graph.left_for g r))
    (Explore.[ Depth; Time; Instant; States; Bits; Seconds; Memory; Interrupted; Stopped ] @ reasons)

(* 0 reaches 3 at once but late, and by a longer way early enough. *)
let late_shortcut : toy =
  [| Some [ (3, 10); (1, 1) ]; Some [ (2, 1) ]; Some [ (3, 1) ]; Some [ (4, 1) ]; Some [] |]

let relaxation () =
  let g = explore ~limits:{ none with time = Some (Rat.of_int 5) } late_shortcut in
  check_left "all expanded" [] g;
  let i = Option.get (find g 4) in
  Alcotest.(check int) "least depth" 2 (Graph.depth g i);
  Alcotest.(check string) "earliest arrival" "4" (Rat.to_string (Graph.arrival g i));
  Alcotest.(check (list int)) "earliest path" [ 1; 0; 0; 0 ]
    (List.map (fun (s : Graph.step) -> s.choice) (Graph.earliest_path g i));
  Alcotest.(check (list int)) "shortest path" [ 0; 0 ]
    (List.map (fun (s : Graph.step) -> s.choice) (Graph.shortest_path g i))

let line n : toy = Array.init n (fun i -> if i = n - 1 then Some [] else Some [ (i + 1, 0) ])

let bounds () =
  let at limits = explore ~limits (line 10) in
  check_left "depth" [ (4, "depth") ] (at { none with depth = Some 3 });
  check_left "states" [ (3, "states") ] (at { none with states = Some 4 });
  check_left "just enough states" [] (at { none with states = Some 10 });
  check_left "instant" [ (6, "instant") ] (at { none with instant = Some 5 });
  check_left "long numbers" [ (7, "bits") ] (at { none with bits = Some 6 })

(* Stops at the third time that it is asked for something. *)
let third reason =
  let times = ref 0 in
  fun () ->
    incr times;
    if !times >= 3 then Some reason else None

let surroundings () =
  let around reason = { Limits.quiet with stop = third reason } in
  check_left "seconds" [ (2, "seconds") ] (explore ~around:(around Limits.Seconds) (line 10));
  check_left "memory" [ (2, "memory") ] (explore ~around:(around Limits.Memory) (line 10));
  check_left "interruption" [ (2, "interrupted") ] (explore ~around:(around Limits.Interrupted) (line 10));
  let stop = ref false in
  let opened _ i _ _ = if i = 4 then stop := true in
  let visitor = { Graph.blind with opened = Some opened; enough = (fun () -> !stop) } in
  check_left "visitor" [ (5, "stopped") ] (explore ~visitor (line 10))

(* The attempt of this number is given up before it does anything. *)
let given_up number =
  let times = ref 0 in
  let run _ f =
    incr times;
    if !times = number then Error Limits.Memory else Ok (f ())
  in
  { Limits.quiet with attempt = { run } }

(* Whatever is given up, what is left is a part of the whole, and its last state is not taken for expanded. The
   attempts of a line are: state 0 found; and then of each state its transitions, and the next one found. *)
let attempts () =
  check_left "at the first state" [ (0, "memory") ] (explore ~around:(given_up 1) (line 4));
  for state = 0 to 2 do
    let transitions = explore ~around:(given_up ((2 * state) + 2)) (line 4) in
    check_left "transitions" [ (state, "memory") ] transitions;
    Alcotest.(check int) "no edges" 0 (Array.length (Graph.edges transitions state));
    let path g = List.map (fun (s : Graph.step) -> s.choice) (Graph.shortest_path g (Graph.size g - 1)) in
    let found = explore ~around:(given_up ((2 * state) + 3)) (line 4) in
    check_left "what was found" [ (state, "memory"); (state + 1, "memory") ] found;
    Alcotest.(check (list int)) "the way there is known" (List.init (state + 1) (fun _ -> 0)) (path found)
  done;
  check_left "none" [] (explore ~around:(given_up 100) (line 4))

let faults () =
  check_left "fault" [ (1, "fault broken") ] (explore [| Some [ (1, 1); (2, 1) ]; None; Some [] |])

(* Depth must cost neither stack nor more than linear time. *)
let deep () =
  let n = 300_000 in
  let g = explore (line n) in
  Alcotest.(check int) "states" n (Graph.size g);
  Alcotest.(check int) "depth" (n - 1) (Graph.greatest_depth g);
  Alcotest.(check int) "path" (n - 1) (List.length (Graph.shortest_path g (n - 1)))

let () =
  let quick name f = Alcotest.test_case name `Quick f in
  Alcotest.run "explore"
    [
      ( "random graphs",
        Scc_test_support.Property.cases
          [ random; random_anew; random_by_time; random_by_time_anew; ordered; turning; events; hashed ] );
      ( "cases",
        [
          quick "a later path that is earlier in time" relaxation;
          quick "each bound leaves out what it should" bounds;
          quick "clock, interruption and visitor" surroundings;
          quick "attempts that are given up" attempts;
          quick "faults" faults;
          quick "a long line" deep;
        ] );
    ]
