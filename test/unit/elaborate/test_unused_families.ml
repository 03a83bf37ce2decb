(* Families that nothing uses are read without arguments, for the faults that do not depend on them. *)

open Scc_base
open Models
open Fault_case

let faults =
  let shape text = "shape S(a) = " ^ text ^ " process p = box(1, 1, 1) mass 1 [nil]" in
  let behaviour text = cube ^ "process p = Cube mass 1 [nil] behaviour " ^ text in
  [
    case "a name of a shape" "SC0201" "bix" ~says:"did you mean `box`" (shape "bix(a, 1, 1)");
    case "a number of lengths" "SC0206" "box" ~says:"three lengths" (shape "box(a, 1)");
    case "a name for a length" "SC0201" "box" ~says:"unknown name `b`" (shape "box(a, b, 1)");
    case "a name in a definition" "SC0201" "zz" (shape "box(a, h, 1) where h = min(a, zz)");
    case "a number of parameters" "SC0201" "S" ~says:"declared is `S(_)`" (shape "S(a, 2) shape T(a) = S(a, a)");
    case "a number of arguments" "SC0206" "abs(a, 1)" (shape "box(abs(a, 1), 1, 1)");
    case "a function" "SC0201" "foo" (shape "box(foo(a), 1, 1)");
    case "a component" "SC0201" "w" (shape "box(a) scaled (1, a.w, 2)");
    case "a value of another kind" "SC0205" "(1, 2, 3)"
      (shape "box(a + 1, a, 1) scaled (if a > 1 and (1, 2, 3) then 1 else a, 1, 1)");
    case "a vertex" "SC0203" "x"
      "shape S(a) { vertices p (a,0,0) q (0,a,0) r (0,0,a) s (0,0,0) faces f [p,q,x] } process p = box(1, 1, 1) \
       mass 1 [nil]";
    case "a part" "SC0203" "t" ~says:"no part"
      "compound C(n) { part l : box(n, 1, 1) mass 1 part r : box(n, 1, 1) mass n at translate (n, 0, 0) glue \
       l.right ~ t.left } process p = box(1, 1, 1) mass 1 [nil]";
    case "a part without a mass" "SC0208" "l" "compound C(n) { part l : box(n, 1, 1) } network nil";
    case "a name of a delay" "SC0201" "u" (behaviour "K(t) = eps(t + u). nil");
    case "a delay" "SC0502" "-1" (behaviour "K(t) = eps(-1). nil");
    case "a behaviour" "SC0201" "Foo" (behaviour "K(t) = eps(t). Foo");
    case "a number of indices" "SC0201" "K" ~says:"declared is `K[_]`" (behaviour "K[i] = eps(i). K[i, i]");
    case "indices for parameters" "SC0201" "K" ~says:"declared is `K(_)`" (behaviour "K(i) = eps(i). K[i]");
    case "a feature" "SC0203" "toop" ~says:"did you mean `top`"
      (behaviour "K(a, f) on Cube = <a, {f, toop}>. nil");
    case "a template" "SC0201" "Cup" (behaviour "K(a) on Cup = <a, {top}>. nil");
  ]

let accepted () =
  let t =
    accept
      ("import <solids> shape S(T, a) = T scaled (a, a, 1) shape U(a, b) = box(a, b, h) where h = min(a, b)/2 \
        shape V(v) = box(2*v) scaled (1, v.x, 1) shape W(a) = U(a, 2*a) shape X(a) = box(a) compound D(w, m) { \
        part l : U(w, 1) mass m part r : U(w, 1) mass 1 at translate (w, 0, 0) glue l.right ~ r.left } \
        behaviour L(a, f) = <a, {f}>. L(a, f) behaviour M(K) = eps(1). K + L(dock, top) \
        behaviour N(a, f, K) on Cube = <a, {f, top, [f, b]}>. omega(a, {f}) push(a). K + L(a, 1) \
        behaviour O(T, t) on T = eps(t). N(t, t, t) behaviour C[i] = eps(i). C[i - 1] + P[i] \
        behaviour C[0] = nil for i in 1..3 { behaviour P[i] = nil }" ^ cube ^ "process p = Cube mass 1 [nil]")
  in
  let unused (d : Diag.t) = String.equal d.code "SC0211" in
  Alcotest.(check (list string)) "no other warnings" []
    (List.map (fun (d : Diag.t) -> d.message) (List.filter (fun d -> not (unused d)) t.warnings))

let suite =
  ("families that nothing uses",
   [ ("accepted", [ Alcotest.test_case "without faults" `Quick accepted ]); ("faults", cases faults) ])
