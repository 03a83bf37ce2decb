(* What the reader makes of what is written. *)

open Scc_base
open Scc_syntax
open Scc_test_trees
open Support

let same_expr (a, b) () =
  if not (Ast_equal.expr (parsed_expr a) (parsed_expr b)) then
    Alcotest.failf "%s reads as %s, not as %s" a (Printer.expr (parsed_expr a)) b

let same_model (a, b) () =
  if not (Ast_equal.model (parsed a) (parsed b)) then
    Alcotest.failf "%s reads as %s" a (Printer.model (parsed a))

(* A text and the same with brackets. *)
let precedence =
  [
    ("a + b*c", "a + (b*c)"); ("a - b - c", "(a - b) - c"); ("a/b*c", "(a/b)*c"); ("-a*b", "(-a)*b");
    ("- a - b", "(-a) - b"); ("a < b + 1", "a < (b + 1)"); ("not a = b", "not (a = b)");
    ("not a and b", "(not a) and b"); ("a or b and c", "a or (b and c)");
    ("a => b => c", "a => (b => c)"); ("a or b => c and d", "(a or b) => (c and d)");
    ("possibly a and b", "possibly (a and b)"); ("a and possibly b or c", "a and (possibly (b or c))");
    ("always a => b", "always (a => b)"); ("AG a => b", "(AG a) => b");
    ("not EF a and b", "(not (EF a)) and b");
    ("AG[<= 5] a = b", "AG[<= 5] (a = b)"); ("possibly a and b within 10", "possibly (a and b) within 10");
    ("possibly a within 2 + 3 and b", "(possibly a within (2 + 3)) and b");
    ("always possibly a within 5", "always (possibly a within 5)");
    ("forall p in T: a => b", "forall p in T: (a => b)");
    ("a and exists p in T: b or c", "a and (exists p in T: (b or c))");
    ("if a then b else c + 1", "if a then b else (c + 1)");
    ("1 + if a then b else c*2", "1 + (if a then b else (c*2))");
    ("count(p in T: a and b) >= 2*n", "(count(p in T: (a and b))) >= (2*n)");
    ("A[ a and b U c or d ]", "A[ (a and b) U (c or d) ]"); ("E[a U[1, 2] b]", "E[(a) U[(1), (2)] (b)]");
    ("behaviour(p) = K", "(behaviour(p)) = (K)"); ("0.125", "125e-3"); ("1e2", "100");
    ("bond + mass", "(bond) + (mass)");
    ("a or b leads_to c => d", "(a or b) leads_to (c => d)");
    ("a leads_to b within 2 leads_to c", "(a leads_to b within 2) leads_to c");
    ("forall p in T: a leads_to[1, 2] b", "forall p in T: (a leads_to[1, 2] b)");
    ("if a then b else c leads_to d", "if a then b else (c leads_to d)");
    ("event bind and event + 1 = event.x", "(event bind) and ((event + 1) = event.x)");
    ("E[ A[1, 2] U U ]", "E[ (A[1, 2]) U (U) ]"); ("A[U[1] U[2, 3] X]", "A[ (U[1]) U[2, 3] (X) ]");
    ("A + E*F < G(X)", "(A) + (E*F) < (G(X))");
    ("behaviour(A) = E and bound(A[1], X)", "(behaviour(A) = (E)) and (bound(A[1], (X)))");
    ("not event bind(event, p)", "not (event bind(event, p))"); ("event bounce()", "event bounce");
  ]

let distinct =
  [ ("a - (b - c)", "a - b - c"); ("AG (a => b)", "AG a => b"); ("~a", "a"); ("(a => b) => c", "a => b => c");
    ("always[<= 5] a", "always a within 5"); ("1/8", "0.125");
    ("a leads_to (b leads_to c)", "(a leads_to b) leads_to c"); ("event bind", "event weak");
    ("a leads_to[<= 5] b", "a leads_to b within 5"); ("event", "event bind"); ]

let distinct_expr (a, b) () =
  if Ast_equal.expr (parsed_expr a) (parsed_expr b) then Alcotest.failf "%s and %s read alike" a b

(* The paper's letters and the words for them. *)
let notations =
  [
    ("behaviour K = \xE2\x9F\xA8a,{f}\xE2\x9F\xA9\xC2\xB7nil", "behaviour K = <a, {f}>. nil");
    ("behaviour K = \xE2\x9F\xA8a\xCC\x84,{f}\xE2\x9F\xA9.nil", "behaviour K = <~a, {f}>. nil");
    ("behaviour K = <\xC4\x81,{f}>.nil", "behaviour K = <~a, {f}>. nil");
    ("behaviour K = <b\xCC\x84o\xCC\x84n\xCC\x84d\xCC\x84,{f}>.nil", "behaviour K = <~bond, {f}>. nil");
    ("behaviour K = <\xC5\x8D_x1,{f}>.nil", "behaviour K = <~o_x1, {f}>. nil");
    ("behaviour K = <\xE1\xB8\xA1a,{f}>.nil", "behaviour K = <~ga, {f}>. nil");
    ("behaviour K = \xCF\x89(a,{f}). \xCF\x81({\xE2\x9F\xA8a,{f}\xE2\x9F\xA9}). \xCE\xB5(2). nil",
     "behaviour K = omega(a, {f}). rho({<a, {f}>}). eps(2). nil");
    ("network p \xE2\x80\x96 q", "network p || q");
    ("let x = offers(p, \xC4\x81)", "let x = offers(p, ~a)");
    ("let x = offers(p, \xC4\x93vent)", "let x = offers(p, ~event)");
    ("let x = event bond <event, {event.f, b.f}>", "let x = event\nbond <event, {event.f, b.f}>");
    ("let x = 2^-3*round  round velocity 0.125  round orientation n",
     "let x = 0.125*round\nround velocity 2^-3\nround orientation n");
    ("let round = 2  let x = round dynamics free_body resolution 1/2",
     "let round = 2\nlet x = round\ndynamics free_body\nresolution 1/2");
    ("behaviour K = <r\xCC\x84ound,{f}>.resolution network p",
     "behaviour K = <~round, {f}>. resolution\nnetwork p");
    ("\xEF\xBB\xBFmodel m\r\nparam n = 1\r\n", "model m param n = 1");
    ("/* a /* b */ c */ model m // x", "model m");
    ("for i in 1..2 { }", "for i in 1 .. 2 {}");
    ("process p = (a : T [nil] <c, {a.f, b.f}> b : T [nil]) <c, {b.f, d.f}> (d : T [nil])",
     "process p = a : T [nil] <c, {a.f, b.f}> b : T [nil] <c, {b.f, d.f}> d : T [nil]");
    ("process p = a : T [nil] <c, {a.f, b.f}> (b : T [nil] <c, {b.f, d.f}> d : T [nil])",
     "process p = a : T [nil] <c, {a.f, b.f}> b : T [nil] <c, {b.f, d.f}> d : T [nil]");
    ("behaviour A = <E, {F}>. AG + omega(~X, {U, [G, EX]}). U  process AF = A mass E [G]  network EF || A[1]  \
      check EG : AG X",
     "behaviour A = (<E, {F}>. AG) + (omega(~X, {U, [G, EX]}). U)\nprocess AF = A mass (E) [G]\n\
      network EF || A[1]\ncheck EG : AG (X)");
    ("behaviour K = <A\xCC\x84,{f}>.nil", "behaviour K = <~A, {f}>. nil");
    ("process p = T mass 2*n + f(m[1]) [nil]", "process p = T mass (2*n + f(m[1])) [nil]");
    ("behaviour K = a + b + c", "behaviour K = (a + b) + c");
    ("behaviour K = eps(1). a + b", "behaviour K = (eps(1). a) + b");
    ("shape H = mesh \"a\\\"\\\\b\\c\"", "shape H = mesh \"a\\\"\\\\b\\\\c\"");
  ]

(* Every construct once. *)
let whole =
  {|model m
param n = 1/4
timestep n
split_step n/2
dynamics free_body
resolution 2^-20
round orientation 1/1048576
round velocity 2^-3
shape S { vertices a (0, 0, 1) faces f [a, b, c] }
shape T = S scaled (1, 2, 3) scaled (2, 2, 2)
shape U1 = mesh "x.obj"
compound C { part a : S mass 1 velocity (0, 0, 0) spin (0, 0, 0) at scale (1, 1, 1)
  part b : T glue a.f ~ b.[x, y] }
behaviour K on S = nil + <a, {f, [x, y], p.[x, q.y]}>. K
behaviour L = rho({}). eps(1). (nil + omega(~a, {}). nil)
process p = S mass 1 at matrix ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)) [K]
process q[1, n] = x[1] : S [nil] <bond, {x[1].f, y.f}> y : S [nil]
fixed w = S
fixed v = x : S [K] <a, {x.f, y.f}> y : T
bond <mass, {p.f, q[1, 2].x.f}>
for i in 1..n, j in i..2*n { for k in 0..1 { motion p[i] = inertial } }
network nil
network p || q[1, 2]
motion inertial
motion (vx, vy, if z > 0 then vz - 10*dt else round(vz, 1/8))
motion diffuse(1/8, (0, 0, -1))
motion p = choose { (1, 0, 0) weight 2, (0, 1, 0) }
let x = bonds(bond, p, q) >= 1 and quiescent => momentum.x != 0
check y : E[true U[1, 2] not false] or EX AF[<= 3] bound(p, q)
|}

let spans () =
  let text = "/* */ process p = /* */ Cube mass 3 /* */ [nil + K] // end" in
  let part (s : Span.t) = String.sub text s.start (s.stop - s.start) in
  match parsed text with
  | [ ({ it = Process (name, leaf, []); _ } as item) ] ->
    Alcotest.(check string) "item" "process p = /* */ Cube mass 3 /* */ [nil + K]" (part item.at);
    Alcotest.(check string) "name" "p" (part name.name.at);
    Alcotest.(check string) "leaf" "Cube mass 3 /* */ [nil + K]" (part leaf.leaf_span);
    Alcotest.(check string) "solid" "Cube" (part leaf.solid.at);
    Alcotest.(check (list string)) "attributes" [ "mass 3" ]
      (List.map (fun (a : Ast.attribute) -> part a.at) leaf.attributes);
    Alcotest.(check string) "behaviour" "nil + K"
      (match leaf.behaviour with Some b -> part b.at | None -> "")
  | _ -> Alcotest.fail "one process"

let formatted text =
  match Parse.with_trivia (source text) with
  | Ok (m, trivia) -> Printer.model ~trivia m
  | Error ds -> Alcotest.fail (rendered text ds)

let unformatted =
  {|

// A dimer.

model   dimer // optional


/* own */ param n=4
shape Cube{ // unit
  vertices a(-1,-1,-1) b (1,-1,-1) // two
    c (1,1,-1)
  faces f[a,b,c]
}
behaviour K on Cube = <a,{f}>.(nil+K) // first
 + ε(1)·nil
process p = Cube mass 3 velocity (1,0,0) spin (0,0,0) at translate (2,3,1)*rotate quaternion (1,0,0,1) [K]
for i in 1..n { process c[i] = Cube mass (m[i]) [K] }

for i in 1..n {
  // why
  bond <a,{c[i].f,c[i+1].f}>

  let x = (1+2)*-3 }
// end|}

let canonical =
  {|// A dimer.

model dimer // optional

/* own */
param n = 4
shape Cube { // unit
  vertices a (-1, -1, -1)  b (1, -1, -1) // two
           c (1, 1, -1)
  faces    f [a, b, c]
}
behaviour K on Cube =
  <a, {f}>. (nil + K) // first
  + eps(1). nil
process p = Cube mass 3 velocity (1, 0, 0) spin (0, 0, 0)
  at translate (2, 3, 1) * rotate quaternion (1, 0, 0, 1) [K]
for i in 1..n { process c[i] = Cube mass (m[i]) [K] }

for i in 1..n {
  // why
  bond <a, {c[i].f, c[i + 1].f}>

  let x = (1 + 2)*-3
}
// end
|}

let format () =
  Alcotest.(check string) "formatted" canonical (formatted unformatted);
  Alcotest.(check string) "again" canonical (formatted canonical)

let whole_language () =
  let m = parsed whole in
  Alcotest.(check bool) "printed and read" true (Ast_equal.model m (parsed (Printer.model m)))

let numbers () =
  let check text expected = Alcotest.(check string) text expected (Printer.expr (parsed_expr text)) in
  List.iter (fun (t, e) -> check t e)
    [ ("0", "0"); ("0.0", "0"); ("00.50", "0.5"); ("120", "120"); ("1e30", "1e30"); ("12e-30", "12e-30");
      ("1.25", "1.25"); ("0.001", "0.001"); ("100000", "100000") ]

(* The printer is also asked for numbers that no text holds. *)
let foreign_numbers () =
  let number q = { Ast.it = Ast.Number q; at = Span.none } in
  let check expected e = Alcotest.(check string) expected expected (Printer.expr e) in
  let times a b = { Ast.it = Ast.Binary (Mul, a, b); at = Span.none } in
  check "1/3" (number (Q.of_ints 1 3));
  check "-0.25" (number (Q.of_ints (-1) 4));
  check "2*(1/3)" (times (number (Q.of_int 2)) (number (Q.of_ints 1 3)))

let each name law cases = List.map (fun (a, b) -> Alcotest.test_case (name ^ a) `Quick (law (a, b))) cases

let suite =
  ("syntax reading",
   [
     ("precedence", each "" same_expr precedence @ each "not " distinct_expr distinct);
     ("notations", each "" same_model notations);
     ("whole",
      [
        Alcotest.test_case "every construct" `Quick whole_language;
        Alcotest.test_case "places in the text" `Quick spans;
        Alcotest.test_case "formatting" `Quick format;
        Alcotest.test_case "numbers" `Quick numbers;
        Alcotest.test_case "numbers that no text holds" `Quick foreign_numbers;
      ]);
   ])
