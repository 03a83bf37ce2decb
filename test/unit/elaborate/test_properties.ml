(* What elaboration makes of the checks of models that are in order. *)

open Scc_property
open Models

let strings = Alcotest.(list string)

let printed text =
  let t = accept text in
  List.map (fun (k : Property.check) -> Show.temporal t.model k.formula) t.checks

let body =
  cube
  ^ "process p = Cube mass 1 [<a, {top}>. nil] process q = Cube scaled (1,1,2) mass 1 \
     at translate (9,0,0) [nil] shape B = Cube process r = B mass 1 at translate (20,0,0) [nil]\n\
     for i in 1..2 { process c[i] = B mass 1 at translate (4*i, 9, 0) [nil] }\n"

let property name written expected =
  let run () = Alcotest.(check strings) written [ expected ] (printed (body ^ "check k : " ^ written)) in
  Alcotest.test_case name `Quick run

let properties =
  [
    property "possibly" "possibly x(p) > 1/2" "EF x(p) > 1/2";
    property "always within" "always vx(p) <= 0.5 within 10" "AG[<= 10] vx(p) <= 1/2";
    property "eventually" "eventually size(p) != 1" "AF size(p) != 1";
    property "interval" "EF[1, 3/2] touching(p, q)" "EF[1, 3/2] touching(p, q)";
    property "until" "A[ not bound(p, q) U[<= 5] E[ same(p, q) U quiescent ] ]"
      "A[ not bound(p, q) U[<= 5] E[ same(p, q) U quiescent ] ]";
    property "decided by a constant" "true or EF x(p) = 1" "true";
    property "decided by no one" "forall b in c: AG false" "AG false and AG false";
    property "next" "EX AX processes = 2" "EX AX processes = 2";
    property "events" "always event bind or event weak(a) or event strong(a, p) or event split(a, q, p)"
      "AG (((event bind or event weak(a)) or event strong(a, p)) or event split(a, q, p))";
    property "bounces" "A[ not event bounce(p, q) U event bounce(p) ] and AX event bounce"
      "A[ not event bounce(p, q) U event bounce(p) ] and AX event bounce";
    property "hits" "always not event hit(p, q) and not event hit(q)"
      "AG (not event hit(p, q) and not event hit(q))";
    property "events of a family" "possibly exists s in c: event bounce(s)"
      "EF (event bounce(c[1]) or event bounce(c[2]))";
    property "leads_to" "x(p) > 0 leads_to y(p) > 0"
      "AG (x(p) > 0 => AF y(p) > 0)";
    property "leads_to within" "x(p) > 0 leads_to EG y(p) > 0 within 3"
      "AG (x(p) > 0 => AF[<= 3] EG y(p) > 0)";
    property "leads_to in an interval" "forall s in c: AX x(s) > 0 leads_to[1, 3/2] false"
      "AG (AX x(c[1]) > 0 => AF[1, 3/2] false) and AG (AX x(c[2]) > 0 => AF[1, 3/2] false)";
    property "a temporal condition" "if AF x(p) > 0 then EG y(p) > 0 else z(p) = 0"
      "AF x(p) > 0 and EG y(p) > 0 or not AF x(p) > 0 and z(p) = 0";
    property "numbers" "always speed2(p) + distance2(p, q)*energy - time/2 >= -momentum.y"
      "AG ((speed2(p) + (distance2(p, q) * energy)) - (time / 2)) >= -momentum.y";
    property "bonds" "always bonds(a) + bonds(a, p, q) + bonds() = 0"
      "AG ((bonds(a) + bonds(a, p, q)) + bonds()) = 0";
    property "offers" "always offers(p, a) or offers(p, ~a)" "AG (offers(p, a) or offers(p, ~a))";
    property "indexed" "always y(c[1 + 1]) = 0" "AG y(c[2]) = 0";
    property "a template" "always forall s in Cube: z(s) = 0" "AG (z(p) = 0 and z(q) = 0)";
    property "an image of it" "always exists s in B: z(s) = 0" "AG (z(r) = 0 or z(c[1]) = 0 or z(c[2]) = 0)";
    property "a family" "always count(s in c: z(s) > 0) = 2" "AG count(z(c[1]) > 0, z(c[2]) > 0) = 2";
    property "a quantified formula" "forall s in c: possibly z(s) > 0" "EF z(c[1]) > 0 and EF z(c[2]) > 0";
    property "a variable hides a process" "always forall q in c: distance2(p, q) > 0"
      "AG (distance2(p, c[1]) > 0 and distance2(p, c[2]) > 0)";
    property "mixed" "(x(p) = 0 => possibly x(p) > 1) and not always true"
      "(x(p) = 0 => EF x(p) > 1) and not AG true";
    property "conditional" "always (if x(p) > 0 then vx(p) else 1) > 0" "AG (if x(p) > 0 then vx(p) else 1) > 0";
    property "folding" "always (2 > 1 and x(p) + (1 + 2) = 0 or false)" "AG (x(p) + 3) = 0";
  ]

let lets () =
  Alcotest.(check strings) "let"
    [ "EF bonds(a) >= 1"; "AG (bonds(a) >= 1 => EF x(p) = 3)" ]
    (printed
       (body
        ^ "let n = 3 let glued = bonds(a) >= 1 let far = possibly x(p) = n\n\
           check one : possibly glued check two : always not glued or far"))

(* What a law may read is right, used or not; and so is what a formula may say. *)
let unused_lets () =
  ignore
    (accept
       (body
        ^ "let a = vx + dt let b = round(time, 2) let c = if z > 0 then vz - dt else vz let d = time > 1\n\
           let e = forall s in c: possibly event bind(a, s) let f = behaviour(p) = K behaviour K = nil"))

let indexed_checks () =
  let t = accept (body ^ "for i in 1..2 { check far : always x(c[i]) <= i }") in
  Alcotest.(check strings) "names" [ "far[1]"; "far[2]" ] (List.map (fun (k : Property.check) -> k.name) t.checks);
  Alcotest.(check string) "text" "always x(c[1]) <= 1" (List.hd t.checks).text

let normal_form () =
  let t = accept (body ^ "check k : not ((possibly x(p) > 1) and AX not always y(p) = 0)") in
  Alcotest.(check string) "duals" "AG x(p) <= 1 or EX AG y(p) = 0"
    (Show.temporal t.model (Formula.negation_normal_form (List.hd t.checks).formula))

let case name run = Alcotest.test_case name `Quick run

let suite =
  ("properties",
   [
     ("texts", properties);
     ( "rest",
       [
         case "let" lets; case "lets that nothing uses" unused_lets; case "in loops" indexed_checks;
         case "normal form" normal_form;
       ] );
   ])
