(* A run keeps only what is still open: its answers are those of the whole run, and its cost does not grow with the
   network and the length of the run together. *)

open Scc_estimate
open Scc_test_support
open Scc_test_models

let walkers ~half ~bodies =
  Printf.sprintf
    "timestep 1 steady\nsplit_step 1\nblocked wait\ncollisions drawn\nimport <solids>\n\
     fixed room = solids.Room(%d, 8, 1, 1)\n\
     behaviour A = <a, {right}> . AB\nbehaviour AB = omega(a, {right}) rate 1/2 . A\n\
     behaviour B = <~a, {left}> . BA\nbehaviour BA = omega(a, {left}) . B\n%s\
     motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }\n"
    (2 * half) bodies

let crowd =
  walkers ~half:4
    ~bodies:
      "for i in 1..3 { process c[i] = solids.Cube(1) mass 1 at translate (-9/2 + 2*i, 3/2, 0) [A] }\n\
       for i in 1..3 { process d[i] = solids.Cube(1) mass 1 at translate (-7/2 + 2*i, -3/2, 0) [B] }\n\
       fixed sink = solids.Cube(1) absorb at translate (7/2, 7/2, 0)\n"

(* {1 Formulas} *)

let properties =
  let open QCheck2.Gen in
  let text = Printf.sprintf in
  let body = map2 (text "%s[%d]") (oneofl [ "c"; "d" ]) (int_range 1 3) in
  let relation = oneofl [ "<"; "<="; ">"; ">="; "="; "!=" ] in
  let half least most = map (text "%d/2") (int_range (2 * least) (2 * most)) in
  let compare number low high = map3 (text "%s %s %s") number relation (half low high) in
  let atom =
    oneof
      [
        compare (map2 (text "%s(%s)") (oneofl [ "x"; "y" ]) body) (-3) 4;
        compare (oneofl [ "bonds()"; "bonds(a)" ]) 0 3; compare (return "processes") 3 7;
        compare (return "time") 0 9; compare (map (text "vx(%s)") body) (-1) 1;
        compare (map2 (text "distance2(%s, %s)") body body) 0 20;
        map (text "gone(%s)") body; map (text "event bounce(%s)") body;
        oneofl [ "event bounce"; "event absorb(d[3], sink)"; "bound(c[1], d[2])"; "event bind" ];
        map2 (text "count(q in c : x(q) > %s) >= %d") (half (-2) 3) (int_range 1 3);
      ]
  in
  let event = oneofl [ "event bounce"; "event bind"; "event absorb(d[2], sink)"; "event split" ] in
  let state =
    oneof
      [ atom; map (text "not (%s)") atom; map2 (text "(%s and %s)") atom atom; map2 (text "(%s or %s)") atom atom ]
  in
  let interval = map2 (fun a b -> text "[%d, %d]" (min a b) (max a b)) (int_bound 8) (int_bound 12) in
  oneof
    [
      map3 (text "P = ? [ %s %s within %s ]") (oneofl [ "eventually"; "always" ]) state (half 0 10);
      map3 (text "P = ? [ %s U%s %s ]") state (oneof [ interval; return "" ]) state;
      map (text "P = ? [ eventually %s ]") state;
      map (text "E = ? [ time U %s ]") state; map2 (text "E = ? [ %s U %s ]") event state;
      map2 (text "E = ? [ %s at %s ]")
        (oneofl [ "bonds()"; "processes"; "x(c[2]) * y(c[2])"; "distance2(c[1], d[3])" ])
        (half 0 9);
    ]

(* It has no value, so that its truth is never known, and nothing of a run is forgotten beside it. *)
let never_known = "P = ? [ eventually x(c[1]) / (x(c[2]) - x(c[2])) > 1 ]"

let outcome : Sample.outcome -> string = function
  | Truth b -> string_of_bool b
  | Number x -> Scc_exact.Rat.to_string x
  | Never -> "never"
  | Free _ -> "free"
  | Too_long _ -> "too long"
  | No_value why -> "no value: " ^ why

let plan text properties ~steps =
  let check i = Printf.sprintf "check q%d : %s\n" i in
  let e = Load.exactly (Load.text (text ^ String.concat "" (List.mapi check properties))) in
  let paths = List.map (fun c -> Result.get_ok (Path.of_check e.model c)) e.checks in
  let semantics = Scc_engine.Standard.of_model e.model in
  { Sample.semantics; declared = e.declared; paths; free = Evenly; steps = Some steps; until = None }

let run plan k = Sample.run plan ~seed:5L ~interrupted:(fun () -> false) k

(* The different answers that were found. *)
let known = Hashtbl.create 16

let same_answers =
  QCheck2.Test.make ~name:"answers are those of runs of which nothing is forgotten" ~count:100 ~print:Fun.id
    properties
    (fun property ->
       let alone = plan crowd [ property ] ~steps:400 in
       let beside = plan crowd [ property; never_known ] ~steps:400 in
       List.for_all
         (fun k ->
            let found = outcome (List.hd (run alone k).outcomes) in
            Hashtbl.replace known found ();
            String.equal found (outcome (List.hd (run beside k).outcomes)))
         [ 0; 1; 2 ])

let various () =
  let among text = Alcotest.(check bool) text true (Hashtbl.mem known text) in
  List.iter among [ "true"; "false" ];
  Alcotest.(check bool) "numbers" true (Hashtbl.length known > 20)

(* {1 Cost} *)

(* Words that a run allocates, for each process. *)
let words property n =
  let bodies =
    Printf.sprintf
      "for i in 1..%d { process c[i] = solids.Cube(1) mass 1 at translate (2*i - %d/2, 3/2, 0) [A] }\n\
       for i in 1..%d { process d[i] = solids.Cube(1) mass 1 at translate (2*i - %d/2, -3/2, 0) [B] }\n"
      n ((2 * n) + 1) n ((2 * n) + 1)
  in
  let plan = plan (walkers ~half:(n + 2) ~bodies) [ property ] ~steps:100_000 in
  let before = Gc.minor_words () in
  ignore (run plan 0);
  (Gc.minor_words () -. before) /. float_of_int n

let linear property () =
  let few = words property 20 and many = words property 160 in
  if many > 2. *. few then
    Alcotest.failf "%s: %.0f words for each of 20, %.0f for each of 160" property few many

let () =
  let cost property = Alcotest.test_case property `Quick (linear property) in
  Alcotest.run "chain"
    [
      ("forgetting", Property.cases [ same_answers ] @ [ Alcotest.test_case "various" `Quick various ]);
      ( "cost of a process",
        List.map cost
          [
            "E = ? [ bonds() at 5 ]"; "P = ? [ eventually bonds() >= 1000 within 5 ]";
            "P = ? [ always processes > 1 within 5 ]"; "E = ? [ x(c[1]) at 5 ]";
          ] );
    ]
