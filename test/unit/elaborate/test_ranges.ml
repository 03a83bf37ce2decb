(* Parameters of which ranges are known: what depends on them, and where they cannot be. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_elaborate
open Models
open Fault_case

let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let ranges = "param x in [0, 6] param y in (-1/2, 1/2] param w in (1, 2) "

let form_text (t : Elaborate.t) f = Text.form ~name:(fun i -> t.model.ranges.(i).name) f

let place_text t (x, y, z) = String.concat ", " (List.map (form_text t) [ x; y; z ])

let uncertain (t : Elaborate.t) =
  match t.uncertain with Some u -> u | None -> Alcotest.fail "nothing is uncertain"

(* {1 Places} *)

let place (transform, expected) =
  Alcotest.test_case transform `Quick (fun () ->
      let t = accept (cube ^ ranges ^ "let v = (x, 2*y, 1) process p = Cube mass 1 at " ^ transform ^ " [nil]") in
      Alcotest.(check string) "place" expected (place_text t (uncertain t).places.(0)))

let places =
  [
    ("translate (0, 0, 3)", "0, 0, 3");
    ("translate (x, y + 1/2, 2*y - x/3 + 1)", "x, y + 1/2, -1/3 x + 2y + 1");
    ("translate (v + v.x*(0, 1, 0))", "x, x + 2y, 1");
    ("translate v * translate (1, -x, 0)", "x + 1, -x + 2y, 1");
    ("rotate quaternion (1, 0, 0, 1) * translate v", "-2y, x, 1");
    ("scale (2, 1, 1) * translate (x, 0, y)", "2x, 0, y");
    ("translate ((x - x)*1000 + 7, min(3, 4)*w, -(x + w) + x)", "7, 3w, -w");
    ("translate (if x - x = 0 and x < x + 1 then y else w, dot((1, 2, 3), v), 0)", "y, x + 4y + 3, 0");
  ]

let several () =
  let t =
    accept
      (cube ^ corner ^ "param n = 2 param x in [0, 6] let shift = x/2 + n \
                        for i in 1..n { process p[i] = Cube mass 1 at translate (i*x, 10*i, shift) [nil] } \
                        process c = Corner at translate (0, 100, x) [nil]")
  in
  let u = uncertain t in
  Alcotest.(check (list string)) "in a loop, and of a compound"
    [ "x, 10, 1/2 x + 2"; "2x, 20, 1/2 x + 2"; "0, 100, x" ]
    (List.map (place_text t) (Array.to_list u.places));
  Alcotest.(check string) "the ranges" "x in [0, 6]" (Ranges.to_string t.model.ranges);
  Alcotest.(check (list string)) "what is known is listed" [ "n" ] (List.map fst t.parameters);
  let at leaf = (State.leaf_of (Option.get (State.home t.declared leaf)) leaf).position in
  let point = Ranges.point t.model.ranges in
  let two = q 2 1 in
  let there = Vec.make (Rat.mul two point.(0)) (q 20 1) (Rat.add two (Rat.div point.(0) two)) in
  Alcotest.(check string) "declared at a point of them" (Vec.to_string there) (Vec.to_string (at 1))

(* Parts of a compound, in the frame of the body: those that are where the text says depend on nothing. *)
let parts () =
  let t =
    accept
      (cube
       ^ "param x in [0, 1] param y in [0, 1] compound C { part a : Cube mass 1 at translate (x, 0, 0) part b : \
          Cube mass 1 at translate (2 + x, y, 0) part c : Cube mass 1 at translate (2 + x, y, 2) glue a.right ~ \
          b.left glue b.top ~ c.bottom } process p = C at translate (x, 9, 9) * rotate quaternion (1, 0, 0, 1) \
          [nil] process q = Cube mass 1 at translate (50, 0, 0) [nil]")
  in
  let offset (p : Model.part) = match p.open_offset with None -> "known" | Some place -> place_text t place in
  let of_leaf i = List.map offset (Array.to_list t.model.leaves.(i).parts) in
  Alcotest.(check (list string)) "turned as the body is" [ "0, x, 0"; "-y, x + 2, 0"; "-y, x + 2, 2" ] (of_leaf 0);
  Alcotest.(check (list string)) "of a body that is none" [ "known" ] (of_leaf 1);
  match (uncertain t).glues with
  | [ { leaf; one; two } ] ->
    Alcotest.(check (list int)) "one glue is between parts that move against each other" [ 0; 0; 1 ]
      [ leaf; one.part; two.part ]
  | glues -> Alcotest.failf "%d glues" (List.length glues)

let known () =  let t = accept (cube ^ "param x in [2, 2] process p = Cube mass x velocity (x, 0, 0) [nil]") in
  Alcotest.(check bool) "of one number" true (t.uncertain = None);
  let values = List.map (fun (_, v) -> Rat.to_string v) t.parameters in
  Alcotest.(check (list string)) "it is a parameter" [ "2" ] values;
  let text = cube ^ ranges ^ "process p = Cube mass 1 at translate (x, y, w) [eps(x). nil]" in
  let t = accept ~overrides:[ ("x", q 6 1); ("y", q 1 2); ("w", q 3 2) ] text in
  Alcotest.(check bool) "all are given" true (t.uncertain = None);
  Alcotest.(check string) "the place" "(6, 1/2, 3/2)" (Vec.to_string t.declared.processes.(0).leaves.(0).position);
  match t.declared.processes.(0).leaves.(0).behaviour.term with
  | Delay (d, Nil) -> Alcotest.(check string) "the delay" "6" (Rat.to_string d)
  | _ -> Alcotest.fail "a delay"

(* {1 Delays} *)

let delays () =
  let t =
    accept
      (cube ^ ranges
       ^ "behaviour W(t) on Cube = eps(t + 1). V where s = t/2 \
          behaviour V on Cube = eps(w). eps(x - x). V \
          process p = Cube mass 1 [W(2*x + w)] \
          process r = Cube mass 1 at translate (10, 0, 0) [W(2*x + w)]")
  in
  let rec text (b : Behaviour.t) =
    match b with
    | Nil -> "nil"
    | Wait (f, b) -> Printf.sprintf "wait(%s). %s" (form_text t f) (text b)
    | Delay (d, b) -> Printf.sprintf "eps(%s). %s" (Rat.to_string d) (text b)
    | Call k -> t.model.definitions.(k).name
    | Open _ | Weak _ | Strong _ | Sum _ -> "?"
  in
  Alcotest.(check (list string)) "definitions" [ "W(2x + w): wait(2x + w + 1). V"; "V: wait(w). V" ]
    (Array.to_list (Array.map (fun (d : Behaviour.definition) -> d.name ^ ": " ^ text d.body) t.model.definitions))

(* {1 Formulas} *)

let formulas () =
  let t =
    accept
      (cube ^ ranges ^ "let near = abs(y) < x/2 + 1 process p = Cube mass 1 at translate (x, 0, 0) [nil] \
                        check c : always near and x(p) - 2*w <= x")
  in
  match t.checks with
  | [ { formula; _ } ] ->
    Alcotest.(check string) "by their names"
      "AG ((if y >= 0 then y else -y) < ((x / 2) + 1) and (x(p) - (2 * w)) <= x)"
      (Scc_property.Show.temporal t.model formula)
  | _ -> Alcotest.fail "one check"

(* {1 Against values} *)

module Gen = QCheck2.Gen

(* Expressions that are linear in x, y and w, as text. *)
let linear =
  let open Gen in
  let number = map2 (fun n d -> Printf.sprintf "(%d/%d)" n d) (int_range (-9) 9) (int_range 1 7) in
  let constant = oneof [ number; map2 (fun a b -> Printf.sprintf "max(%s, %s)" a b) number number ] in
  let not_zero = map2 (fun n d -> Printf.sprintf "(%d/%d)" n d) (int_range 1 9) (int_range 1 7) in
  sized_size (int_range 0 5)
    (fix (fun self n ->
         if n = 0 then oneof [ number; oneofl [ "x"; "y"; "w"; "v" ] ]
         else
           let sub = self (n / 2) in
           oneof
             [
               map2 (fun a b -> Printf.sprintf "(%s + %s)" a b) sub sub;
               map2 (fun a b -> Printf.sprintf "(%s - %s)" a b) sub sub;
               map2 (fun k a -> Printf.sprintf "%s*%s" k a) constant sub;
               map2 (fun a k -> Printf.sprintf "%s/%s" a k) sub not_zero;
               map (fun a -> Printf.sprintf "(-%s)" a) sub;
               map2 (fun a b -> Printf.sprintf "dot((%s, 1, 0), (2, %s, 5))" a b) sub sub;
             ]))

let at_values =
  QCheck2.Test.make ~name:"forms are worth at a point what the expressions are" ~count:150
    ~print:(fun ((a, b, c), _) -> String.concat "; " [ a; b; c ])
    Gen.(pair (triple linear linear linear) (triple (int_range 0 24) (int_range 0 3) (int_range 1 6)))
    (fun ((a, b, c), (i, j, k)) ->
       let place = Printf.sprintf "translate (%s, %s, %s)" a b c in
       let text =
         cube ^ ranges
         ^ Printf.sprintf
           "let v = x/2 - y process p = Cube mass 1 at rotate quaternion (1, 1, 0, 0) * %s [nil]" place
       in
       let point = [| q i 4; q (j - 1) 4; Rat.add Rat.one (q k 7) |] in
       let names = [ "x"; "y"; "w" ] in
       let overrides = List.mapi (fun i name -> (name, point.(i))) names in
       let fixed = accept ~overrides text in
       let x, y, z = (uncertain (accept text)).places.(0) in
       let worth = Vec.make (Linear.eval x point) (Linear.eval y point) (Linear.eval z point) in
       Vec.equal worth fixed.declared.processes.(0).leaves.(0).position)

(* What is told of a form at the corners of the box, by polyhedra. *)
let as_of_polyhedra =
  let gen =
    Gen.(
      let bound = pair (int_range (-2) 2) bool in
      let range = triple bound (int_range 1 2) bool in
      triple (list_size (int_range 1 3) range) (list_repeat 3 (int_range (-2) 2)) (int_range (-6) 6))
  in
  QCheck2.Test.make ~name:"signs of forms are those that polyhedra tell" ~count:1000 gen
    (fun (all, factors, rest) ->
       let range i ((low, low_included), length, high_included) : Ranges.range =
         {
           name = Printf.sprintf "p%d" i;
           low = { value = Rat.of_int low; included = low_included };
           high = { value = Rat.of_int (low + length); included = high_included };
         }
       in
       let ranges = Array.of_list (List.mapi range all) in
       let n = Array.length ranges in
       let terms = List.filteri (fun i _ -> i < n) (List.mapi (fun i a -> (i, Rat.of_int a)) factors) in
       let form = Linear.of_terms n ~constant:(Rat.of_int rest) terms and zero = Linear.constant n Rat.zero in
       let some constraint_ = not (Polyhedron.is_empty (Polyhedron.add (Ranges.box ranges) constraint_)) in
       Bool.equal (Ranges.may_be_zero ranges form) (some (Constraint.equals form zero))
       &&
       match Ranges.negative ranges form with
       | None -> not (some (Constraint.less form zero))
       | Some named ->
         (* Those that it does not depend on are not named, and do not matter. *)
         let value i (r : Ranges.range) = Option.value (List.assoc_opt r.name named) ~default:(Rat.of_int i) in
         let point = Array.mapi value ranges in
         let within i r = Ranges.mem r point.(i) || not (List.mem_assoc (Ranges.name ranges i) named) in
         Rat.sign (Linear.eval form point) < 0 && List.for_all Fun.id (Array.to_list (Array.mapi within ranges)))

(* {1 Extremes} *)

let many () =
  let name i = Printf.sprintf "a%d" i in
  let declare i = Printf.sprintf "param %s in [0, 1e-300] " (name i) in
  let indices = List.init 100 Fun.id in
  let sum = String.concat " + " (List.map name indices) in
  let t =
    accept
      (cube ^ String.concat "" (List.map declare indices) ^ "behaviour B on Cube = eps(1 - (" ^ sum ^ ")). B "
       ^ "process p = Cube mass 1 at translate (" ^ sum ^ ", 0, 0) [B]")
  in
  Alcotest.(check int) "a hundred parameters" 100 (Array.length t.model.ranges);
  let x, _, _ = (uncertain t).places.(0) in
  Alcotest.(check bool) "each counts" true (Array.for_all (Rat.equal Rat.one) x.coefficients);
  Alcotest.(check bool) "a point of a range of 10^-300" true
    (Array.for_all2 Ranges.mem t.model.ranges (Ranges.point t.model.ranges))

(* {1 What is given} *)

let given narrowed overrides =
  let text = cube ^ ranges ^ "param n = 1 process p = Cube mass 1 at translate (x + y + w, n, 0) [nil]" in
  match Scc_syntax.Parse.parse (Scc_base.Source.make ~name:"test.sc" text) with
  | Error _ -> Alcotest.fail "the text"
  | Ok model -> Elaborate.elaborate ~read_file:no_files ~overrides ~narrowed model

let bound value included = { Ranges.value; included }

let narrowed () =
  (match given [ ("x", (bound (q 1 1) true, bound (q 6 1) false)) ] [ ("w", q 3 2) ] with
   | Ok t ->
     let ranges = Ranges.to_string t.model.ranges in
     Alcotest.(check string) "narrowed, and fixed" "x in [1, 6), y in (-1/2, 1/2]" ranges
   | Error _ -> Alcotest.fail "it is within");
  let refused what narrowed overrides =
    match given narrowed overrides with
    | Ok _ -> Alcotest.failf "%s is accepted" what
    | Error (d :: _) -> Alcotest.(check string) what "SC0217" d.code
    | Error [] -> Alcotest.fail "no diagnostic"
  in
  refused "a greater end" [ ("x", (bound (q 1 1) true, bound (q 7 1) true)) ] [];
  refused "an end that is left out" [ ("y", (bound (q (-1) 2) true, bound (q 0 1) true)) ] [];
  refused "no number" [ ("x", (bound (q 3 1) true, bound (q 3 1) false)) ] [];
  refused "inverted" [ ("x", (bound (q 3 1) true, bound (q 2 1) true)) ] [];
  refused "a value beyond" [] [ ("x", q 7 1) ];
  refused "the open end" [] [ ("y", q (-1) 2) ];
  let from_1_to_3 = ("x", (bound (q 1 1) true, bound (q 3 1) false)) in
  refused "a value beyond what it is narrowed to" [ from_1_to_3 ] [ ("x", q 4 1) ];
  refused "the end that is left out of that" [ from_1_to_3 ] [ ("x", q 3 1) ];
  (match given [ from_1_to_3 ] [ ("x", q 2 1) ] with
   | Ok t ->
     let ranges = Ranges.to_string t.model.ranges in
     Alcotest.(check string) "a value of what it is narrowed to" "y in (-1/2, 1/2], w in (1, 2)" ranges
   | Error _ -> Alcotest.fail "it is within");
  refused "a range for a number" [ ("n", (bound (q 0 1) true, bound (q 2 1) true)) ] [];
  match given [ ("x", (bound (q 3 1) true, bound (q 3 1) true)) ] [] with
  | Ok t -> Alcotest.(check int) "to one number" 2 (Array.length t.model.ranges)
  | Error _ -> Alcotest.fail "it has a number"

(* {1 Faults} *)

let body text = ranges ^ "let v = 2*x " ^ text
let body_with attributes = body ("process p = Cube " ^ attributes ^ " [nil]")

let linear_alone =
  let case name at ~says text = case name "SC0218" at ~says (cube ^ text) in
  let product = "a product of two" and branch = "which of the two" in
  [
    case "a mass" "x" ~says:"impulses" (body_with "mass x");
    case "a velocity, by a `let`" "x" ~says:"times at which bodies meet" (body_with "mass 1 velocity (v, 0, 0)");
    case "a spin" "x" ~says:"times at which bodies meet" (body_with "mass 1 spin (0, 0, x)");
    case "a rotation" "x" ~says:"turned" (body_with "mass 1 at rotate quaternion (x, 0, 0, 1)");
    case "a scaling" "x" ~says:"shapes" (body_with "mass 1 at scale (x, 1, 1)");
    case "a matrix" "x" ~says:"`translate`"
      (body_with "mass 1 at matrix((1,0,0,x), (0,1,0,0), (0,0,1,0), (0,0,0,1))");
    case "a scaled shape" "x" ~says:"shapes" (body "shape B = Cube scaled (x, 1, 1) process p = B mass 1 [nil]");
    case "a box" "box" ~says:"shapes" (body "shape B = box(1, x, 1) process p = B mass 1 [nil]");
    case "a corner" "x" ~says:"shapes"
      (body "shape B = hull { a (0,0,0) b (x,0,0) c (0,1,0) d (0,0,1) } process p = B mass 1 [nil]");
    case "a bound of a loop" "x" ~says:"declared" (body "for i in 1..x { process p = Cube mass 1 [nil] }");
    case "a filter of a loop" "w" ~says:"declared"
      (body "for i in 1..2 if i < w { process p[i] = Cube mass 1 at translate (9*i, 0, 0) [nil] }");
    case "an index" "x" ~says:"names" (body "process p[x] = Cube mass 1 [nil]");
    case "a product" "x*w" ~says:product (body_with "mass 1 at translate (x*w, 0, 0)");
    case "a square in a dot" "dot((x, 1, 1), (w, 1, 1))" ~says:product
      (body_with "mass 1 at translate (dot((x, 1, 1), (w, 1, 1)), 0, 0)");
    case "a quotient" "1/x" ~says:"a quotient" (body_with "mass 1 at translate (1/x, 0, 0)");
    case "a minimum" "min(x, w)" ~says:branch (body_with "mass 1 at translate (min(x, w), 0, 0)");
    case "an absolute value" "abs(x)" ~says:branch (body_with "mass 1 at translate (abs(x), 0, 0)");
    case "a condition" "x < 3" ~says:branch (body_with "mass 1 at translate (if x < 3 then 1 else 2, 0, 0)");
    case "a condition of vectors" "x = 3 and w > 1" ~says:branch
      (body_with "mass 1 at translate (if x = 3 and w > 1 then (1, 0, 0) else (2, 0, 0))");
    case "floor" "floor(x)" ~says:"`floor`" (body_with "mass 1 at translate (floor(x), 0, 0)");
    case "mod" "x mod 2" ~says:"`mod`" (body_with "mass 1 at translate (x mod 2, 0, 0)");
    case "round" "round(x, 1)" ~says:"`round`" (body_with "mass 1 at translate (round(x, 1), 0, 0)");
    case "a push" "x" ~says:"velocities"
      (body "behaviour B on Cube = omega(a, {top}) push(x). nil process p = Cube mass 1 [B]");
    case "an end of another range" "x" ~says:"ends" (body "param u in [0, x]" ^ "process p = Cube mass 1 [nil]");
    case "another parameter" "x" ~says:"constant" (body "param u = x + 1" ^ "process p = Cube mass u [nil]");
    case "the timestep" "x" ~says:"constant" (body "timestep x");
    case "the split step" "x" ~says:"constant" (body "split_step x");
    case "a law" "x" ~says:"are numbers" (ranges ^ "process p = Cube mass 1 [nil] motion p = (x, 0, 0)");
    case "a bound of time" "x" ~says:"constant" (body_with "mass 1" ^ " check c : always x(p) < 1 within x");
    case "a vector as an argument" "(x, 0, 0)" ~says:"a number"
      (body "behaviour B(u) on Cube = eps(u.x). nil process p = Cube mass 1 [B((x, 0, 0))]");
  ]

let others =
  [
    case "an end that is left out" "SC0217" "1, 1" ~says:"do not both" "param x in (1, 1]";
    case "an inverted range" "SC0217" "3, 1" ~says:"the greater one" "param x in [3, 1]";
    case "a delay that is negative for some" "SC0502" "x + y - 1/4" ~says:"for x = "
      (cube ^ body "behaviour B on Cube = eps(x + y - 1/4). nil process p = Cube mass 1 [B]");
    case "a delay that is negative close to an end" "SC0502" "1 - w" ~says:"w = 3/2"
      (cube ^ body "process p = Cube mass 1 [eps(1 - w). nil]");
    case "a delay that may be 0 guards nothing" "SC0501" "B"
      (cube ^ body "behaviour B on Cube = eps(x). B process p = Cube mass 1 [B]");
    case "a name twice" "SC0202" "x" (ranges ^ "param x in [0, 1]");
    case "one that nothing uses" "SC0211" "u" (cube ^ "param u in [0, 1] process p = Cube mass 1 [nil]");
  ]

(* An end that is left out is not reached: the delay is positive for all values. *)
let guarded () =
  ignore (accept (cube ^ ranges ^ "behaviour B on Cube = eps(w - 1). B process p = Cube mass 1 [B]"))

let unused () =
  ignore
    (accept
       (cube ^ ranges ^ "let far = (2*x, y, 0) process p = Cube mass 1 at translate (w, 0, 0) [nil]"))

let apart () =
  let text = ranges ^ "process p = Cube mass 1 [nil] process r = Cube mass 1 at translate " in
  ignore (accept (cube ^ text ^ "(x, 0, 0) [nil]"));
  check (case "bodies that stand" "SC0403" "r" (cube ^ text ^ "(1, 0, 0) [nil]")) ()

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("ranges",
   [
     ("places", List.map place places);
     ( "what depends on them",
       [
         case "places of several bodies" several;
         case "parts of compounds" parts;
         case "what is known" known;
         case "delays" delays;
         case "formulas" formulas;
         case "a hundred, of 10^-300" many;
         case "an end that is left out guards" guarded;
         case "a `let` that nothing uses" unused;
         case "overlaps of what stands" apart;
         case "values and narrower ranges" narrowed;
       ] );
     ("against values", Scc_test_support.Property.cases [ at_values; as_of_polyhedra ]);
     ("where they cannot be", cases linear_alone);
     ("other faults", cases others);
   ])
