(* Polyhedra by linear constraints: cases by hand. *)

open Scc_exact
open Scc_polyhedra

let q = Q.of_string
let name = function 0 -> "x" | 1 -> "y" | 2 -> "z" | 3 -> "w" | i -> Printf.sprintf "v%d" i

(* [system n [ ([ 1; -2 ], "<", 3) ]] is x - 2y < 3 *)
let constraint_ (normal, relation, right) =
  let a = Array.of_list (List.map Z.of_int normal) and b = Z.of_int right in
  let minus = Array.map Z.neg a in
  match relation with
  | "<" -> Constraint.make a Less b
  | "<=" -> Constraint.make a At_most b
  | "=" -> Constraint.make a Equal b
  | ">" -> Constraint.make minus Less (Z.neg b)
  | ">=" -> Constraint.make minus At_most (Z.neg b)
  | _ -> invalid_arg relation

let system n constraints = Polyhedron.of_constraints n (List.map constraint_ constraints)
let text = Text.polyhedron ~name
let is what expected p = Alcotest.(check string) what expected (text p)
let yes = Alcotest.(check bool)
let volume_of_union u = Volume.sum (List.map Volume.of_polyhedron (Union.pieces (Union.disjoint u)))

let volume_text = function
  | Volume.Finite x -> Some (Rat.to_string x)
  | Infinite -> None
  | Not_computed -> Some "not computed"

let volume what expected p =
  Alcotest.(check (option string)) what expected (volume_text (Volume.of_polyhedron p))

let triangle = system 2 [ ([ 1; 0 ], ">=", 0); ([ 0; 1 ], ">=", 0); ([ 1; 1 ], "<=", 1) ]
let square low high = Polyhedron.box [| (q low, q high); (q low, q high) |]

let emptiness () =
  let empty what constraints =
    let p = system 1 (List.map (fun (a, relation, b) -> ([ a ], relation, b)) constraints) in
    yes what true (Polyhedron.is_empty p)
  in
  empty "x < 0 < x" [ (1, "<", 0); (1, ">", 0) ];
  empty "x < 0 <= x" [ (1, "<", 0); (1, ">=", 0) ];
  empty "x = 1 < x" [ (1, "=", 1); (1, ">", 1) ];
  empty "0 < 0" [ (0, "<", 0) ];
  is "x <= 0 <= x" "x = 0" (system 1 [ ([ 1 ], "<=", 0); ([ 1 ], ">=", 0) ]);
  is "of nothing" "false" (Polyhedron.empty 2);
  is "of everything" "true" (Polyhedron.universe 2);
  is "a cycle" "false" (system 3 [ ([ 1; -1; 0 ], "<=", 0); ([ 0; 1; -1 ], "<=", 0); ([ -1; 0; 1 ], "<", 0) ])

let minimal_forms () =
  is "implicit equalities" "x = z, y = z"
    (system 3 [ ([ 1; -1; 0 ], "<=", 0); ([ 0; 1; -1 ], "<=", 0); ([ -1; 0; 1 ], "<=", 0) ]);
  is "redundant ones" "x >= 0, y >= 0, x + y <= 1" (Polyhedron.add triangle (constraint_ ([ 1; 0 ], "<=", 1)));
  is "the strict of two" "x < 1" (system 1 [ ([ 1 ], "<=", 1); ([ 1 ], "<", 1); ([ 2 ], "<", 3) ]);
  let p = system 2 [ ([ 1; 0 ], ">=", 0); ([ 0; 1 ], ">=", 0); ([ 1; 1 ], ">", 0) ] in
  let p' = system 2 [ ([ 1; 0 ], ">=", 0); ([ 0; 1 ], ">=", 0); ([ 1; 2 ], ">", 0) ] in
  yes "one set, two forms" true (Polyhedron.equal p p' && text p <> text p');
  let closure p = Polyhedron.constraints (Polyhedron.closure p) in
  Alcotest.(check bool) "one closure" true (List.equal Constraint.equal (closure p) (closure p'))

let projections () =
  let p = system 2 [ ([ 1; -1 ], "<", 0); ([ 0; 1 ], "<=", 3); ([ 1; 1 ], ">=", 0) ] in
  is "strict if either is" "x >= -3, x < 3" (Polyhedron.project p [| 0 |]);
  is "the other one" "x > 0, x <= 3" (Polyhedron.project p [| 1 |]);
  is "swapped" (text triangle) (Polyhedron.project triangle [| 1; 0 |]);
  let sum = Linear.add (Linear.variable 2 0) (Linear.variable 2 1) in
  is "image" "x >= 0, x <= 1" (Polyhedron.image triangle [| sum |]);
  is "preimage" "x >= 0, x <= 1/2"
    (Polyhedron.preimage triangle ~dimension:1 [| Linear.variable 1 0; Linear.variable 1 0 |])

let points () =
  let point p = Option.map (fun a -> List.map Rat.to_string (Array.to_list a)) (Polyhedron.interior_point p) in
  let simple = Alcotest.(check (option (list string))) in
  simple "of a triangle" (Some [ "1/2"; "1/3" ]) (point triangle);
  simple "of a half-line" (Some [ "4" ]) (point (system 1 [ ([ 1 ], ">", 3) ]));
  simple "on a line" (Some [ "0"; "-2" ]) (point (system 2 [ ([ 1; -1 ], "=", 2) ]));
  simple "nowhere" None (point (Polyhedron.empty 1));
  let bound p f = match Polyhedron.supremum p f with
    | Some (Bound { value; attained }) -> Rat.to_string value ^ if attained then "" else ", never"
    | Some Unbounded -> "none"
    | None -> "empty"
  in
  let x = Linear.variable 2 0 in
  Alcotest.(check string) "attained" "1" (bound triangle x);
  Alcotest.(check string) "not attained" "1, never" (bound (Polyhedron.relative_interior triangle) x);
  Alcotest.(check string) "at a corner that is missing" "1, never" 
    (bound (Polyhedron.add triangle (constraint_ ([ 0; 1 ], ">", 0))) x);
  Alcotest.(check string) "unbounded" "none" (bound (system 2 [ ([ 1; -1 ], "<=", 0) ]) x)

(* The solver stands at a point that is as near to the border as delta. *)
let near_borders () =
  let p = system 2 [ ([ 1; 0 ], ">", 0); ([ 2; -1 ], "<", 0); ([ 0; 1 ], "<", 1) ] in
  yes "strictly inside" true (Polyhedron.implies p (constraint_ ([ 3; -1 ], "<", 1)));
  let base =
    [ ([ 0; -3; 0; 0 ], "<=", 8); ([ -1; 2; 0; 0 ], "<", -4); ([ 0; 0; 2; 3 ], "<", 19); ([ 0; 1; 0; 3 ], "<=", 7);
      ([ -3; 0; 0; 0 ], "<=", -7); ([ 0; 0; 1; 3 ], "=", 11); ([ -1; 1; -2; 1 ], "<=", -1) ]
  in
  let cut = ([ 0; 2; 3; -3 ], "<", -6) and beyond = ([ 0; 2; 3; -3 ], ">=", -6) in
  let whole = system 4 base and p = system 4 (cut :: base) and q = system 4 (beyond :: base) in
  yes "a part is included" true (Polyhedron.included p whole && Polyhedron.included (Polyhedron.minimal p) whole);
  Alcotest.(check (option string)) "parts of a whole" (Some (text whole))
    (Option.map text (Envelope.merge p q))

let sets () =
  let hole = Union.difference (Union.of_polyhedron (square "0" "3")) (Union.of_polyhedron (square "1" "2")) in
  Alcotest.(check int) "a ring" 4 (List.length (Union.pieces hole));
  Alcotest.(check (option string)) "its area" (Some "8") (volume_text (volume_of_union hole));
  let filled = Union.union hole (Union.of_polyhedron (square "1" "2")) in
  yes "filled" true (Union.covers filled (square "0" "3"));
  Alcotest.(check int) "merged" 1 (List.length (Union.pieces (Union.merged filled)));
  yes "the hole is missed" false (Union.covers hole (square "0" "3"));
  let left = system 1 [ ([ 1 ], ">=", 0); ([ 1 ], "<", 1) ] in
  let right = system 1 [ ([ 1 ], ">", 1); ([ 1 ], "<=", 2) ] in
  yes "a point is missing" true (Envelope.merge left right = None);
  let at_one = system 1 [ ([ 1 ], "=", 1) ] in
  Alcotest.(check (option string)) "added" (Some "x >= 0, x <= 1") (Option.map text (Envelope.merge left at_one));
  let p = system 2 [ ([ 1; 0 ], ">", 0); ([ 0; 1 ], ">=", 0) ] in
  let p' = system 2 [ ([ 1; 1 ], ">=", 0); ([ 0; 1 ], ">", 0) ] in
  Alcotest.(check (option string)) "a corner is missing" (Some "x + 2y > 0, x + y >= 0, y >= 0")
    (Option.map text (Envelope.merge p p'));
  let range high = system 1 [ ([ 1 ], ">=", 0); ([ 1 ], "<=", high) ] in
  is "widened" "x >= 0" (Envelope.widen (range 1) (range 2))

let volumes () =
  (* By blocks of variables: of 60 a box, and of 61 with a triangle, which have too many vertices for all else. *)
  let sides = Array.init 60 (fun _ -> (q "0", q "2")) in
  volume "a box of 60 dimensions" (Some (Z.to_string (Z.pow (Z.of_int 2) 60))) (Polyhedron.box sides);
  let at = Array.init 60 (fun i -> if i = 0 then 0 else i + 1) in
  let prism = Polyhedron.inter (Polyhedron.embed (Polyhedron.box sides) ~dimension:61 at)
      (Polyhedron.embed triangle ~dimension:61 [| 1; 0 |]) in
  volume "and a prism" (Some (Z.to_string (Z.pow (Z.of_int 2) 58))) prism;
  volume "triangle" (Some "1/2") triangle;
  volume "its interior" (Some "1/2") (Polyhedron.relative_interior triangle);
  volume "square" (Some "9/4") (square "-1/2" "1");
  volume "flat" (Some "0") (system 2 [ ([ 1; 1 ], "=", 0) ]);
  volume "infinite" None (system 2 [ ([ 1; 1 ], "<=", 0) ]);
  volume "nothing" (Some "0") (Polyhedron.empty 3);
  let signed rest = List.concat_map (fun s -> List.map (fun more -> s :: more) rest) [ -1; 1 ] in
  let signs = signed (signed (signed [ [] ])) in
  volume "octahedron" (Some "4/3") (system 3 (List.map (fun normal -> (normal, "<=", 1)) signs));
  let unit k = List.init 5 (fun i -> if i = k then 1 else 0) in
  volume "a simplex of dimension 5" (Some "1/120")
    (system 5 (([ 1; 1; 1; 1; 1 ], "<=", 1) :: List.init 5 (fun k -> (unit k, ">=", 0))));
  let signs = signed (signed signs) in
  volume "a cross of dimension 5, many of whose facets meet in each vertex" (Some "4/15")
    (system 5 (List.map (fun normal -> (normal, "<=", 1)) signs));
  let cube n = Polyhedron.box (Array.make n (q "0", q "1")) in
  let sum_below n bound =
    Polyhedron.add (cube n) (constraint_ (List.init n (fun _ -> 1), "<", bound))
  in
  volume "ten numbers whose sum is less than 5" (Some "1/2") (sum_below 10 5);
  (* The distribution of a sum of uniform numbers: (2^10 - 10) / 10! of ten are below 2. *)
  volume "less than 2" (Some "169/604800") (sum_below 10 2);
  let descent i = constraint_ (List.init 7 (fun k -> if k = i then 1 else if k = i + 1 then -1 else 0), "<=", 0) in
  volume "seven numbers in order" (Some "1/5040")
    (Polyhedron.add_all (cube 7) (List.init 6 descent));
  volume "a sum of forty numbers" (Some "not computed") (sum_below 40 20)

(* What is asked of many variables takes no longer than what it takes for those that constraints join. *)
let many () =
  let n = 300 in
  let sides = Polyhedron.box (Array.make n (q "0", q "2")) in
  let joined i =
    Constraint.less (Linear.variable n i) (Linear.variable n (i + 1))
  in
  let p = Polyhedron.add_all sides [ joined 0; joined 1; joined 7 ] in
  Alcotest.(check int) "constraints" ((2 * n) - 3) (List.length (Polyhedron.constraints p));
  yes "what follows in a block" true
    (Polyhedron.implies p (Constraint.less (Linear.variable n 0) (Linear.variable n 2)));
  yes "and in none" false
    (Polyhedron.implies p (Constraint.less (Linear.variable n 0) (Linear.variable n 7)));
  let sum = Linear.make ~constant:Rat.one (Array.make n Rat.one) in
  yes "bounds add up" true
    (Polyhedron.supremum p sum = Some (Bound { value = Rat.of_int ((2 * n) + 1); attained = false })
     && Polyhedron.infimum sides sum = Some (Bound { value = Rat.one; attained = true }));
  yes "over blocks" true
    (Polyhedron.implies p (Constraint.less sum (Linear.constant n (Rat.of_int ((2 * n) + 1))))
     && not (Polyhedron.implies sides (Constraint.less sum (Linear.constant n (Rat.of_int ((2 * n) + 1))))));
  let half = Polyhedron.project p (Array.init (n / 2) (fun i -> 2 * i)) in
  is "projected" "true" (Polyhedron.project half [||]);
  yes "a half" true (Polyhedron.included half (Polyhedron.box (Array.make (n / 2) (q "0", q "2"))));
  let m = 40 in
  let sum = Linear.make ~constant:(Rat.of_int (-m / 4)) (Array.make m Rat.one) in
  let cut = Constraint.less sum (Linear.constant m Rat.zero) in
  let p = Polyhedron.add (Polyhedron.box (Array.make m (q "0", q "1"))) cut in
  match Polyhedron.interior_point p with
  | None -> Alcotest.fail "it is not empty"
  | Some point ->
    yes "inside" true (Polyhedron.mem p point);
    yes "short numbers" true (Array.for_all (fun x -> String.length (Rat.to_string x) < 60) point)

let texts () =
  let prints expected c = Alcotest.(check string) expected expected (Text.constraint_ ~name (constraint_ c)) in
  prints "x <= 2" ([ 1; 0 ], "<=", 2);
  prints "x > 3/2" ([ 2; 0 ], ">", 3);
  prints "2x + 3y < 5" ([ 2; 3 ], "<", 5);
  prints "x = y" ([ 1; -1 ], "=", 0);
  prints "x + 1 <= 2y" ([ 1; -2 ], "<=", -1);
  prints "x <= 2y + 1" ([ 1; -2 ], "<=", 1);
  prints "x + y >= -3" ([ 1; 1 ], ">=", -3);
  prints "x + y >= 3" ([ 1; 1 ], ">=", 3);
  let smt c = Text.smt_constraint ~name (constraint_ c) in
  Alcotest.(check string) "SMT-LIB" "(< (+ x (* (- 2.0) y)) (- 3.0))" (smt ([ 1; -2 ], "<", -3));
  Alcotest.(check string) "quoted" "|a b|" (Text.smt_symbol "a b");
  Alcotest.(check string) "empty" "false" (Text.smt_polyhedron ~name (Polyhedron.empty 1))

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "systems"
    [ ("by hand",
       [ case "emptiness" emptiness; case "minimal forms" minimal_forms; case "projections" projections;
         case "points and bounds" points; case "near borders" near_borders; case "sets" sets;
         case "volumes" volumes; case "hundreds of variables" many; case "texts" texts ]) ]
