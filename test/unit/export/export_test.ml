(* What is written for other tools: names, and the formats byte by byte on small graphs. *)

open Scc_exact
open Scc_semantics
open Scc_verify
open Scc_runs
open Scc_graphs

let case name f = Alcotest.test_case name `Quick f
let text = Alcotest.(check string)
let lines ss = String.concat "\n" ss ^ "\n"
let bounced = Transition.Bounce { firsts = [ 0; 1 ]; hits = [] }
let time n d : Transition.label = Time (Rat.make (Z.of_int n) (Z.of_int d))

let contains whole part =
  let n = String.length part in
  let rec from i = i + n <= String.length whole && (String.equal (String.sub whole i n) part || from (i + 1)) in
  from 0

let has what whole part = Alcotest.(check bool) (what ^ ": " ^ part) true (contains whole part)
let lacks what whole part = Alcotest.(check bool) (what ^ ": no " ^ part) false (contains whole part)

(* {1 Names} *)

let names () =
  let t = Safe_names.make ~reserved:[ "init" ] in
  let is expected s = text s expected (Safe_names.name t s) in
  is "x_p_le_3" "x(p) <= 3";
  is "x_p_lt_3" "x(p) < 3";
  is "x_p_eq_m9_over_4" "x(p) = -9/4";
  is "time_1_over_2" "time(1/2)";
  is "bind_a_c_1_right_c_2_left" "bind(a, c[1].right, c[2].left)";
  is "init_2" "init";
  is "x_p_le_3_2" "x(p)<=3";
  is "x_p_le_3" "x(p) <= 3";
  is "p_7" "7";
  is "p" "p";
  is "p_2" "";
  Alcotest.(check int) "listed once" 10 (List.length (Safe_names.listed t))

let safe name =
  let letter = function 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false in
  let plain = function '0' .. '9' | '_' -> true | c -> letter c in
  String.length name <= 64 && letter name.[0] && String.for_all plain name

let names_are_safe =
  let letter = QCheck2.Gen.oneofl [ 'a'; 'b'; '('; ')'; ' '; '<'; '='; '-'; '_'; '2'; '/'; '"'; '\xc3' ] in
  QCheck2.Test.make ~name:"names are safe, and differ as texts do" ~count:300
    QCheck2.Gen.(list_size (1 -- 60) (string_size ~gen:letter (oneof [ 0 -- 4; 60 -- 70 ])))
    (fun texts ->
       let t = Safe_names.make ~reserved:[ "a" ] in
       let given = List.map (Safe_names.name t) texts in
       let again = List.map (Safe_names.name t) texts in
       let distinct l = List.length (List.sort_uniq String.compare l) in
       List.for_all safe given
       && List.equal String.equal given again
       && distinct given = distinct texts
       && not (List.mem "a" given))

(* {1 Predicates} *)

let predicates () =
  let e =
    Graphs.explored
      {|
process p = Cube mass 1 [nil]
process q = Cube mass 1 at translate (5,0,0) [nil]
check one : always (x(p) = 0 and not touching(p, q))
check two : possibly touching(p, q) within 3
check three : eventually quiescent
|}
  in
  let found =
    List.map
      (fun (p : State_predicates.t) -> p.name ^ " is " ^ p.text)
      (State_predicates.of_checks (Explored.model e.space) e.loaded.checks)
  in
  Alcotest.(check (list string)) "predicates"
    [
      "x_p_eq_0 is x(p) = 0";
      "touching_p_q is touching(p, q)";
      "check_one is x(p) = 0 and not touching(p, q)";
      "check_two is touching(p, q)";
      "check_three is quiescent";
    ]
    found;
  let aim = function
    | name, State_predicates.Reached _ -> name ^ " reached"
    | name, Kept _ -> name ^ " kept"
  in
  Alcotest.(check (list string)) "aims" [ "one kept"; "three reached" ]
    (List.map aim (State_predicates.aims e.loaded.checks))

let asked () =
  let check ~draws formula =
    let e =
      Graphs.explored
        (Printf.sprintf
           {|
process p = Cube mass 1 [nil]
process q = Cube mass 1 at translate (5,0,0) [nil]
check c : %s
|}
           formula)
    in
    let predicates = Array.of_list (State_predicates.of_checks (Explored.model e.space) e.loaded.checks) in
    let f = (List.hd e.loaded.checks).formula in
    match Pctl.formula ~occurs:(fun name -> not (String.equal name "x_p_gt_9")) ~draws predicates f with
    | Ok s -> s
    | Error why -> why
  in
  let is ?(draws = false) expected formula = text formula expected (check ~draws formula) in
  is "!(P<1 [F (\"x_p_eq_1\")])" "EF x(p) = 1";
  is "P>=1 [F (\"x_p_eq_1\")]" "AF x(p) = 1";
  is "!(P<1 [G (\"x_p_eq_1\")])" "EG x(p) = 1";
  is "P>=1 [G (\"x_p_eq_1\")]" "AG x(p) = 1";
  is "P>=1 [F (false)]" "AF x(p) > 9";
  is "P>=1 [G ((\"check_c\") | (P>=1 [F (\"x_p_eq_2\")]))]" "x(p) = 1 leads_to x(p) = 2";
  let until =
    "P>=1 [(\"x_p_eq_1\") U ((\"x_p_eq_2\") & ((\"x_p_eq_1\") | (!(\"right_after\"))))]"
  in
  is
    (Printf.sprintf "((\"right_after\") & (\"x_p_eq_2\")) | (%s)" until)
    "A[ x(p) = 1 U x(p) = 2 ]";
  is "it has a bound of time" "AF[<= 2] x(p) = 1";
  is "it has the operator X" "EX x(p) = 1";
  let is = is ~draws:true and not_told = "it speaks of runs of probability 0, too" in
  is "!(P<=0 [F (\"x_p_eq_1\")])" "EF x(p) = 1";
  is "P>=1 [G (\"x_p_eq_1\")]" "AG x(p) = 1";
  is not_told "AF x(p) = 1";
  is not_told "EG x(p) = 1";
  is not_told "A[ x(p) = 1 U x(p) = 2 ]";
  is not_told "x(p) = 1 leads_to x(p) = 2"

let four () =
  Graphs.made ~unexplored:[ 3 ] ~resting:[ 2 ]
    [| [ (time 1 2, 1) ]; [ (bounced, 2); (bounced, 3) ]; []; []; [] |]

(* {1 Markov decision processes} *)

let explicit () =
  let e = four () in
  let l = Graphs.labelling e in
  let m = Mdp.make l in
  text "PRISM transitions"
    (lines
       [
         "5 6 6"; "0 0 1 1 time_1_over_2"; "1 0 2 1 bounce_p_q"; "1 1 3 1 bounce_p_q"; "2 0 2 1 rest";
         "3 0 3 1 unexplored"; "4 0 4 1 stuck";
       ])
    (Graphs.written (Explicit_files.transitions Prism m));
  text "Storm transitions" (lines [ "mdp"; "0 0 1 1"; "1 0 2 1"; "1 1 3 1"; "2 0 2 1"; "3 0 3 1"; "4 0 4 1" ])
    (Graphs.written (Explicit_files.transitions Storm m));
  text "PRISM labels"
    (lines
       [
         "0=\"init\" 1=\"deadlock\" 2=\"quiescent\" 3=\"unexplored\" 4=\"right_after\""; "0: 0"; "2: 2"; "3: 3";
         "4: 1";
       ])
    (Graphs.written (Explicit_files.labels Prism m));
  text "Storm labels"
    (lines
       [
         "#DECLARATION"; "init deadlock quiescent unexplored right_after"; "#END"; "0 init"; "2 quiescent";
         "3 unexplored"; "4 deadlock";
       ])
    (Graphs.written (Explicit_files.labels Storm m));
  text "Storm actions"
    (lines
       [
         "#DECLARATION"; "time_1_over_2 bounce_p_q rest unexplored stuck"; "#END"; "0 0 time_1_over_2";
         "1 0 bounce_p_q"; "1 1 bounce_p_q"; "2 0 rest"; "3 0 unexplored"; "4 0 stuck";
       ])
    (Graphs.written (Explicit_files.choice_labels m));
  text "states" (lines [ "(state)"; "0:(0)"; "1:(1)"; "2:(2)"; "3:(3)"; "4:(4)" ])
    (Graphs.written (Explicit_files.states m (State_variables.make e.space)))

let drn () =
  let e =
    Graphs.explored "process p = Cube mass 1 velocity (1/3,0,0) [nil]\ncheck near : always x(p) <= 3\n"
  in
  let l = Graphs.labelling ~instants:true e in
  text "drn"
    (lines
       [
         "// model without a name";
         "// semantics 3";
         "// explored: 1 states, 0 transitions; complete";
         "// label x_p_le_3: x(p) <= 3";
         "// label check_near: x(p) <= 3";
         "// action time_9: time(9)";
         "// check near: P>=1 [G (\"x_p_le_3\")]";
         "@type: MDP";
         "@value_type: rational";
         "@parameters";
         "";
         "@reward_models";
         "time";
         "@nr_states";
         "2";
         "@nr_choices";
         "2";
         "@model";
         "state 0 [0] init quiescent x_p_le_3 check_near";
         "\taction time_9 [9]";
         "\t\t1 : 1";
         "state 1 [0] quiescent right_after";
         "\taction rest [0]";
         "\t\t1 : 1";
       ])
    (Graphs.written (Drn.write e (Mdp.make l)));
  let plain = Graphs.written (Drn.write e (Mdp.make (Graphs.labelling e))) in
  has "without instants it says so" plain
    "// labels that change while time passes, and tell of the states alone: x_p_le_3, check_near\n"

(* Storm refuses questions about a reward model whose rewards are all 0. *)
let no_time () =
  let e = Graphs.explored "process p = Cube mass 1 [nil]\ncheck near : E = ? [ time U x(p) <= 3 ]\n" in
  let drn = Graphs.written (Drn.write e (Mdp.make (Graphs.labelling e))) in
  let why = "it has a reward since no action of the others takes time" in
  has "a state more" drn ("// state 1: not reached; " ^ why ^ "\n@type: MDP\n");
  has "counted" drn "@nr_states\n2\n@nr_choices\n2\n";
  has "with a reward" drn "\taction rest [0]\n\t\t0 : 1\nstate 1 [0]\n\taction unreachable [1]\n\t\t1 : 1\n"

let truncated () =
  let options = { Setup.default with bounds = { Bounds.default with states = Given 3 } } in
  let e =
    Graphs.explored ~options
      {|
process p = Cube mass 1 velocity (1,0,0) [nil]
process q = Cube mass 1 velocity (-1,0,0) at translate (5,0,0) [nil]
process r = Cube mass 1 velocity (-1,0,0) at translate (15,0,0) [nil]
|}
  in
  Alcotest.(check int) "unexpanded" 1 (Explored.unexpanded e.space);
  let l = Graphs.labelling e in
  let drn = Graphs.written (Drn.write e (Mdp.make l)) in
  has "drn" drn "// TRUNCATED: 1 states unexplored, by the bound of 3 states\n";
  has "drn" drn "state 2 [0] unexplored\n\taction unexplored [0]\n\t\t2 : 1\n";
  has "json" (Graphs.written (Graph_json.write e l)) "\"complete\": false,\n\"unexplored\": 1,\n";
  has "dot" (Graphs.written (Dot.write e l ~positions:false)) "style=\"rounded,filled,dashed\""

(* {1 Pictures} *)

let dot_of ?(positions = false) (e : Exported.t) =
  Graphs.written (Dot.write e (Labelling.make ~instants:true e.space (Dot.predicates e.loaded.checks)) ~positions)

let folding () =
  let chain next =
    Graphs.made [| [ (time 1 1, 1) ]; [ (time 1 2, 2) ]; [ (time 1 3, 3) ]; next; [ (bounced, 4) ] |]
  in
  let drawn = dot_of (chain [ (bounced, 4) ]) in
  has "one edge" drawn "s0 -> s3 [label=\"time(11/6)\\nin 3 steps\"";
  lacks "the states between" drawn "s1";
  let drawn = dot_of (chain [ (bounced, 1) ]) in
  has "a state with another way in stays" drawn "s0 -> s1 [label=\"time(1)\"";
  has "from there on" drawn "s1 -> s3 [label=\"time(5/6)\\nin 2 steps\"";
  let loop = dot_of (Graphs.made [| [ (time 1 1, 1) ]; [ (time 1 1, 0) ] |]) in
  has "a cycle of time" loop "s0 -> s0 [label=\"time(2)\\nin 2 steps\""

let colours () =
  let drawn =
    dot_of
      (Graphs.explored
         {|
process p = Cube mass 1 velocity (1,0,0) [nil]
fixed w = Cube at translate (6,0,0)
check far  : always x(p) <= 4
check low  : always x(p) < 3
check back : possibly vx(p) < 0
check soon : always x(p) < 3 within 1
|})
  in
  has "reached on the way" drawn
    "s0 -> s1 [label=\"time(4)\\nviolates low\", color=\"#b3261e\", fontcolor=\"#b3261e\"]";
  has "holds in the state" drawn "reaches back";
  has "legend" drawn "<td align=\"left\">violates low: always x(p) &lt; 3</td>";
  lacks "what does not occur" drawn "far: ";
  lacks "a bound of time" drawn "soon: "

let escapes () =
  let e = Graphs.made [| [] |] in
  let origin = { e.loaded.origin with name = Some "a\"b\\<c>" } in
  let drawn = dot_of { e with loaded = { e.loaded with origin } } in
  has "quotes and strokes" drawn "digraph \"a\\\"b\\\\<c>\" {";
  has "in the legend" drawn "model a&quot;b\\&lt;c&gt;"

(* {1 Large graphs} *)

let large () =
  let n = 300_000 in
  let next i : (Transition.label * int) list =
    if i = n - 1 then [] else if i mod 3 = 0 then [ (bounced, i + 1) ] else [ (time 1 1, i + 1) ]
  in
  let e = Graphs.made (Array.init n next) in
  let bytes write =
    let total = ref 0 in
    write (fun s -> total := !total + String.length s);
    !total > n
  in
  let m = Mdp.make (Graphs.labelling e) in
  List.iter
    (fun (what, write) -> Alcotest.(check bool) what true (bytes write))
    [
      ("drn", Drn.write e m);
      ("tra", Explicit_files.transitions Prism m);
      ("sta", Explicit_files.states m (State_variables.make e.space));
    ];
  let time_only = Graphs.made (Array.init n (fun i -> if i = n - 1 then [] else [ (time 1 1, i + 1) ])) in
  has "a long fold" (dot_of time_only) "in 299999 steps"

(* {1 Traces} *)

let itf () =
  let e = Graphs.explored "process p = Cube mass 1 velocity (1/3,0,0) at translate (-1/2,0,0) [nil]" in
  let s = e.space.state 0 in
  let b = Buffer.create 100 in
  let start () =
    Buffer.clear b;
    Itf.start (Explored.model e.space) e.loaded.origin (Buffer.add_string b)
  in
  let t = start () in
  Itf.event t (Start s);
  Itf.event t (Instant { offset = Rat.one; time = Rat.one; state = s });
  Itf.event t (End { steps = 0; time = Rat.one; ending = Quiescent; last = None; rounded = None });
  Itf.close t;
  let whole = Buffer.contents b in
  let json = Yojson.Basic.from_string whole in
  let states = Yojson.Basic.Util.(json |> member "states" |> to_list) in
  Alcotest.(check int) "states" 2 (List.length states);
  has "a rational" whole
    "\"position\":{\"#map\":[[\"p\",{\"#tup\":[{\"#tup\":[{\"#bigint\":\"-1\"},{\"#bigint\":\"2\"}]},";
  has "how it ended" whole "{\"#meta\":{\"index\":1,\"ending\":\"quiescent\"},\"action\":\"pass\",";
  let t = start () in
  Itf.close t;
  ignore (Yojson.Basic.from_string (Buffer.contents b));
  let t = start () in
  Itf.event t (Start s);
  Itf.close t;
  has "broken off" (Buffer.contents b) "\"ending\":\"broken off\"";
  ignore (Yojson.Basic.from_string (Buffer.contents b))

let () =
  Alcotest.run "export"
    [
      ( "names",
        [ case "examples" names; Scc_test_support.Property.case names_are_safe ] );
      ("predicates", [ case "of checks" predicates; case "questions" asked ]);
      ( "mdp",
        [
          case "explicit files" explicit; case "drn" drn; case "no time passes" no_time;
          case "truncated" truncated;
        ] );
      ("dot", [ case "folding" folding; case "colours" colours; case "escapes" escapes ]);
      ("large", [ case "300 000 states" large ]);
      ("itf", [ case "states" itf ]);
    ]
