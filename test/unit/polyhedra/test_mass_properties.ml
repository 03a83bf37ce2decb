(* Volume, centroid and inertia against closed forms, and the laws that they obey. *)
open Scc_exact
open Scc_geometry
module G = QCheck2.Gen

let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let check_rat name expected found = Alcotest.(check string) name (Rat.to_string expected) (Rat.to_string found)
let check_vec name expected found = Alcotest.(check string) name (Vec.to_string expected) (Vec.to_string found)

let print_mat (m : Mat.t) = String.concat " " (List.map Vec.to_string [ m.r0; m.r1; m.r2 ])
let check_mat name expected found = Alcotest.(check string) name (print_mat expected) (print_mat found)

(* {1 Solids} *)

let accept vertices faces =
  let name prefix = Array.mapi (fun i x -> (prefix ^ string_of_int i, x)) in
  match Polyhedron.of_ifs { ifs_vertices = name "v" vertices; ifs_faces = name "f" faces } with
  | Ok p -> p
  | Error _ -> Alcotest.fail "a good solid is refused"

(* From the low corner to the high one. *)
let box (l : Vec.t) (h : Vec.t) =
  let corner i =
    let pick bit low high = if (i lsr bit) land 1 = 0 then low else high in
    Vec.make (pick 0 l.x h.x) (pick 1 l.y h.y) (pick 2 l.z h.z)
  in
  accept (Array.init 8 corner)
    [|
      [| 0; 2; 3; 1 |]; [| 4; 5; 7; 6 |]; [| 0; 4; 6; 2 |];
      [| 1; 3; 7; 5 |]; [| 0; 1; 5; 4 |]; [| 2; 6; 7; 3 |];
    |]

let tetrahedron a b c d = accept [| a; b; c; d |] [| [| 0; 2; 1 |]; [| 0; 1; 3 |]; [| 0; 3; 2 |]; [| 1; 2; 3 |] |]

let moved d (p : Polyhedron.t) =
  accept (Array.map (fun (_, v) -> Vec.add d v) p.vertices) (Array.map snd p.faces)

let mass = Mass_properties.of_polyhedron

(* Inertia about another point than the centroid, [d] away (the parallel axis theorem), for that density 1. *)
let about (m : Mass_properties.t) d =
  let outer (v : Vec.t) = Mat.make (Vec.scale v.x v) (Vec.scale v.y v) (Vec.scale v.z v) in
  let shift = Mat.add (Mat.scale (Vec.norm2 d) Mat.identity) (Mat.scale (Rat.of_int (-1)) (outer d)) in
  Mat.add m.inertia (Mat.scale m.volume shift)

(* {1 Closed forms} *)

let test_box () =
  let m = mass (box (Vec.of_ints (-2) 1 0) (Vec.of_ints 2 2 2)) in
  check_rat "volume" (q 8 1) m.volume;
  check_vec "centroid" (Vec.make Rat.zero (q 3 2) Rat.one) m.centroid;
  (* m/12 (b^2 + c^2) *)
  let expected = Mat.diagonal (Vec.make (q 5 12) (q 20 12) (q 17 12)) in
  check_mat "inertia for mass 1" expected (Mass_properties.inertia ~mass:Rat.one m);
  check_mat "inertia for mass 7/3"
    (Mat.scale (q 7 3) expected)
    (Mass_properties.inertia ~mass:(q 7 3) m);
  check_mat "inertia for density 1" (Mat.scale (q 8 1) expected) m.inertia

let test_tetrahedron () =
  let m = mass (tetrahedron Vec.zero (Vec.of_ints 1 0 0) (Vec.of_ints 0 1 0) (Vec.of_ints 0 0 1)) in
  check_rat "volume" (q 1 6) m.volume;
  check_vec "centroid" (Vec.make (q 1 4) (q 1 4) (q 1 4)) m.centroid;
  (* mean of x^2 is 1/10 and of xy is 1/20 about the corner; less 1/16 about the centroid. *)
  let diagonal = q 3 40 and off = q 1 80 in
  check_mat "inertia for mass 1"
    (Mat.make (Vec.make diagonal off off) (Vec.make off diagonal off) (Vec.make off off diagonal))
    (Mass_properties.inertia ~mass:Rat.one m)

(* A prism of height 2 over the triangle (0,0) (3,0) (0,3), about its centroid: of the triangle the mean of x^2
   is 1/2 and of xy -1/4, and of z^2 it is 1/3. *)
let test_prism () =
  let base = [| (0, 0); (3, 0); (0, 3) |] in
  let at z = Array.map (fun (x, y) -> Vec.of_ints x y z) base in
  let m =
    mass
      (accept
         (Array.append (at (-1)) (at 1))
         [| [| 2; 1; 0 |]; [| 3; 4; 5 |]; [| 0; 1; 4; 3 |]; [| 1; 2; 5; 4 |]; [| 2; 0; 3; 5 |] |])
  in
  check_rat "volume" (q 9 1) m.volume;
  check_vec "centroid" (Vec.of_ints 1 1 0) m.centroid;
  check_mat "inertia for mass 1"
    (Mat.make
       (Vec.make (q 5 6) (q 1 4) Rat.zero)
       (Vec.make (q 1 4) (q 5 6) Rat.zero)
       (Vec.make Rat.zero Rat.zero Rat.one))
    (Mass_properties.inertia ~mass:Rat.one m)

(* {1 Laws} *)

let rational = G.map2 q (G.int_range (-20) 20) (G.int_range 1 6)
let positive = G.map2 q (G.int_range 1 20) (G.int_range 1 6)
let vector = G.map3 Vec.make rational rational rational

let some_tetrahedron =
  let make (a, b, c, d) =
    let v = Vec.dot (Vec.sub b a) (Vec.cross (Vec.sub c a) (Vec.sub d a)) in
    match Rat.sign v with
    | 0 -> None
    | 1 -> Some (tetrahedron a b c d)
    | _ -> Some (tetrahedron a c b d)
  in
  G.map make (G.quad vector vector vector vector)

let law name gen print holds =
  QCheck2.Test.make ~name ~count:200 ~print gen (function
      | Some p, x -> holds p x
      | None, _ -> true)

let print_of f (_, x) = f x
let equal_rat = Rat.equal

let translation =
  law "translation moves the centroid only" (G.pair some_tetrahedron vector) (print_of Vec.to_string) (fun p d ->
      let m = mass p and n = mass (moved d p) in
      equal_rat m.volume n.volume
      && Vec.equal (Vec.add d m.centroid) n.centroid
      && Mat.equal m.inertia n.inertia)

(* Any affine image: volume by the determinant; the second moments C, of which the inertia is tr C - C, by
   L C L^T. *)
let linear_images =
  let gen = G.pair some_tetrahedron (G.map3 Mat.make vector vector vector) in
  law "linear images" gen (print_of print_mat) (fun p l ->
      if Rat.sign (Mat.det l) <= 0 then true
      else
        let second (m : Mass_properties.t) =
          let trace (t : Mat.t) = Rat.add t.r0.x (Rat.add t.r1.y t.r2.z) in
          let half = Rat.div (trace m.inertia) (Rat.of_int 2) in
          Mat.add (Mat.scale half Mat.identity) (Mat.scale (Rat.of_int (-1)) m.inertia)
        in
        let m = mass p and n = mass (Polyhedron.transform l p) in
        let image = Mat.mul l (Mat.mul (second m) (Mat.transpose l)) in
        equal_rat n.volume (Rat.mul (Mat.det l) m.volume)
        && Vec.equal n.centroid (Mat.apply l m.centroid)
        && Mat.equal (second n) (Mat.scale (Mat.det l) image))

let rotation =
  let gen = G.pair some_tetrahedron (G.quad rational rational rational rational) in
  law "a rotation turns the inertia" gen (fun _ -> "quaternion") (fun p turn ->
      match Mat.of_quaternion turn with
      | None -> true
      | Some r ->
        let m = mass p and n = mass (Polyhedron.transform r p) in
        equal_rat m.volume n.volume
        && Mat.equal n.inertia (Mat.mul r (Mat.mul m.inertia (Mat.transpose r))))

let additivity =
  let gen = G.pair (G.map Option.some (G.triple positive positive positive)) (G.pair positive vector) in
  let print (_, (k, d)) = Rat.to_string k ^ Vec.to_string d in
  law "the parts of a cut box make the box" gen print (fun (a, b, c) (k, d) ->
      (* Cut at k / (1 + k) of the first side; everything moved by d. *)
      let cut = Rat.mul a (Rat.div k (Rat.add Rat.one k)) in
      let high x = Vec.add d (Vec.make x b c) in
      let whole = mass (box d (high a)) in
      let left = mass (box d (high cut)) in
      let right = mass (box (Vec.add d (Vec.make cut Rat.zero Rat.zero)) (high a)) in
      let moment (m : Mass_properties.t) = Vec.scale m.volume m.centroid in
      let to_whole (m : Mass_properties.t) = about m (Vec.sub whole.centroid m.centroid) in
      equal_rat whole.volume (Rat.add left.volume right.volume)
      && Vec.equal (moment whole) (Vec.add (moment left) (moment right))
      && Mat.equal whole.inertia (Mat.add (to_whole left) (to_whole right)))

(* {1 Solids} *)

let test_solid () =
  let p = tetrahedron Vec.zero (Vec.of_ints 3 0 0) (Vec.of_ints 0 3 0) (Vec.of_ints 0 0 3) in
  let s = Solid.make ~id:1 p (Mat.scale (q 1 2) Mat.identity) in
  check_rat "volume" (q 27 48) s.volume;
  check_vec "centroid" (Vec.make (q 3 8) (q 3 8) (q 3 8)) s.centroid;
  for axis = 0 to 2 do
    let close what expected found = Alcotest.(check (float 1e-12)) what expected found in
    close "the box begins at 0" 0. (Float_box.low s.box axis);
    close "the box ends at 3/2" 1.5 (Float_box.high s.box axis);
    Alcotest.(check bool) "no less than that" true (Float_box.high s.box axis >= 1.5)
  done;
  check_vec "a vertex" (Vec.make (q 3 2) Rat.zero Rat.zero) (Solid.vertex s 1);
  let normals = List.map Ivec.to_string (Array.to_list s.normals) in
  Alcotest.(check (list string)) "normals" [ "(0, 0, -1)"; "(0, -1, 0)"; "(-1, 0, 0)"; "(1, 1, 1)" ] normals

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("mass properties",
   [
     ( "Mass",
       [ case "box" test_box; case "tetrahedron" test_tetrahedron; case "prism" test_prism ]
       @ Scc_test_support.Property.cases [ translation; linear_images; rotation; additivity ] );
     ("Solid", [ case "an image of a template" test_solid ]);
   ])
