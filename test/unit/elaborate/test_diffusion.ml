(* Rule Diffuse: kicks whose first and second moments are those of diffusion with drift. *)

open Scc_exact
open Scc_calculus
open Scc_elaborate
module Gen = QCheck2.Gen

let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let const q = Law.Const q
let sum = List.fold_left Rat.add Rat.zero

let value e =
  match Law.eval (fun _ -> Rat.of_int 7) e with Ok v -> v | Error _ -> Alcotest.fail "an expression has no value"

let displacement ~timestep (k : Law.kick) =
  let x, y, z = k.motion.velocity in
  List.map (fun e -> Rat.mul timestep (value e)) [ x; y; z ]

let mean kicks f = sum (List.map (fun (k : Law.kick) -> Rat.mul (value k.weight) (f k)) kicks)
let pairs = [ (0, 0); (0, 1); (0, 2); (1, 1); (1, 2); (2, 2) ]

(* By summation over all kicks, for any constants, drift, timestep and kick that is long enough. *)
let moments =
  let gen =
    let open Gen in
    let part = map2 q (0 -- 9) (1 -- 6) and speed = map2 q (-5 -- 5) (1 -- 4) in
    let* d = triple part part part and* drift = triple speed speed speed in
    let+ timestep = map2 q (1 -- 7) (1 -- 5) and* longer = map2 q (4 -- 12) (1 -- 4) in
    (d, drift, timestep, Rat.max longer Rat.one)
  in
  let print ((x, y, z), _, timestep, longer) =
    Printf.sprintf "d %s, timestep %s, kick times %s"
      (Vec.to_string (Vec.make x y z))
      (Rat.to_string timestep) (Rat.to_string longer)
  in
  QCheck2.Test.make ~name:"Diffuse: moments of a step" ~count:250 ~print gen
    (fun ((dx, dy, dz), (wx, wy, wz), timestep, longer) ->
       let d = Vec.make dx dy dz and w = [ wx; wy; wz ] in
       let drift = (const wx, const wy, Law.Add (Var Vz, const (Rat.sub wz (Rat.of_int 7)))) in
       let kick = Rat.mul longer (Diffusion.least_kick ~timestep d) in
       match Diffusion.kicks ~timestep ~drift ~kick d with
       | Error _ -> QCheck2.Test.fail_report "the least kick is too short"
       | Ok kicks ->
         let coordinate i k = List.nth (displacement ~timestep k) i in
         let off i k = Rat.sub (coordinate i k) (Rat.mul timestep (List.nth w i)) in
         let variance i j =
           if i <> j then Rat.zero else Rat.mul (Rat.of_int 2) (Rat.mul timestep (List.nth [ dx; dy; dz ] i))
         in
         List.for_all (fun (k : Law.kick) -> Rat.sign (value k.weight) > 0) kicks
         && Rat.equal (mean kicks (fun _ -> Rat.one)) Rat.one
         && List.for_all (fun i -> Rat.sign (mean kicks (off i)) = 0) [ 0; 1; 2 ]
         && List.for_all
           (fun (i, j) -> Rat.equal (mean kicks (fun k -> Rat.mul (off i k) (off j k))) (variance i j))
           pairs)

let least () =
  let check what expected ~timestep d =
    Alcotest.(check string) what expected (Rat.to_string (Diffusion.least_kick ~timestep d))
  in
  let all d = Vec.make d d d in
  check "1 where it is just long enough" "1" ~timestep:Rat.one (all (q 1 6));
  check "2 a little above" "2" ~timestep:Rat.one (all (q 1001 6000));
  check "1/2 at a quarter" "1/2" ~timestep:(q 1 4) (all (q 1 6));
  check "large" "64" ~timestep:Rat.one (all (Rat.of_int 600));
  check "1 for nothing" "1" ~timestep:Rat.one Vec.zero;
  let still = (const Rat.zero, const Rat.zero, const Rat.zero) in
  match Diffusion.kicks ~timestep:Rat.one ~drift:still ~kick:Rat.one (all Rat.one) with
  | Ok _ -> Alcotest.fail "a kick that is too short"
  | Error least -> Alcotest.(check string) "the least square" "6" (Rat.to_string least)

(* {1 Kicks as models give them} *)

let model laws =
  Models.cube ^ "timestep 1/4 steady\nparam h = 3\n"
  ^ "process p = Cube mass 1 [nil]\nprocess q[1] = Cube mass 1 at translate (9,0,0) [nil]\n"
  ^ "process q[2] = Cube mass 1 at translate (18,0,0) [nil]\nfixed w = Cube at translate (0,9,0)\n" ^ laws

let laws_of text = Array.map (fun (l : Model.leaf) -> l.law) (Models.accept (model text)).model.leaves

(* The same law as by places; the name stands beside values of the same name, and last. *)
let by_name () =
  let same a b =
    Alcotest.(check bool) (a ^ ", " ^ b) true
      (Array.for_all2 Law.equal (laws_of ("motion " ^ a)) (laws_of ("motion " ^ b)))
  in
  same "diffuse(1/2, h = 2)" "diffuse(1/2, (0, 0, 0), 2)";
  same "diffuse(1/2, (vx, 0, 1), h = 2)" "diffuse(1/2, (vx, 0, 1), 2)";
  same "diffuse((1/2, 0, 0), h = h + 1)" "diffuse((1/2, 0, 0), (0, 0, 0), 4)";
  same "diffuse(1/2)" "diffuse(1/2, h = 1)";
  let refused law code =
    match Models.elaborate (model ("motion " ^ law)) with
    | Ok _ -> Alcotest.fail (law ^ " is accepted")
    | Error (d :: _) -> Alcotest.(check string) law code d.code
    | Error [] -> Alcotest.fail "no diagnostic"
  in
  same "diffuse(1/2, turning = 1/4, h = 2)" "diffuse(1/2, h = 2, turning = 1/4)";
  refused "diffuse(turning = 2)" "SC0206";
  refused "diffuse(1/2, (0, 0, 0), 2, h = 2, turning = 0)" "SC0206";
  refused "diffuse(h = 2)" "SC0206";
  refused "diffuse(1/2, (0, 0, 0), 2, h = 2)" "SC0206";
  refused "diffuse(1/2, k = 2)" "SC0201";
  refused "diffuse(1/2, h = 0)" "SC0601";
  refused "diffuse(1/2, h = 1/2)" "SC0601";
  refused "diffuse(1/2, h = x)" "SC0601"

let in_reports () =
  let check what expected text =
    let t = Models.accept (model text) in
    let text = Option.value (Lattices.line t.lattices) ~default:"" in
    Alcotest.(check (pair string string)) what expected (text, Lattices.kicks t.lattices)
  in
  let chosen = "the least power of two whose square is no less than " in
  check "none" ("", "") "motion choose { (1, 0, 0), (-1, 0, 0) }";
  check "given" ("kick 3", "3") "motion diffuse(1/2, h = h)";
  check "chosen" ("kick 1, kick chosen as " ^ chosen ^ "3/4", "1") "motion diffuse(1/2)";
  check "several"
    ("kick of p 2, kick of q 1, kick of q chosen as " ^ chosen ^ "3/4", "p 2; q 1")
    "motion diffuse(1/2)\nmotion p = diffuse(1/2, h = 2)";
  check "of bodies that take part" ("kick 2", "2")
    "motion diffuse(1/2)\nmotion p = diffuse(1/2, h = 2)\nnetwork p || w"

let suite =
  ("diffusion",
   [
     ( "Diffuse",
       Scc_test_support.Property.cases [ moments ]
       @ [
         Alcotest.test_case "Diffuse: the least kick" `Quick least;
         Alcotest.test_case "Diffuse: a kick by its name" `Quick by_name;
         Alcotest.test_case "Diffuse: lattices in reports" `Quick in_reports;
       ] );
   ])
