(* Labels, their patterns and renaming, and the format .aut. *)

open Scc_equivalence

let text name f expected input =
  Alcotest.test_case (name ^ ": " ^ input) `Quick (fun () -> Alcotest.(check string) input expected (f input))

let passing l =
  match Label.passing l with None -> "none" | Some p -> Label.of_passing p

let canonical =
  List.map
    (fun (expected, input) -> text "canonical" Label.canonical expected input)
    [
      ("bind(a, p.right, q.left)", "bind(a, q.left, p.right)");
      ("weak(a, p.[v1,v2], q.x)", "weak(a, q.x, p.[v1,v2])");
      ("bounce(c[1], c[2])", "bounce(c[2], c[1])");
      ("strong({<a, {p.x, q.y}>, <b, {p.z, r.y}>})", "strong({<b, {r.y, p.z}>, <a, {q.y, p.x}>})");
      ("bounce(p, q, r)", "bounce(r, p, q)");
      ("weak(a, p.x, q.y) push(1/2)", "weak(a, q.y, p.x) push(1/2)");
      ("weak({<a, {p.x, q.y}> push(2), <b, {p.z, r.y}>})", "weak({<b, {r.y, p.z}>, <a, {q.y, p.x}> push(2)})");
      ("close(a, p.x, q.y)", "close(a, q.y, p.x)");
      ("release(a, p.x, q.y) chance(1/3)", "release(a, q.y, p.x) chance(1/3)");
      ("keep(a, p.x, q.y) chance(1/3)", "keep(a, q.y, p.x) chance(1/3)");
      ("first(a, p.x, q.y) chance(1/3)", "first(a, q.y, p.x) chance(1/3)");
      ("choose(a, p.x, q.y)", "choose(a, q.y, p.x)");
      ("draw(p, (1, 0, 0)) chance(1/3)", "draw(p, (1, 0, 0)) chance(1/3)");
      ("{keep(a, p.x, q.y), release(b, r, s)} chance(1/3)", "{release(b, s, r), keep(a, q.y, p.x)} chance(1/3)");
      ("time(1/2)", "time(1/2)");
      ("send!b,a", "send!b,a");
      ("bind(b, a)", "bind(b, a)");
    ]

let passings =
  List.map
    (fun (expected, input) -> text "passing" passing expected input)
    [
      ("time(1/2)", "time(1/2)");
      ("time(1/2)", "time(0.5)");
      ("time(forever)", "time(forever)");
      ("none", "time(0)");
      ("none", "time(-1)");
      ("none", "time(x)");
      ("none", "time");
      ("none", "timer(1)");
    ]

let rename rules = Label.rename (List.map (fun (from, into) -> Label.rule from into) rules)

let renamings =
  List.map
    (fun (rules, expected, input) -> text "rename" (rename rules) expected input)
    [
      ([ ("p", "x") ], "bind(a, q.left, x.right)", "bind(a, p.right, q.left)");
      ([ ("p", "q"); ("q", "p") ], "bounce(p, q)", "bounce(p, q)");
      ([ ("p", "q"); ("q", "p") ], "bind(a, p.y, q.x)", "bind(a, p.x, q.y)");
      ([ ("p", "x") ], "bounce(pq, q.p)", "bounce(q.p, pq)");
      ([ ("c", "d") ], "bounce(d[1], d[2])", "bounce(c[1], c[2])");
      ([ ("c[1]", "one") ], "bounce(c[12], one)", "bounce(c[1], c[12])");
      ([ ("p", "x"); ("p.left", "y") ], "bind(a, x.right, y)", "bind(a, p.left, p.right)");
      ([ ("bind(a, *)", "bind(b, *)"); ("p", "x") ], "bind(b, p.l, q.r)", "bind(a, p.l, q.r)");
      ([ ("bounce(*)", "tau") ], "tau", "bounce(p, q)");
      ([ ("*(*)", "*") ], "bind", "bind(a, b, c)");
      ([ ("send*", "receive*") ], "receive!1", "send!1");
    ]

let patterns =
  let check (pattern, input, expected) =
    Alcotest.test_case (pattern ^ " and " ^ input) `Quick (fun () ->
        Alcotest.(check (option (list string))) input expected (Label.matches (Label.pattern pattern) input))
  in
  List.map check
    [
      ("ab", "ab", Some []);
      ("ab", "abc", None);
      ("*", "", Some [ "" ]);
      ("a*b", "ab", Some [ "" ]);
      ("a*b", "abab", Some [ "ba" ]);
      ("a*a", "a", None);
      ("*a*", "bab", Some [ "b"; "b" ]);
      ("a*b*c", "abbc", Some [ ""; "b" ]);
    ]

(* {1 Aut} *)

let written g =
  let b = Buffer.create 100 in
  Aut.write g (Buffer.add_string b);
  Buffer.contents b

let again name input expected =
  Alcotest.test_case name `Quick (fun () ->
      match Aut.read ~file:"x.aut" input with
      | Ok g -> Alcotest.(check string) name expected (written g)
      | Error d -> Alcotest.fail d.message)

let refused name input place message =
  Alcotest.test_case name `Quick (fun () ->
      match Aut.read ~file:"x.aut" input with
      | Ok _ -> Alcotest.fail "read"
      | Error d ->
        Alcotest.(check string) "message" message d.message;
        Alcotest.(check (pair int int)) "place" place (d.span.start, d.span.stop))

let aut =
  [
    again "as written"
      "des (0, 2, 2)\n(0, \"a\", 1)\n(1, \"tau\", 0)\n"
      "des (0, 2, 2)\n(0, \"a\", 1)\n(1, \"tau\", 0)\n";
    again "without quotes and spaces"
      "des(0,2,2)\n(0,a b,1)\n(1,i,0)" "des (0, 2, 2)\n(0, \"a b\", 1)\n(1, \"tau\", 0)\n";
    again "line ends of Windows, empty lines"
      "des (1, 1, 2)\r\n\r\n( 1 , \"x\" , 0 )\r\n" "des (1, 1, 2)\n(1, \"x\", 0)\n";
    again "commas and brackets in a label" "des (0, 1, 1)\n(0, \"bind(a, p, q)\", 0)\n"
      "des (0, 1, 1)\n(0, \"bind(a, p, q)\", 0)\n";
    again "commas without quotes" "des (0, 1, 1)\n(0, f(x, y), 0)\n" "des (0, 1, 1)\n(0, \"f(x, y)\", 0)\n";
    again "a state that is not known" "des (0, 2, 2)\n(0, a, 1)\n(1, \"unexplored\", 1)\n"
      "des (0, 2, 2)\n(0, \"a\", 1)\n(1, \"unexplored\", 1)\n";
    again "no transitions" "des (0, 0, 1)\n" "des (0, 0, 1)\n";
    refused "empty" "\n \n" (0, 3) "the file is empty";
    refused "no header" "(0, a, 0)\n" (0, 9) "the file does not begin with `des (initial, transitions, states)`";
    refused "half a header" "des (0, 1)\n" (9, 10) "`,` is missing here";
    refused "initial state" "des (2, 0, 2)\n" (5, 6) "the initial state is not below the number of states, 2";
    refused "a state out of range" "des (0, 1, 1)\n(0, a, 1)\n" (21, 22)
      "state 1 is not below the number of states, 1";
    refused "too many" "des (0, 0, 1)\n(0, a, 0)\n" (14, 23) "a transition more than the 0 of the first line";
    refused "too few" "des (0, 2, 1)\n(0, a, 0)\n" (0, 13) "2 transitions were to follow, and 1 do";
    refused "no label" "des (0, 1, 1)\n(0, , 0)\n" (18, 19) "the label is empty";
    refused "an open quote" "des (0, 1, 1)\n(0, \"a, 0)\n" (18, 20) "the label does not end with its quote";
    refused "no target" "des (0, 1, 1)\n(0, a)\n" (18, 20) "no `, state)` after the label";
    refused "a number too great" "des (0, 1, 99999999999)\n" (11, 21)
      "the number of states is greater than 2147483647";
    refused "rubbish at the end" "des (0, 1, 1)\n(0, a, 0) b\n" (24, 25) "more than fits the line";
  ]

(* Nothing that is read makes it fail in another way. *)
let rubbish =
  QCheck2.Test.make ~name:"rubbish is refused or read" ~count:2500 ~print:String.escaped
    QCheck2.Gen.(
      let words = [ "des"; "("; ")"; ","; "0"; "1"; "\""; "a"; " "; "\n" ] in
      let piece = oneofl ("des (0, 1, 2)\n" :: "(0, \"a\", 1)\n" :: words) in
      map (String.concat "") (list_size (int_range 0 12) piece))
    (fun s -> match Aut.read ~file:"x.aut" s with Ok _ | Error _ -> true)

let suite =
  ("texts",
   [
     ("canonical labels", canonical);
     ("passings of time", passings);
     ("patterns", patterns);
     ("renaming", renamings);
     ("aut", aut @ Scc_test_support.Property.cases [ rubbish ]);
   ])
