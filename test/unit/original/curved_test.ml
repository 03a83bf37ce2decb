(* Polyhedra that stand for curved solids: what is claimed of them, and caps. *)

open Scc_exact
open Scc_geometry
open Scc_mesh

let frac a b = Rat.make (Z.of_int a) (Z.of_int b)

let polyhedron ifs =
  match Polyhedron.of_ifs ifs with Ok p -> p | Error _ -> Alcotest.fail "no convex solid"

let balls () =
  List.iter
    (fun n ->
       let p = polyhedron (Curved.ball n) in
       Array.iter
         (fun (_, v) -> Alcotest.(check string) "on the sphere" "1" (Rat.to_string (Vec.norm2 v)))
         p.vertices;
       let c = (Mass_properties.of_polyhedron p).centroid in
       Alcotest.(check bool) "about the origin" true (Vec.is_zero c))
    [ 4; 8; 12; 16; 24 ]

(* Offset and normal of each face plane. *)
let planes (p : Polyhedron.t) =
  Array.map
    (fun (_, c) ->
       let at k = snd p.vertices.(c.(k)) in
       let n = Vec.cross (Vec.sub (at 1) (at 0)) (Vec.sub (at 2) (at 0)) in
       (Vec.dot n (at 0), Vec.norm2 n))
    p.faces

(* Each face plane is at least so far from the centre: o >= r |n|. *)
let holds_ball p r =
  Array.for_all (fun (o, n2) -> Rat.compare (Rat.mul o o) (Rat.mul (Rat.mul r r) n2) >= 0) (planes p)

let square x = Rat.mul x x

let distances () =
  List.iter
    (fun d ->
       let inside = Curved.sphere Inscribed d in
       let p = polyhedron (Curved.ball inside.corners) in
       Alcotest.(check bool) "as near as asked for" true (Rat.compare inside.distance d <= 0);
       Alcotest.(check bool) "the ball of radius 1 - d is within" true (holds_ball p (Rat.sub Rat.one
                                                                                        inside.distance));
       let outside = Curved.sphere Circumscribed d in
       let p =
         polyhedron (Curved.ball outside.corners)
         |> Polyhedron.transform (Mat.diagonal (Vec.make outside.factor outside.factor outside.factor))
       in
       Alcotest.(check bool) "as near as asked for" true (Rat.compare outside.distance d <= 0);
       Alcotest.(check bool) "the ball is within" true (holds_ball p Rat.one);
       Array.iter
         (fun (_, v) ->
            Alcotest.(check string) "no vertex is farther"
              (Rat.to_string (square (Rat.add Rat.one outside.distance)))
              (Rat.to_string (Vec.norm2 v)))
         p.vertices;
       Alcotest.(check bool) "no fewer corners would do" true
         (inside.corners = 4
          || not (holds_ball (polyhedron (Curved.ball (inside.corners - 4))) (Rat.sub Rat.one d))))
    [ frac 1 2; frac 1 5; frac 1 10; frac 1 20 ]

(* The polygon of a prism: the distance of its sides from the axis, by coordinates. *)
let discs () =
  let side n k =
    let x, y = Named_solids.on_circle n k and x', y' = Named_solids.on_circle n ((k + 1) mod n) in
    let cross = Rat.sub (Rat.mul x y') (Rat.mul y x') in
    (square cross, Rat.add (square (Rat.sub x' x)) (square (Rat.sub y' y)))
  in
  let beyond r n = List.for_all (fun k -> let c, l = side n k in Rat.compare c (Rat.mul (square r) l) >= 0)
      (List.init n Fun.id) in
  List.iter
    (fun d ->
       let inside = Curved.disc Inscribed d and outside = Curved.disc Circumscribed d in
       Alcotest.(check bool) "inscribed" true (beyond (Rat.sub Rat.one inside.distance) inside.corners);
       Alcotest.(check bool) "near" true (Rat.compare inside.distance d <= 0 && Rat.compare outside.distance
                                            d <= 0);
       Alcotest.(check bool) "circumscribed" true (beyond (Rat.div Rat.one outside.factor) outside.corners))
    [ frac 1 2; frac 1 10; frac 1 30; frac 1 100 ]

(* The least distance is one that prisms and balls have. *)
let least () =
  Alcotest.(check bool) "prisms" true ((Curved.disc Circumscribed Curved.least).corners <= 256);
  Alcotest.(check bool) "balls" true ((Curved.sphere Circumscribed Curved.least).corners <= 40)

(* {1 Caps} *)

let solid name text =
  let text =
    Printf.sprintf "curved inscribed 1/10\nshape S = %s\nbehaviour Open on S = <a, %s>. nil\nprocess p = S \
                    mass 1 [Open]"
      name text
  in
  match Scc_original.Original.read (Scc_base.Source.make ~name:"model.osc" text) with
  | Ok (model, _) -> model
  | Error ds -> Alcotest.fail (String.concat "; " (List.map (fun (d : Scc_base.Diag.t) -> d.message) ds))

let features model =
  let open Scc_syntax in
  let channel (i : Ast.item) =
    match i.it with
    | Behaviour (_, _, { it = Open (c, _); _ }, _) ->
      Some (List.map (fun (m : Ast.member) -> (m.only, Text.feature m.feature)) c.features)
    | _ -> None
  in
  Option.value (List.find_map channel model) ~default:[]

let cap () =
  let north c = features (solid "sphere(2)" (Printf.sprintf "cap((0, 0, 1), %s)" c)) in
  (* The zones end at 60, 30, 0, -30, -60 degrees: cosines with the axis of about 1/2 and 866/1000. *)
  Alcotest.(check int) "one zone" 12 (List.length (north "2/3"));
  Alcotest.(check int) "two zones" 24 (List.length (north "1/3"));
  Alcotest.(check int) "half the ball" 36 (List.length (north "0"));
  Alcotest.(check bool) "closed faces" true (List.for_all (fun (only, _) -> not only) (north "0"));
  let rest = features (solid "sphere(2)" "surface() ∖ cap((0, 0, 1), 0)") in
  let has name = List.exists (fun (_, f) -> String.equal f name) rest in
  Alcotest.(check bool) "the other half, without the equator" true (has "f3_1" && (not (has "f4_1")) && not
                                                                      (has "v3_1"));
  Alcotest.(check bool) "open along it" true (List.mem (true, "f3_1") rest)

let strips () =
  let found = features (solid "cylinder(1, 4)" "cap((1, 0, 0), 1/2)") in
  Alcotest.(check bool) "of the side alone" true
    (found <> [] && List.for_all (fun (_, f) -> String.length f > 4 && String.sub f 0 4 = "side") found);
  Alcotest.(check bool) "not all of it" true (List.length found < 12);
  Alcotest.(check bool) "of a cone as well" true (features (solid "cone(1, 4)" "cap((0, 1, 0), 1/2)") <> [])

let suite =
  ("curved solids",
   [
     ( "polyhedra",
       [
         Alcotest.test_case "Regions: balls are convex, with vertices on the sphere" `Quick balls;
         Alcotest.test_case "Regions: distances of balls" `Quick distances;
         Alcotest.test_case "Regions: distances of discs" `Quick discs;
         Alcotest.test_case "the least distance" `Quick least;
       ] );
     ( "caps",
       [ Alcotest.test_case "Regions: caps of a ball" `Quick cap; Alcotest.test_case "strips" `Quick strips ] );
   ])
