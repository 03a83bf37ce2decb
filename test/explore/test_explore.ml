(* The explorer on small explicit graphs, against definitions worked out naively. *)

open Scc_exact
open Scc_explore
module Gen = QCheck2.Gen

(* A graph: for each state its transitions (target, duration) or a fault. *)
type toy = (int * int) list option array

module Toy = struct
  type context = toy
  type state = int
  type transition = int * int
  type fault = string

  let initial _ = 0
  let successors g s = match g.(s) with Some l -> Ok l | None -> Error "broken"
  let target (t, _) = t
  let duration (_, d) = Rat.of_int d
  let equal = Int.equal

  (* Collisions among the states of small graphs. *)
  let hash s = if s < 16 then s mod 3 else s
end

module Graph = Explore.Make (Toy)

let none = Limits.unlimited
let explore ?visit ?(limits = none) ?(around = Limits.quiet) g = Graph.run ?visit limits around g

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
       (n + 1, Rat.add t (Toy.duration (Graph.edges g s.source).(s.choice).transition)))
    (0, Rat.zero) path

let agrees (toy, depth, time) =
  let limits = { none with Limits.depth; time = Option.map Rat.of_int time } in
  let g = explore ~limits toy in
  let big = Option.value ~default:max_int in
  let best, expanded = naive ~depth:(big depth) ~time:(big time) toy in
  let state_agrees s =
    match (best.(s), Graph.find g s) with
    | None, None -> true
    | Some (d, t), Some i ->
      let is_expanded = match Graph.status g i with Graph.Expanded -> true | _ -> false in
      Graph.depth g i = d
      && Rat.equal (Graph.arrival g i) (Rat.of_int t)
      && Bool.equal is_expanded expanded.(s)
      && fst (path_totals g (Graph.shortest_path g i)) = d
      && Rat.equal (snd (path_totals g (Graph.earliest_path g i))) (Rat.of_int t)
    | None, Some _ | Some _, None -> false
  in
  List.for_all state_agrees (List.init (Array.length toy) (fun s -> s))

let random =
  QCheck2.Test.make ~count:5000 ~name:"labels and bounds are those of the definition" ~print case_gen agrees

(* What the visitor is told is true when it is told, and enough to follow the labels. *)
let visited (toy, depth, time) =
  let limits = { none with Limits.depth; time = Option.map Rat.of_int time } in
  let arrivals = Hashtbl.create 8 and opened = Hashtbl.create 8 in
  let visit g (event : Graph.event) =
    (match event with
     | Found i -> Hashtbl.add arrivals i (Graph.arrival g i)
     | Earlier i ->
       assert (Rat.compare (Graph.arrival g i) (Hashtbl.find arrivals i) < 0);
       Hashtbl.replace arrivals i (Graph.arrival g i)
     | Opened i ->
       assert (not (Hashtbl.mem opened i));
       Hashtbl.add opened i ();
       Array.iter (fun (e : Graph.edge) -> assert (Hashtbl.mem arrivals e.target)) (Graph.edges g i));
    Graph.Continue
  in
  let g = explore ~visit ~limits toy in
  List.for_all
    (fun i ->
       Rat.equal (Hashtbl.find arrivals i) (Graph.arrival g i)
       && Bool.equal (Hashtbl.mem opened i)
         (match Graph.status g i with Graph.Expanded -> true | _ -> false))
    (List.init (Graph.size g) (fun i -> i))

let events =
  QCheck2.Test.make ~count:2000 ~name:"the visitor hears of every state, edge and label" ~print case_gen visited

(** {2 Particular cases} *)

let reason = function
  | Explore.Depth -> "depth"
  | Time -> "time"
  | Instant -> "instant"
  | States -> "states"
  | Seconds -> "seconds"
  | Memory -> "memory"
  | Interrupted -> "interrupted"
  | Stopped -> "stopped"
  | Fault f -> "fault " ^ f

let left g = List.map (fun (i, r) -> (Graph.state g i, reason r)) (Graph.unexpanded g)
let check_left what expected g = Alcotest.(check (list (pair int string))) what expected (left g)

(* 0 reaches 3 at once but late, and by a longer way early enough. *)
let late_shortcut : toy =
  [| Some [ (3, 10); (1, 1) ]; Some [ (2, 1) ]; Some [ (3, 1) ]; Some [ (4, 1) ]; Some [] |]

let relaxation () =
  let g = explore ~limits:{ none with time = Some (Rat.of_int 5) } late_shortcut in
  check_left "all expanded" [] g;
  let i = Option.get (Graph.find g 4) in
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
  check_left "memory" [ (0, "memory") ] (at { none with memory = Some 1 })

let surroundings () =
  let clock = ref 0. in
  let now () = clock := !clock +. 1.; !clock in
  let around = { Limits.quiet with now } in
  check_left "seconds" [ (3, "seconds") ]
    (explore ~limits:{ none with seconds = Some 3.5 } ~around (line 10));
  let polls = ref 0 in
  let interrupted () = incr polls; !polls > 3 in
  check_left "interruption" [ (3, "interrupted") ]
    (explore ~around:{ Limits.quiet with interrupted } (line 10));
  let visit _ (e : Graph.event) =
    match e with Graph.Opened 4 -> Graph.Stop | Found _ | Opened _ | Earlier _ -> Graph.Continue
  in
  check_left "visitor" [ (5, "stopped") ] (explore ~visit (line 10))

let faults () =
  check_left "fault" [ (1, "fault broken") ] (explore [| Some [ (1, 1); (2, 1) ]; None; Some [] |])

let replays () =
  let replay choices =
    match Graph.replay late_shortcut choices with
    | Ok l -> "ok " ^ String.concat "," (List.map (fun (t, _) -> string_of_int t) l)
    | Error (i, None) -> Printf.sprintf "no choice at %d" i
    | Error (i, Some f) -> Printf.sprintf "%s at %d" f i
  in
  Alcotest.(check string) "fits" "ok 1,2,3" (replay [ 1; 0; 0 ]);
  Alcotest.(check string) "too great" "no choice at 1" (replay [ 1; 1 ]);
  Alcotest.(check string) "negative" "no choice at 0" (replay [ -1 ]);
  Alcotest.(check string) "past the end" "no choice at 2" (replay [ 0; 0; 0 ])

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
      ("random graphs", Scc_test_support.Property.cases [ random; events ]);
      ( "cases",
        [
          quick "a later path that is earlier in time" relaxation;
          quick "each bound leaves out what it should" bounds;
          quick "clock, interruption and visitor" surroundings;
          quick "faults" faults;
          quick "replay" replays;
          quick "a long line" deep;
        ] );
    ]
