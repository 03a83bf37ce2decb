(* Every diagnostic of the front end: its code, its place, and the words that matter. *)

open Scc_base
open Scc_syntax
open Scc_test_trees
open Support

let check text expected words () =
  let ds = errors text in
  Alcotest.(check (list string)) (rendered text ds) expected (summary text ds);
  List.iter
    (fun word ->
       if not (contains (rendered text ds) word) then
         Alcotest.failf "`%s` is not in\n%s" word (rendered text ds))
    words

let case name text expected words = Alcotest.test_case name `Quick (check text expected words)
let nine n = String.make n '9'

let lexical =
  [
    case "a NUL" "model m\n\000" [ "SC0102 2:1" ] [ "U+0000" ];
    case "not UTF-8" "model m // \xFF" [ "SC0102 1:12" ] [ "UTF-8" ];
    case "an overlong form" "\xC0\xAF" [ "SC0102 1:1" ] [];
    case "a surrogate" "// \xED\xA0\x80" [ "SC0102 1:4" ] [];
    case "a cut sequence" "// \xE2\x82" [ "SC0102 1:4" ] [];
    case "an unknown character" "param n = 3 $ 4" [ "SC0104 1:13" ] [ "`$`" ];
    case "a letter that is not ASCII" "param \xCE\xB1 = 3" [ "SC0104 1:7" ] [ "U+03B1"; "ASCII" ];
    case "a minus sign" "param n = \xE2\x88\x923" [ "SC0104 1:11" ] [ "write `-`" ];
    case "a doubled equals sign" "let x = a == b" [ "SC0104 1:11" ] [ "write `=`" ];
    case "three marks of other languages" "let x = !a && b" [ "SC0104 1:9"; "SC0104 1:12" ]
      [ "write `not`"; "write `and`" ];
    case "a name that begins with a line" "param _n = 3" [ "SC0104 1:7" ] [ "begins with a letter" ];
    case "a barred word" "behaviour K = <n\xC4\xABl, {f}>. nil" [ "SC0104 1:16" ] [ "`nil`" ];
    case "a comment without its end" "model m\n/* one /* two */" [ "SC0105 2:1" ] [ "`*/`" ];
    case "a string without its end" "shape H = mesh \"abc\nmodel m" [ "SC0105 1:16" ] [ "not closed" ];
    case "a string cut by the end" "shape H = mesh \"abc" [ "SC0105 1:16" ] [];
    case "too large by its exponent" "param n = 1e1000000000" [ "SC0106 1:11" ] [ "4000 digits" ];
    case "too large by its digits" ("param n = " ^ nine 100_001) [ "SC0106 1:11" ] [];
    case "a zero denominator" "param n = 1/0" [ "SC0107 1:13" ] [];
    case "a zero denominator as a decimal" "process p = T mass 1/0.00 [nil]" [ "SC0107 1:22" ] [];
  ]

let syntax =
  [
    case "no text" "" [ "SC0112 1:1" ] [ "process" ];
    case "comments alone" " // a\n/* b */\n" [ "SC0112 1:1" ] [];
    case "a word for a name" "process EFX = Cube [nil] process nil = Cube [nil]" [ "SC0110 1:34" ]
      [ "`nil` is a word of the language" ];
    case "a word of a declaration for a name" "behaviour let = nil" [ "SC0110 1:11" ]
      [ "`let` is a word of the language" ];
    case "a word of a declaration for a behaviour"
      "behaviour B = fixed process p = Cube mass 1 [B]" [ "SC0110 1:15" ]
      [ "`fixed` is a word of the language" ];
    case "a word taken for an operator"
      "let x = count + 1" [ "SC0110 1:15" ] [ "`count` is a word of the language" ];
    case "an operator as an argument" "check c : always bound(p, AG)" [ "SC0110 1:29" ]
      [ "`AG` is a word of the language" ];
    case "a word for a channel" "behaviour B = <at, {f}>. nil" [ "SC0110 1:16" ]
      [ "`at` is a word of the language" ];
    case "a word for a vertex" "shape S { vertices scale (0,0,0) faces }" [ "SC0110 1:20" ]
      [ "`scale` is a word of the language" ];
    case "a misspelt declaration"
      "model m\nproces p = Cube [nil]" [ "SC0110 2:1" ] [ "did you mean `process`?" ];
    case "a misspelt word inside" "process p = Cube velocty (1, 2, 3) [nil]" [ "SC0110 1:18" ]
      [ "did you mean `velocity`?" ];
    case "a misspelt word taken for a name"
      "check c : alway x" [ "SC0110 1:17" ] [ "did you mean `always`?" ];
    case "two components" "process p = Cube velocity (1, 2) [nil]" [ "SC0110 1:32" ] [ "three components" ];
    case "an index in an attribute" "process p = Cube mass m[1] [nil]" [ "SC0110 1:25" ]
      [ "in parentheses" ];
    case "a process without behaviour" "process p = Cube mass 3" [ "SC0110 1:24" ]
      [ "the text ends here"; "behaviour in square brackets" ];
    case "chained comparisons" "let a = 1 < 2 < 3" [ "SC0110 1:15" ] [ "join two with `and`" ];
    case "a product without its sign" "let a = 2i" [ "SC0110 1:10" ] [ "`2*i`" ];
    case "a decimal point alone" "let a = (1., 2)" [ "SC0110 1:11" ] [ "followed by a digit" ];
    case "a decimal without its first digit" "let a = .5" [ "SC0110 1:9" ] [ "`0.5`" ];
    case "path quantifiers apart" "check c : A G x" [ "SC0110 1:13" ] [ "`AG` is one word" ];
    case "consequences in a chain" "check c : a leads_to b leads_to c" [ "SC0110 1:24" ]
      [ "`leads_to` is not chained" ];
    case "a consequence without its right side" "check c : a leads_to" [ "SC0110 1:21" ]
      [ "a bound on time such as `[<= 5]`" ];
    case "no duration" "check c : a leads_to b within" [ "SC0110 1:30" ] [ "expected a duration" ];
    case "a bound alone" "check c : a leads_to[<= 5]" [ "SC0110 1:27" ] [ "the formula that the bound is for" ];
    case "two words" "check c : a leads to b" [ "SC0110 1:13" ] [ "expected an operator" ];
    case "an event without its end" "check c : always event bind(a, p" [ "SC0110 1:33" ] [ "not closed" ];
    case "glues before parts"
      "compound C { glue a.f ~ b.f part x : T }" [ "SC0110 1:29" ] [ "all parts come before" ];
    case "an open bracket"
      "let g = (1 + 2\nlet h = 3" [ "SC0110 2:1" ] [ "m.sc:1:9: note: this `(` is not closed" ];
    case "a stray bracket" "let g = 1)\nlet h = 2]" [ "SC0110 1:10"; "SC0110 2:10" ] [];
    case "several errors in one run"
      ("model\nparam n =\nshape S { vertices a (1, 2) faces f [a] }\nlet ok = 1\n"
       ^ "behaviour K = <a, {x}> nil\nlet x = 1 +")
      [ "SC0110 2:1"; "SC0110 3:1"; "SC0110 3:27"; "SC0110 5:24"; "SC0110 6:12" ]
      [];
    case "errors in the body of a loop"
      "for i in 1..3 {\n  process p[i] = T mass [nil]\n  let a = )\n  let b = 1\n}\nlet c = *"
      [ "SC0110 2:25"; "SC0110 3:11"; "SC0110 6:9" ] [];
    case "a bond after an error"
      "let a = )\nbond <a, {x}>" [ "SC0110 1:9"; "SC0110 2:12" ] [ "two features" ];
    case "a lexical error hides what follows from it"
      "let a = 1 $ 2\nlet b = )" [ "SC0104 1:11"; "SC0110 2:9" ] [];
    case "a brace left open"
      "shape S { vertices a (0, 0, 0) faces f [a]\nlet b = )" [ "SC0110 2:1"; "SC0110 2:9" ]
      [ "this `{` is not closed" ];
  ]

let repeat n s = String.concat "" (List.init n (fun _ -> s))

let capped () =
  let ds = errors (repeat 50 "let a = )\n") in
  Alcotest.(check int) "syntax" Parse.max_errors (List.length ds);
  let ds = errors (repeat 50 "let a = $\n") in
  Alcotest.(check int) "lexical" Parse.max_errors (List.length ds)

let deterministic () =
  let text = repeat 30 "let a = ) $\nprocess p = [\n" in
  Alcotest.(check string) "twice" (rendered text (errors text)) (rendered text (errors text))

(* {1 Limits} *)

let only_too_deep text () =
  match errors text with
  | [ d ] -> Alcotest.(check string) "code" "SC0111" d.Diag.code
  | ds -> Alcotest.fail (rendered (String.sub text 0 40) ds)

let hundred_thousand =
  let n = 100_000 in
  let chain before unit after = before ^ repeat n unit ^ after in
  List.map
    (fun (name, text) -> Alcotest.test_case name `Quick (only_too_deep text))
    [
      ("parentheses", chain "let a = " "(" ("1" ^ repeat n ")"));
      ("parentheses left open", chain "let a = " "(" "");
      ("square brackets", chain "let a = " "b[" "");
      ("braces", chain "" "{" "");
      ("loops", chain "" "for i in 1..2 { " "let a = 1");
      ("not", chain "let a = " "not " "b");
      ("minus", chain "let a = " "-" "1");
      ("sums", chain "let a = 1" " + 1" "");
      ("products in a mass", chain "process p = T mass 1" "*1" " [nil]");
      ("implications", chain "let a = 1" " => b" "");
      ("conjunctions of comparisons", chain "let a = b < 1" " and bond < 1" "");
      ("if", chain "let a = " "if b then c else " "d");
      ("forall", chain "let a = " "forall p in T: " "b");
      ("always", chain "let a = " "always " "b");
      ("AX", chain "let a = " "AX " "b");
      ("delays", chain "behaviour K = " "eps(1). " "nil");
      ("channels", chain "behaviour K = " "<a, {f}>. " "nil");
      ("weak splits", chain "behaviour K = " "omega(a, {f, g}). " "nil");
      ("strong splits", chain "behaviour K = " "rho({<a, {f}>}). " "nil");
      ("sums of behaviours", chain "behaviour K = nil" " + nil" "");
      ("bracketed sums", chain "behaviour K = " "nil + (" ("nil" ^ repeat n ")"));
      ("scaled", chain "shape S = T" " scaled (1, 1, 1)" "");
      ("bracketed processes", chain "process p = " "(" "");
      ("nested sums that are each within the limit",
       "let a = " ^ repeat 20 "(" ^ "1" ^ repeat 20 (repeat 1_000 " + 1" ^ ")"));
    ]

let within_limits text () =
  let m = parsed text in
  Alcotest.(check bool) "printed and read" true (Ast_equal.model m (parsed (Printer.model m)))

let allowed =
  List.map
    (fun (name, text) -> Alcotest.test_case name `Quick (within_limits text))
    [
      ("1 000 parentheses", "let a = " ^ repeat 999 "-(" ^ "1" ^ repeat 999 ")");
      ("10 000 operators", "let a = 1" ^ repeat 9_999 " + 1");
      ("10 000 prefixes", "behaviour K = " ^ repeat 9_999 "<a, {f}>. " ^ "nil");
      ("5 000 summands", "behaviour K = nil" ^ repeat 4_999 " + eps(1). nil");
      ("500 loops", repeat 500 "for i in 1..2 { " ^ "let a = 1" ^ repeat 500 "}");
      ("100 000 declarations", repeat 100_000 "let a = b + 1\n");
      ("50 000 vertices", "shape S { vertices " ^ repeat 50_000 "a (-1, 0, 1/2) " ^ "faces }");
      ("2 000 leaves",
       "process p = T mass 2*3 at translate (1, 2, 3) * scale (1, 1, 1) [nil]"
       ^ repeat 1_999 " <a, {p.f, q.f}> q : T mass 2*3 at translate (1, 2, 3) * scale (1, 1, 1) [nil]");
      ("20 000 components", "network p" ^ repeat 20_000 " || p");
      ("20 000 kicks", "motion choose { (1, 0, 0)" ^ repeat 20_000 ", (-1, 0, 0)" ^ "}");
      ("a number of 4 000 digits", "param n = " ^ nine 4_000);
      ("a small number of 4 000 digits", "param n = 0." ^ nine 1_999 ^ "e-2000");
    ]

let suite =
  ("syntax errors",
   [
     ("lexical", lexical);
     ("syntax", syntax);
     ("recovery",
      [
        Alcotest.test_case "at most so many errors" `Quick capped;
        Alcotest.test_case "the same errors every time" `Quick deterministic;
      ]);
     ("100 000 nested", hundred_thousand);
     ("within the limits", allowed);
   ])
