(* Polyhedra by linear constraints: laws, against points and against vertices found by brute force. *)

open Scc_exact
open Scc_polyhedra
module Gen = QCheck2.Gen
module Test = QCheck2.Test

let name i = String.make 1 "xyzw".[i]
let print_two (p, q) = Text.polyhedron ~name p ^ "  and  " ^ Text.polyhedron ~name q

(* {1 Random ones} *)

let small = Gen.int_range (-3) 3

let constraint_ n =
  let make (normal, kind, right) =
    let relation : Constraint.relation = if kind = 0 then Equal else if kind < 4 then Less else At_most in
    Constraint.make (Array.map Z.of_int normal) relation (Z.of_int right)
  in
  Gen.map make Gen.(triple (array_size (pure n) small) (0 -- 9) (-2 -- 6))

let polyhedron n = Gen.map (Polyhedron.of_constraints n) Gen.(list_size (0 -- 6) (constraint_ n))
let fraction = Gen.map (fun (a, b) -> Rat.make (Z.of_int a) (Z.of_int b)) Gen.(pair (-8 -- 8) (1 -- 3))

(* Points of the polyhedra and in between tell more than points anywhere. *)
let probes p q others =
  let own = List.filter_map Fun.id Polyhedron.[ point p; point q; corner p; corner q ] in
  let middle a b = Array.map2 (fun x y -> Rat.div (Rat.add x y) (Rat.of_int 2)) a b in
  let all = own @ others in
  all @ List.concat_map (fun a -> List.map (middle a) all) own

let plane = Gen.(pair (pair (polyhedron 2) (polyhedron 2)) (list_size (pure 6) (array_size (pure 2) fraction)))

let at_points what law =
  let holds ((p, q), others) = List.for_all (law p q) (probes p q others) in
  Test.make ~name:what ~count:200 ~print:(fun (two, _) -> print_two two) plane holds

let ( => ) a b = (not a) || b
let mem = Polyhedron.mem

(* {1 What is seen at a glance}

   Constraints of one parameter, of whose normals many are multiples of each other, and some of two. *)

let pair_of_constraints =
  let parallel = Gen.map2 (fun k c -> (c, k)) Gen.(oneofl [ -3; -2; -1; 1; 2; 3 ]) (constraint_ 2) in
  let both ((c, k), d, own) =
    if not own then (c, d)
    else
      let scaled = Array.map (Z.mul (Z.of_int k)) c.Constraint.normal in
      (c, Constraint.make scaled d.Constraint.relation d.right)
  in
  Gen.map both (Gen.triple parallel (constraint_ 2) (Gen.frequencyl [ (3, true); (1, false) ]))

let of_constraint c = Polyhedron.of_constraints 2 [ c ]

(* The glance against the solver, which is told the constraint's complement, piece by piece. *)
let solver_follows c d =
  List.for_all (fun piece -> Option.is_none (Simplex.of_constraints 2 [ piece; d ])) (Constraint.negation c)

let is_inequality (c : Constraint.t) = c.relation <> Equal

let glances =
  let law what holds =
    let print (c, d) = print_two (of_constraint c, of_constraint d) in
    Test.make ~name:what ~count:2000 ~print pair_of_constraints holds
  in
  [ law "a constraint that is seen to follow does" (fun (c, d) ->
        match Constraint.glance c d with
        | Follows -> solver_follows c d
        | Implies -> solver_follows d c
        | Excludes | Unrelated -> true);
    law "inequalities that are seen to exclude each other do" (fun (c, d) ->
        Constraint.glance c d = Excludes => Option.is_none (Simplex.of_constraints 2 [ c; d ]));
    law "of two parallel inequalities everything is seen" (fun (c, d) ->
        let parallel = Constraint.first_variable c <> None && is_inequality c && is_inequality d in
        let times sign = Constraint.make (Array.map (Z.mul sign) d.normal) d.relation d.right in
        let along sign = Constraint.same_normal c (times sign) in
        let empty = Option.is_none (Simplex.of_constraints 2 [ c; d ]) in
        let expected : Constraint.glance =
          if empty then Excludes
          else if along Z.one then if solver_follows c d then Follows else Implies
          else Unrelated
        in
        (parallel && (along Z.one || along Z.minus_one)) => (Constraint.glance c d = expected)) ]

let glances_by_hand () =
  let x = Linear.variable 1 0 in
  let less k = Constraint.less x (Linear.constant 1 k) in
  let at_most k = Constraint.at_most x (Linear.constant 1 k) in
  let at_least k = Constraint.at_least x (Linear.constant 1 k) in
  let half = Rat.make Z.one (Z.of_int 2) and third = Rat.make Z.one (Z.of_int 3) in
  let check name expected c d = Alcotest.(check bool) name true (Constraint.glance c d = expected) in
  check "the same" Constraint.Follows (less half) (less half);
  check "wider, another denominator" Follows (at_most half) (at_most third);
  check "narrower" Implies (at_most third) (at_most half);
  check "with its border" Follows (at_most half) (less half);
  check "without its border" Implies (less half) (at_most half);
  check "the other way, with a point" Unrelated (at_least third) (at_most third);
  check "a gap" Excludes (at_most third) (at_least half);
  check "without the point between" Excludes (less half) (at_least half)

let set_laws =
  let u p = Union.of_polyhedron p in
  [ at_points "intersection, point by point" (fun p q x ->
        mem (Polyhedron.inter p q) x = (mem p x && mem q x));
    at_points "difference, point by point" (fun p q x ->
        Union.mem (Union.difference (u p) (u q)) x = (mem p x && not (mem q x)));
    at_points "the pieces of a difference are disjoint" (fun p q x ->
        List.length (List.filter (fun r -> mem r x) (Difference.pieces p q)) <= 1);
    at_points "a disjoint union, point by point" (fun p q x ->
        let pieces = Union.pieces (Union.disjoint (Union.union (u p) (u q))) in
        List.length (List.filter (fun r -> mem r x) pieces) = if mem p x || mem q x then 1 else 0);
    at_points "a merged union, point by point" (fun p q x ->
        Union.mem (Union.merged (Union.union (u p) (u q))) x = (mem p x || mem q x));
    at_points "the join contains both" (fun p q x -> (mem p x || mem q x) => mem (Envelope.join p q) x);
    at_points "a minimal form has the same points" (fun p _ x ->
        mem (Polyhedron.of_constraints 2 (Polyhedron.constraints p)) x = mem p x);
    at_points "what is included has no point outside" (fun p q x ->
        Polyhedron.included p q => (mem p x => mem q x));
    at_points "the closure contains it" (fun p _ x -> mem p x => mem (Polyhedron.closure p) x) ]

let law what law = Test.make ~name:what ~count:150 ~print:print_two Gen.(pair (polyhedron 3) (polyhedron 3)) law

let algebra =
  let u p = Union.of_polyhedron p in
  [ law "p is in q iff nothing is left of it" (fun (p, q) ->
        Polyhedron.included p q = (Difference.pieces p q = []));
    law "p without q, and p and q, are p" (fun (p, q) ->
        Union.equal (u p) (Union.union (Union.difference (u p) (u q)) (u (Polyhedron.inter p q))));
    law "the complement of the complement" (fun (p, q) ->
        let out = Union.difference (u q) (u p) in
        Union.equal (Union.difference (u q) out) (u (Polyhedron.inter p q)));
    law "no constraint of a minimal form can be left out" (fun (p, _) ->
        let all = Polyhedron.constraints p in
        let without c = Polyhedron.of_constraints 3 (List.filter (fun d -> not (d == c)) all) in
        Polyhedron.is_empty p || List.for_all (fun c -> not (Polyhedron.equal (without c) p)) all);
    law "closed polyhedra have one minimal form" (fun (p, q) ->
        let p = Polyhedron.closure p in
        (* the same, said in another order and with more constraints *)
        let more = List.filter (Polyhedron.implies p) (Polyhedron.constraints (Polyhedron.closure q)) in
        let other = Polyhedron.of_constraints 3 (more @ List.rev (Polyhedron.constraints p)) in
        List.equal Constraint.equal (Polyhedron.constraints p) (Polyhedron.constraints other));
    law "two that a plane makes of one are one again" (fun (p, q) ->
        let cut (c : Constraint.t) =
          let parts = List.map (fun d -> Polyhedron.add p d) [ c; List.hd (Constraint.negation c) ] in
          c.relation = Equal
          || (match parts with
              | [ a; b ] ->
                let whole x y = Option.fold ~none:false ~some:(Polyhedron.equal p) (Envelope.merge x y) in
                whole a b && whole b a
              | _ -> false)
        in
        List.for_all cut (Polyhedron.constraints q));
    law "an interior point is inside" (fun (p, _) ->
        match Polyhedron.interior_point p with
        | Some point -> mem (Polyhedron.relative_interior p) point
        | None -> Polyhedron.is_empty p) ]

(* {1 Functions of other variables} *)

let value_at x f =
  match Piecewise.pieces (Polyhedron.of_point x) f with
  | [ (_, v) ] -> Option.map (fun (v : Piecewise.value) -> v.least) v
  | _ -> Alcotest.fail "a point in several pieces"

(* Sums of numbers where some constraints hold. *)
let functions =
  let form n = Gen.(map2 (fun k a -> Linear.make ~constant:k a) fraction (array_size (pure n) fraction)) in
  let parts = Gen.(list_size (1 -- 4) (list_size (1 -- 3) (constraint_ 2))) in
  let probe = Gen.(list_size (pure 8) (array_size (pure 3) fraction)) in
  let gen = Gen.(quad parts (pair (form 3) (form 3)) (polyhedron 2) probe) in
  [ Test.make ~name:"a function of forms" ~count:250 gen (fun (parts, (a, b), set, probe) ->
        let s = Piecewise.space () in
        let number k = Piecewise.constant s { least = Rat.of_int k; most = Rat.of_int k } in
        let part k constraints =
          (Rat.one, Piecewise.first s (Piecewise.within s constraints (number (k + 1))) (number 0))
        in
        let f = Piecewise.sum s (List.mapi part parts) in
        let g = Piecewise.preimage s ~dimension:3 [| a; b |] set f in
        let agree x =
          let y = [| Linear.eval a x; Linear.eval b x |] in
          (not (mem set y)) || Option.equal Rat.equal (value_at x g) (value_at y f)
        in
        let onto = Polyhedron.preimage set ~dimension:3 [| a; b |] in
        let own = List.filter_map Fun.id Polyhedron.[ point onto; interior_point onto ] in
        List.for_all agree (own @ probe)) ]

(* {1 Projections, against fibres} *)

let projections =
  let fibre p (x, y) =
    let fixed i v = Constraint.equals (Linear.variable 3 i) (Linear.constant 3 v) in
    not (Polyhedron.is_empty (Polyhedron.add_all p [ fixed 0 x; fixed 1 y ]))
  in
  let gen = Gen.(pair (polyhedron 3) (list_size (pure 8) (pair fraction fraction))) in
  [ Test.make ~name:"a point is in a projection iff its fibre has a point" ~count:250 gen (fun (p, points) ->
        let shadow = Polyhedron.project p [| 0; 1 |] in
        let corners = List.filter_map Fun.id [ Polyhedron.corner shadow; Polyhedron.point shadow ] in
        let points = points @ List.map (fun a -> (a.(0), a.(1))) corners in
        List.for_all (fun (x, y) -> mem shadow [| x; y |] = fibre p (x, y)) points) ]

(* {1 Emptiness and bounds in the plane, against all vertices} *)

let vertices constraints box =
  let all = List.concat_map Constraint.halves (constraints @ box) in
  let meet (c : Constraint.t) (d : Constraint.t) =
    let det a b e f = Z.sub (Z.mul a f) (Z.mul b e) in
    let denominator = det c.normal.(0) c.normal.(1) d.normal.(0) d.normal.(1) in
    if Z.sign denominator = 0 then None
    else
      Some
        [| Rat.make (det c.right c.normal.(1) d.right d.normal.(1)) denominator;
           Rat.make (det c.normal.(0) c.right d.normal.(0) d.right) denominator |]
  in
  let inside x = List.for_all (fun c -> Constraint.mem (Constraint.closed c) x) all in
  List.filter inside (List.concat_map (fun c -> List.filter_map (meet c) all) all)

let mean points =
  let n = Rat.of_int (List.length points) in
  Array.init 2 (fun i -> Rat.div (List.fold_left (fun sum x -> Rat.add sum x.(i)) Rat.zero points) n)

let brute_force =
  let ten = Rat.of_int 10 in
  let box = Polyhedron.constraints (Polyhedron.box [| (Rat.neg ten, ten); (Rat.neg ten, ten) |]) in
  let gen = Gen.(pair (list_size (0 -- 6) (constraint_ 2)) (array_size (pure 2) small)) in
  (* the mean of all vertices is in the relative interior of the closure: what is strict holds there if anywhere *)
  let compare_with (constraints, coefficients) =
    let p = Polyhedron.of_constraints 2 (constraints @ box) in
    let corners = vertices constraints box in
    let all_in () = List.for_all (fun c -> Constraint.mem c (mean corners)) constraints in
    let f = Linear.make ~constant:Rat.one (Array.map Rat.of_int coefficients) in
    if corners = [] || not (all_in ()) then Polyhedron.is_empty p
    else
      let values = List.map (Linear.eval f) corners in
      let greatest = List.fold_left Rat.max (List.hd values) values in
      match Polyhedron.supremum p f with
      | Some (Bound { value; _ }) -> Rat.equal value greatest
      | Some Unbounded | None -> false
  in
  [ Test.make ~name:"emptiness and bounds, against all vertices" ~count:500 gen compare_with ]

(* {1 Volumes} *)

let finite = function Volume.Finite x -> x | Infinite | Not_computed -> failwith "no volume"
let volume p = finite (Volume.of_polyhedron p)

let determinant (a : int array array) =
  (a.(0).(0) * ((a.(1).(1) * a.(2).(2)) - (a.(1).(2) * a.(2).(1))))
  - (a.(0).(1) * ((a.(1).(0) * a.(2).(2)) - (a.(1).(2) * a.(2).(0))))
  + (a.(0).(2) * ((a.(1).(0) * a.(2).(1)) - (a.(1).(1) * a.(2).(0))))

let volumes =
  let unit_simplex =
    let positive i = Constraint.at_least (Linear.variable 3 i) (Linear.constant 3 Rat.zero) in
    let sum = Linear.make ~constant:Rat.zero (Array.make 3 Rat.one) in
    Polyhedron.of_constraints 3
      (Constraint.at_most sum (Linear.constant 3 Rat.one) :: List.init 3 positive)
  in
  let matrix = Gen.(array_size (pure 3) (array_size (pure 3) small)) in
  let cut (p, c) =
    let p = Polyhedron.inter p (Polyhedron.box (Array.make 3 (Rat.of_int (-3), Rat.of_int 3))) in
    let parts = List.map (fun d -> volume (Polyhedron.add p d)) (c :: Constraint.negation c) in
    Rat.equal (volume p) (List.fold_left Rat.add Rat.zero parts)
  in
  let both (p, q) =
    let inside p = Polyhedron.inter p (Polyhedron.box (Array.make 3 (Rat.of_int (-3), Rat.of_int 3))) in
    let p = inside p and q = inside q in
    let union = Union.of_polyhedra 3 [ p; q ] in
    let pieces = Union.pieces (Union.disjoint union) in
    let once = finite (Volume.sum (List.map Volume.of_polyhedron pieces)) in
    let twice = volume (Polyhedron.inter p q) in
    Rat.equal (Rat.add once twice) (Rat.add (volume p) (volume q))
  in
  [ Test.make ~name:"a simplex has the volume of its determinant" ~count:100 matrix (fun m ->
        let forms = Array.map (fun row -> Linear.make ~constant:Rat.one (Array.map Rat.of_int row)) m in
        let expected = Rat.make (Z.of_int (abs (determinant m))) (Z.of_int 6) in
        Rat.equal expected (volume (Polyhedron.image unit_simplex forms)));
    Test.make ~name:"volumes add up over a cut" ~count:100 Gen.(pair (polyhedron 3) (constraint_ 3)) cut;
    Test.make ~name:"a union has what is in both once" ~count:50 ~print:print_two
      Gen.(pair (polyhedron 3) (polyhedron 3)) both ]

let () =
  let cases = Scc_test_support.Property.cases in
  Alcotest.run "laws of systems"
    [ ("sets", cases set_laws); ("glances", Alcotest.test_case "by hand" `Quick glances_by_hand :: cases glances);
      ("algebra", cases algebra); ("functions", cases functions); ("projections", cases projections);
      ("brute force", cases brute_force); ("volumes", cases volumes) ]
