(* Rigid motion as declared (rule Turn): when a model is rigid, its settings, and the motion of what is bound. *)

open Scc_exact
open Scc_calculus
open Models
open Fault_case

let half_cube = cube ^ "shape Half = Cube scaled (1/2, 1/2, 1/2)\n"
let rigid text = (accept text).model.rigid
let same name expected x = Alcotest.(check string) name expected (Rat.to_string x)
let vector name expected x = Alcotest.(check string) name expected (Vec.to_string x)

let settings text =
  match rigid text with
  | Some r -> r
  | None -> Alcotest.fail "the model was to be rigid"

let is_free (r : Model.rigid) = match r.dynamics with Free_body -> true | Constant_spin -> false

let whether () =
  let body = "process p = Cube mass 1 " in
  let is_rigid text = Option.is_some (rigid (cube ^ text)) in
  Alcotest.(check bool) "nothing spins" false (is_rigid (body ^ "spin (0, 0, 0) [nil]"));
  Alcotest.(check bool) "a spin" true (is_rigid (body ^ "spin (0, 0, 1) [nil]"));
  Alcotest.(check bool) "dynamics" true (is_rigid (body ^ "[nil] dynamics constant_spin"));
  Alcotest.(check bool) "a spin that is left out" false
    (is_rigid (body ^ "spin (0, 0, 1) [nil] process q = Cube mass 1 at translate (9, 0, 0) [nil] network q"));
  let t = accept (cube ^ body ^ "[nil] dynamics constant_spin") in
  Alcotest.(check bool) "no law of motion" false t.model.steered;
  Alcotest.(check bool) "no step" true (Option.is_none t.declared.step)

let unstated () =
  let warned text = List.map (fun (d : Scc_base.Diag.t) -> d.code) (accept (cube ^ text)).warnings in
  let check what expected text = Alcotest.(check (list string)) what expected (warned text) in
  check "a spin" [ "SC0215" ] "process p = Cube mass 1 spin (0, 0, 1) [nil]";
  check "one warning for two" [ "SC0215" ]
    "process p = Cube mass 1 spin (0, 0, 1) [nil] \
     process q = Cube mass 1 spin (0, 0, 1) at translate (9, 0, 0) [nil]";
  check "said" [] "process p = Cube mass 1 spin (0, 0, 1) [nil] dynamics constant_spin";
  check "no spin" [] "process p = Cube mass 1 spin (0, 0, 0) [nil]"

let values () =
  let r = settings (cube ^ "process p = Cube mass 1 spin (0, 0, 1) [nil]") in
  Alcotest.(check bool) "constant spin" false (is_free r);
  Alcotest.(check (option int)) "not rounded" None r.round_orientation;
  let text =
    cube ^ "param n = 7 dynamics free_body resolution 1/n round orientation 1/1024 round velocity 2^-3 \
            process p = Cube mass 1 [nil]"
  in
  let r = settings text in
  Alcotest.(check bool) "free body" true (is_free r);
  same "resolution" "1/7" r.resolution;
  Alcotest.(check (option int)) "orientation" (Some 10) r.round_orientation;
  Alcotest.(check (option int)) "velocity" (Some 3) (accept text).model.round_velocity

(* Cubes of edge 2 and 1: of a network without the smaller, the greater counts. *)
let resolution () =
  let two =
    "process p = Cube mass 1 [nil] process q = Half mass 1 at translate (5, 0, 0) [nil] dynamics free_body "
  in
  same "of the smallest edge" "1/1048576" (settings (half_cube ^ two)).resolution;
  same "of the network" "1/524288" (settings (half_cube ^ two ^ "network p")).resolution;
  let scaled factor =
    (settings (cube ^ Printf.sprintf "process p = Cube scaled (%s, 9, 9) mass 1 [nil] dynamics free_body" factor))
    .resolution
  in
  (* Edges of 3, of 4 less a little, of 4, and of 2/3: between powers of two, the lower. *)
  same "3" "1/524288" (scaled "3/2");
  same "almost 4" "1/524288" (scaled "1.999999999");
  same "4" "1/262144" (scaled "2");
  same "2/3" "1/2097152" (scaled "1/3")

let process text = (accept text).declared.processes.(0)

let one () =
  let body = "process p = Cube mass 1 velocity (1, 0, 0) spin (0, 0, 2) at translate (7, 0, 0) [nil]" in
  let p = process (cube ^ body) in
  vector "velocity" "(1, 0, 0)" p.velocity;
  vector "spin" "(0, 0, 2)" p.spin;
  same "since" "0" p.since;
  Alcotest.(check bool) "not turned" true (Quaternion.is_identity p.leaves.(0).turned)

(* The centres of two cubes of masses 1 and 3 are 2 apart: the whole turns about a point 3/2 from the first. *)
let bound () =
  let pair first second =
    Printf.sprintf
      "%sprocess p = a : Cube mass 1 velocity %s spin (0, 0, 2) [nil] <x, {a.right, b.left}> \
       b : Cube mass 3 velocity %s spin (0, 0, 2) at translate (2, 0, 0) [nil]" cube first second
  in
  let p = process (pair "(1, -3, 0)" "(1, 1, 0)") in
  vector "velocity" "(1, 0, 0)" p.velocity;
  vector "spin" "(0, 0, 2)" p.spin;
  match elaborate (pair "(1, 0, 0)" "(1, 0, 0)") with
  | Ok _ -> Alcotest.fail "accepted parts that come apart"
  | Error _ -> ()

let compound () =
  let text =
    cube
    ^ "compound C { part l : Cube mass 1 velocity (0, -3, 0) spin (0, 0, 2) \
       part r : Cube mass 3 velocity (0, 1, 0) spin (0, 0, 2) at translate (2, 0, 0) glue l.right ~ r.left }\n"
  in
  let p = process (text ^ "process p = C [nil]") in
  vector "velocity of the parts" "(0, 0, 0)" p.velocity;
  vector "spin of the parts" "(0, 0, 2)" p.spin;
  let p = process (text ^ "process p = C velocity (0, 0, 1) spin (1, 0, 0) [nil]") in
  vector "its own velocity" "(0, 0, 1)" p.velocity;
  vector "its own spin" "(1, 0, 0)" p.spin

let atoms () =
  let t =
    accept
      (cube ^ "process p = Cube mass 1 spin (0, 0, 1) [nil] \
               check k : always wx(p) + wy(p) + wz(p) < spin2(p) + angular.x + angular.y + angular.z")
  in
  let check = List.hd t.checks in
  Alcotest.(check string) "shown"
    "AG ((wx(p) + wy(p)) + wz(p)) < (((spin2(p) + angular.x) + angular.y) + angular.z)"
    (Scc_property.Show.temporal t.model check.formula)

(* {1 Faults} *)

let faults =
  let flush = "process q = Cube mass 1 " and bond = " bond <a, {p.right, q.left}>" in
  let bound p q =
    cube ^ "process p = Cube mass 1 " ^ p ^ " [nil] " ^ flush ^ q ^ " at translate (2,0,0) [nil]" ^ bond
  in
  [
    case "unknown dynamics" "SC0201" "constant" ~says:"constant_spin or free_body" "dynamics constant";
    case "rounding of something else" "SC0201" "orientatoin" ~says:"did you mean `orientation`"
      "round orientatoin 2^-8";
    case "dynamics twice" "SC0212" "free_body" "dynamics constant_spin dynamics free_body";
    case "resolution twice" "SC0212" "2^-3" "dynamics free_body resolution 1/7 resolution 2^-3";
    case "rounding twice" "SC0212" "velocity" "dynamics free_body round velocity 2^-3 round velocity 2^-4";
    case "a resolution that is not positive" "SC0208" "0" "dynamics free_body resolution 0";
    case "a quantum that is no power of two" "SC0208" "1/10" ~says:"a power of two" "round velocity 1/10";
    case "a quantum of one" "SC0208" "1" ~says:"at most 1/2" "round orientation 1";
    case "a power of two above one" "SC0208" "4" "round orientation 4";
    case "a power of two with too many digits" "SC0106" "2^-4001" "resolution 2^-4001";
    case "a setting in a loop" "SC0210" "dynamics free_body" "for i in 1..2 { dynamics free_body }";
    case "a resolution where nothing turns" "SC0213" "1/8" (cube ^ "process p = Cube mass 1 [nil] resolution 1/8");
    case "rounding where nothing turns" "SC0213" "orientation"
      (cube ^ "process p = Cube mass 1 spin (0, 0, 0) [nil] round velocity 1/8 round orientation 1/8");
    case "parts with two spins" "SC0404" "spin (0,0,1)" ~says:"the spins (0, 0, 0) and (0, 0, 1)"
      (cube ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 spin (0,0,1) at translate (2,0,0) \
               glue l.right ~ r.left }");
    case "parts that do not turn as one" "SC0404" "r" ~says:"the velocity of `r` is (0, 2, 0)"
      (cube ^ "compound C { part l : Cube mass 1 spin (0,0,1) part r : Cube mass 1 spin (0,0,1) \
               at translate (2,0,0) glue l.right ~ r.left }");
    case "bound bodies with two spins" "SC0404" "<a, {p.right, q.left}>" ~says:"turns as one"
      (bound "spin (0,0,1)" "");
    case "bound bodies that do not turn as one" "SC0404" "<a, {p.right, q.left}>"
      ~says:"the velocity of `q` is (1, 2, 0)"
      (bound "velocity (1,0,0) spin (0,0,1)" "velocity (1,0,0) spin (0,0,1)");
    case "a spinning body bound to a wall" "SC0404" "<a, {p.right, q.left}>" ~says:"the spin (0, 0, 1)"
      (cube ^ "process p = Cube mass 1 spin (0,0,1) [nil] fixed q = Cube at translate (2,0,0)" ^ bond);
    case "a fixed body that spins" "SC0407" "spin (0,0,1)" (cube ^ "fixed p = Cube spin (0,0,1)");
    case "a fixed compound that spins" "SC0407" "p"
      (cube ^ "compound C { part l : Cube mass 1 spin (0,0,1) } fixed p = C");
  ]

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("turning bodies",
   [
     ( "models",
       [
         case "when rigid" whether; case "settings" values; case "a spin without dynamics" unstated;
         case "the default resolution" resolution;
       ] );
     ("properties", [ case "atoms" atoms ]);
     ("faults", cases faults);
     ( "motion",
       [ case "of one leaf" one; case "of several leaves" bound; case "of compounds" compound ] );
   ])
