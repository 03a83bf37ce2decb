(* A run that could not be rebuilt, in the reports: the verdict says so, and the command ends as a fault of scc,
   when it has told all else. Likewise one that is left out, which is no fault. *)

open Scc_verify
module Console = Scc_cli__Console
module Guard = Scc_cli__Guard
module Check_text = Scc_cli__Check_text
module Json = Scc_json.Json

let text =
  "shape C = box(1,1,1)\nprocess p = C mass 1 [nil]\ncheck a : possibly x(p) > 1\ncheck b : always x(p) < 1\n"

let source = Scc_base.Source.make ~name:"m.sc" text

let loaded =
  match Scc_loading.Loaded.load ~read_file:(fun _ -> Error "none") ~overrides:[] source with
  | Ok l -> l
  | Error _ -> failwith "the model"

let lost = [ "Bug at here:1: broken" ]

let outcome ?left_out lost verdict check : Verdict.outcome =
  let scale = { Verdict.resolution = None; split_step = None; over = None } in
  { check; verdict; scale; rests = []; converges = None; lost; left_out }

let outcomes =
  List.map2 (fun verdict check -> outcome lost verdict check)
    [ Verdict.Violated { witness = None }; Holds { bounds = []; witness = None } ]
    loaded.checks

let console () = Console.make ~color:Console.Never ~json:false ()

let in_words () =
  Alcotest.(check (list string)) "text"
    [
      "a: violated; its run could not be rebuilt: this is a fault of scc\n  possibly x(p) > 1\n\
      \  what failed: Bug at here:1: broken\n";
      "b: holds (exhaustive); its run could not be rebuilt: this is a fault of scc\n  always x(p) < 1\n\
      \  what failed: Bug at here:1: broken\n";
    ]
    (List.map (Check_text.property (console ()) ~full:false ~from:loaded.declared loaded.semantics) outcomes)

let property (l : Scc_loading.Loaded.t) o =
  Scc_reports.Check_json.(Scc_json.Json_format.write property_format (judged l.semantics o))

let in_json () =
  let member o =
    match Json.member "lost" (property loaded o) with
    | Some (`List [ `String what ]) -> Some what
    | Some _ -> Some "something else"
    | None -> None
  in
  Alcotest.(check (list (option string))) "what failed"
    (List.map (fun _ -> Some (List.hd lost)) outcomes)
    (List.map member outcomes);
  let sound = outcome [] (Verdict.Holds { bounds = []; witness = None }) (List.hd loaded.checks) in
  Alcotest.(check bool) "nothing" true (member sound = None)

(* A run is made for its last state as well: where time cannot pass to it, the run is missing for that reason. *)
let at_its_end () =
  let waits (p : Scc_calculus.State.process) =
    let term = Scc_calculus.Behaviour.(wait (Scc_polyhedra.Linear.variable 1 0) nil) in
    Scc_calculus.State.map_leaves (fun l -> { l with behaviour = Scc_calculus.Behaviour.fresh term }) p
  in
  let run last offset : Scc_explain.Witness.t =
    let offset = Scc_exact.Algebraic.of_rat offset in
    {
      initial = loaded.declared; steps = []; last;
      finish = During { choice = None; offset; open_piece = false; from = offset };
      facts = []; argument = None; fixed = None; otherwise = None;
    }
  in
  let broken = Scc_calculus.State.mapi (fun _ p -> waits p) loaded.declared in
  let made last offset =
    let lost = Lost.make Bounds.default Scc_graph_search.Limits.quiet.attempt in
    let found = Lost.run lost loaded.semantics (fun () -> Some (run last offset)) in
    (Option.is_some found, List.length (Lost.taken lost).faults)
  in
  let check what expected found = Alcotest.(check (pair bool int)) what expected found in
  check "a sound one" (true, 0) (made loaded.declared Scc_exact.Rat.one);
  check "at its last state" (true, 0) (made broken Scc_exact.Rat.zero);
  check "beyond it" (false, 1) (made broken Scc_exact.Rat.one)

(* {1 Runs that were not made} *)

let interruption = { Verdict.limit = Interrupted; origin = By_user }
let fifty = { Verdict.limit = States 50; origin = By_user }

let left_out =
  List.map
    (fun verdict -> outcome ~left_out:interruption [] verdict (List.hd loaded.checks))
    [ Verdict.Violated { witness = None }; Holds { bounds = []; witness = None }; Undecided [ Truncated fifty ] ]

let left_out_in_words () =
  let told what =
    Printf.sprintf "a: %s is left out: making it ended at the interruption\n  possibly x(p) > 1\n" what
  in
  Alcotest.(check (list string)) "text"
    (List.map told
       [
         "violated; its run"; "holds (exhaustive); its run";
         "undecided: the exploration ended at the bound of 50 states; the run to what was not explored";
       ])
    (List.map (Check_text.property (console ()) ~full:false ~from:loaded.declared loaded.semantics) left_out);
  Alcotest.(check string) "of Zeno behaviour"
    "Zeno behaviour: a run that goes on for ever within one instant, which is left out: making it ended at the \
     interruption\n"
    (Check_text.zeno_left_out interruption)

let left_out_in_json () =
  let member name json = Option.map Json.pretty (Json.member name json) in
  let json = Some (Json.pretty (Scc_json.Json_format.write Scc_reports.Explored_json.truncation interruption)) in
  let of_property o = member "run_left_out" (property loaded o) in
  Alcotest.(check (list (option string))) "runs" [ json; json; json ] (List.map of_property left_out);
  Alcotest.(check (option string)) "nothing" None
    (of_property (outcome [] (Verdict.Holds { bounds = []; witness = None }) (List.hd loaded.checks)))

(* Those that are known are told, and that there may be more. *)
let causes () =
  let { Check.stats; _ } = Check.unexplored Setup.default [] Scc_graph_search.Limits.Interrupted in
  let stats = { stats with left_out = Some interruption } in
  let told causes = Check_text.causes loaded.model { stats with causes } in
  let line further =
    Printf.sprintf "  %slikely causes are left out: looking for them ended at the interruption\n" further
  in
  Alcotest.(check string) "none is known" (line "") (told []);
  let cure = Growth.cure loaded.model Times in
  Alcotest.(check string) "one is known"
    (Printf.sprintf
       "  likely cause: all comes back to what it was, but at another time\n    cure: %s\n%s\
       \  (specs/guide.md, \"Why did my model blow up?\")\n"
       cure (line "further "))
    (told [ Times ])

let in_sarif () =
  let document =
    Scc_reports.Sarif.document
      ~source:(fun _ -> Some source)
      ~version:"0" ~exit:70 ~ok:false ~faults:lost ~diagnostics:[]
      ~properties:(Some (loaded.model, outcomes))
  in
  let has part text =
    match Str.search_forward (Str.regexp_string part) text 0 with _ -> true | exception Not_found -> false
  in
  let told = Json.pretty document in
  Alcotest.(check (list bool)) "result and notification" [ true; true; true ]
    (List.map (fun part -> has part told)
       [ "possibly x(p) > 1; its run could not be rebuilt"; "toolExecutionNotifications"; List.hd lost ])

let exits () =
  let ends work = Scc_verdicts.Exit_code.to_int (Guard.run (console ()) work) in
  let with_fault code =
    let c = console () in
    Scc_verdicts.Exit_code.to_int
      (Guard.run c (fun () ->
           List.iter (Console.fault c) lost;
           Ok code))
  in
  Alcotest.(check (list int)) "codes" [ 0; 70; 70; 70 ]
    [ ends (fun () -> Ok Holds); with_fault Holds; with_fault Violated; with_fault Unwritten ]

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "lost runs"
    [
      ("reports", [ case "text" in_words; case "JSON" in_json; case "SARIF" in_sarif; case "exit codes" exits ]);
      ("made", [ case "up to the end" at_its_end ]);
      ( "left out",
        [ case "text" left_out_in_words; case "JSON" left_out_in_json; case "likely causes" causes ] );
    ]
