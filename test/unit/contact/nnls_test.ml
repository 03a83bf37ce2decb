open Scc_exact
module Gen = QCheck2.Gen

let check_vec what a b = Alcotest.(check string) what (Vec.to_string a) (Vec.to_string b)
let small = Gen.map (fun (x, y, z) -> Vec.of_ints x y z) Gen.(triple (-3 -- 3) (-3 -- 3) (-3 -- 3))
let dot_row gram i x = Array.fold_left Rat.add Rat.zero (Array.mapi (fun j g -> Rat.mul g x.(j)) gram.(i))

(* x is a minimum iff x >= 0, the gradient g = gram x - target is >= 0 and x.g = 0. *)
let optimal gram target x =
  let ok i xi =
    let g = Rat.sub (dot_row gram i x) target.(i) in
    Rat.sign xi >= 0 && Rat.sign g >= 0 && Rat.sign (Rat.mul xi g) = 0
  in
  Array.for_all Fun.id (Array.mapi ok x)

let kuhn_tucker =
  QCheck2.Test.make ~name:"the answer meets the optimality conditions" ~count:250
    Gen.(pair (list_size (0 -- 7) small) small)
    (fun (vs, b) ->
       let v = Array.of_list vs in
       let gram = Array.map (fun a -> Array.map (Vec.dot a) v) v and target = Array.map (Vec.dot b) v in
       optimal gram target (Nnls.solve ~gram ~target))

(* More columns than their rank, and more dimensions than three. *)
let many =
  QCheck2.Test.make ~name:"also in six dimensions, with dependent columns" ~count:100
    Gen.(pair (list_size (1 -- 9) (pair small small)) (pair small small))
    (fun (vs, (b, c)) ->
       let v = Array.of_list vs in
       let dot (a, a') (b, b') = Rat.add (Vec.dot a b) (Vec.dot a' b') in
       let gram = Array.map (fun a -> Array.map (dot a) v) v and target = Array.map (dot (b, c)) v in
       optimal gram target (Nnls.solve ~gram ~target))

(* {1 Against all subsets}

   The nearest point of a cone in space is the nearest point of the span of at most three generators, with
   coefficients >= 0. *)

let project_line a b = Vec.scale (Rat.div (Vec.dot a b) (Vec.norm2 a)) a

(* Cramer's rule for the coefficients of a point in a basis of three. *)
let coefficients a b c p =
  let det u v w = Vec.dot u (Vec.cross v w) in
  let d = det a b c in
  List.map (fun x -> Rat.div x d) [ det p b c; det a p c; det a b p ]

let candidates vs b =
  let one = List.filter (fun a -> (not (Vec.is_zero a)) && Rat.sign (Vec.dot a b) > 0) vs in
  let pairs = List.concat_map (fun a -> List.map (fun c -> (a, c)) vs) vs in
  let plane (a, c) =
    let n = Vec.cross a c in
    if Vec.is_zero n then None
    else
      let p = Vec.sub b (project_line n b) in
      if List.for_all (fun k -> Rat.sign k >= 0) (coefficients a c n p) then Some p else None
  in
  let inside (a, c) =
    let holds d =
      Rat.sign (Vec.dot d (Vec.cross a c)) <> 0
      && List.for_all (fun k -> Rat.sign k >= 0) (coefficients a c d b)
    in
    if List.exists holds vs then Some b else None
  in
  (Vec.zero :: List.map (fun a -> project_line a b) one)
  @ List.filter_map plane pairs @ List.filter_map inside pairs

let brute_force vs b =
  let distance p = Vec.norm2 (Vec.sub p b) in
  let nearer p q = if Rat.compare (distance q) (distance p) < 0 then q else p in
  List.fold_left nearer Vec.zero (candidates vs b)

let all_subsets =
  QCheck2.Test.make ~name:"the projection on a cone is the best over all subsets" ~count:250
    Gen.(pair (list_size (0 -- 6) small) small)
    (fun (vs, b) -> Vec.equal (Nnls.project_cone vs b) (brute_force vs b))

let known () =
  let v = Vec.of_ints in
  let check what cone p expected = check_vec what expected (Nnls.project_cone cone p) in
  check "no generators" [] (v 1 2 3) Vec.zero;
  check "behind a ray" [ v 0 0 1 ] (v 1 1 (-1)) Vec.zero;
  check "onto a ray" [ v 0 0 2 ] (v 5 5 3) (v 0 0 3);
  check "zero generator" [ Vec.zero; v 0 0 2 ] (v 5 5 3) (v 0 0 3);
  check "inside a quadrant" [ v 1 0 0; v 0 1 0 ] (v 2 3 4) (v 2 3 0);
  check "the second generator leaves again" [ v 1 0 0; v 3 1 0 ] (v 4 (-1) 0) (v 4 0 0);
  let x = Nnls.solve ~gram:[| [| Rat.of_int 4 |] |] ~target:[| Rat.of_int 2 |] in
  Alcotest.(check string) "one column" "1/2" (Rat.to_string x.(0))

let suite =
  ("nnls",
   [ ("known", [ Alcotest.test_case "cones" `Quick known ]);
     ("properties", Scc_test_support.Property.cases [ kuhn_tucker; many; all_subsets ]) ])
