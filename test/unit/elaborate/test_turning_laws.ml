(* Laws of motion that give spins (rules Steer, Draw and Diffuse, reading I-24), from models as texts. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_elaborate
open Models
open Fault_case

let vector name expected x = Alcotest.(check string) name expected (Vec.to_string x)
let ok = function Ok x -> x | Error _ -> Alcotest.fail "a law of motion could not be evaluated"

type run = { c : Semantics.t; first : State.t }

let start text =
  let t = accept text in
  let c = Scc_engine.Standard.of_model t.model in
  { c; first = ok (Network.initial c t.declared) }

let successors r s = ok (Network.successors r.c s)

let labels r s =
  List.map (fun (t : Transition.t) -> Transition.label_to_string (Semantics.model r.c) t.label) (successors r s)

let spin (s : State.t) i = s.processes.(i).spin

(* {1 What laws give} *)

let after r s = match successors r s with [ t ] -> t.target | _ -> Alcotest.fail "one transition was expected"

let settings = "dynamics constant_spin timestep 1/2\n"
let two = "process p = box(2, 1, 1) mass 1 velocity (1, 0, 0) [nil]\n"

let sees () =
  let r = start (settings ^ two ^ "motion p = (vx, vy, vz) spin (wx + x, wy + dt, wz + mass/4)") in
  vector "at the start" "(0, 0, 1/4)" (spin r.first 0);
  let s = after r r.first in
  vector "a step later" "(1/2, 1/2, 1/2)" (spin s 0);
  vector "its velocity" "(1, 0, 0)" s.processes.(0).velocity

let stays () =
  let spins = "process p = box(2, 1, 1) mass 1 spin (0, 0, 1/3) [nil]\n" in
  let r = start (settings ^ spins ^ "motion p = (1, 0, 0)") in
  vector "a law without a spin leaves it" "(0, 0, 1/3)" (spin (after r r.first) 0)

(* Two cubes of the masses 1 and 3, bound. *)
let pair =
  "shape Cube = box(2, 2, 2)\nprocess p = Cube mass 1 spin (0, 0, 1) velocity (0, -3/2, 0) [nil]\n\
   process q = Cube mass 3 spin (0, 0, 1) velocity (0, 1/2, 0) at translate (2, 0, 0) [nil]\n\
   bond <a, {p.right, q.left}>\n"

let compound () =
  let r = start (settings ^ pair ^ "motion p = (vx, vy, vz) spin (0, 0, 3)") in
  vector "a leaf's change by its mass" "(0, 0, 3/2)" (spin r.first 0);
  let r = start (settings ^ pair ^ "motion (0, 0, 0) spin (1, 2, 3)") in
  vector "what all leaves give" "(1, 2, 3)" (spin r.first 0);
  let r = start (settings ^ pair ^ "motion (vx, vy, vz) spin (wx, wy, wz)") in
  vector "no change" "(0, 0, 1)" (spin r.first 0);
  let r =
    start (settings ^ pair ^ "motion p = choose { (vx, vy, vz) spin (0, 0, 1), (vx, vy, vz) spin (0, 0, 5) }\n\
                              motion q = choose { (vx, vy, vz), (vx, vy, vz) spin (4, 0, 1) weight 2 }")
  in
  Alcotest.(check (list string)) "each leaf draws by itself"
    [
      "draw(p, (0, 0, 0) spin (0, 0, 1)) chance(1/6)"; "draw(p, (0, 0, 0) spin (0, 0, 2)) chance(1/6)";
      "draw(p, (0, 0, 0) spin (3, 0, 1)) chance(1/3)"; "draw(p, (0, 0, 0) spin (3, 0, 2)) chance(1/3)";
    ]
    (labels r r.first)

let draws () =
  let r =
    start
      (settings ^ "process p = box(2, 1, 1) mass 1 spin (0, 1, 0) [nil]\n\
                   motion p = choose { (0, 0, 0) spin (0, 1, 0), (0, 0, 0), (0, 0, 0) spin (0, 0, 1) weight 2 }")
  in
  Alcotest.(check (list string)) "a motion without a spin is one with the spin that there is"
    [ "draw(p, (0, 0, 0) spin (0, 0, 1)) chance(1/2)"; "draw(p, (0, 0, 0) spin (0, 1, 0)) chance(1/2)" ]
    (labels r r.first);
  let s = (List.hd (successors r r.first)).target in
  vector "what was drawn" "(0, 0, 1)" (spin s 0)

(* The angular momentum is that of the spin that was given, and turns keep it. *)
let free () =
  let r = start ("dynamics free_body timestep 1/2\n" ^ two ^ "motion p = (0, 0, 0) spin (1, 1, 0)") in
  let m = Semantics.model r.c in
  (* of a box of the edges 2, 1, 1 and the mass 1: (1 + 1)/12, (4 + 1)/12, (4 + 1)/12 *)
  vector "the angular momentum" "(1/6, 5/12, 0)" r.first.processes.(0).kept;
  vector "the spin while a turn is due" "(1, 1, 0)" (Turn.renew m r.first.processes.(0)).spin

let rigid () =
  let warned text = List.map (fun (d : Scc_base.Diag.t) -> d.code) (accept text).warnings in
  let law = "process p = box(1, 1, 1) mass 1 [nil] motion p = (0, 0, 0) spin (0, 0, wz)" in
  Alcotest.(check bool) "a law that gives a spin" true (Option.is_some (accept law).model.rigid);
  Alcotest.(check (list string)) "which is to be said" [ "SC0215" ] (warned law);
  Alcotest.(check (list string)) "and is said" [] (warned ("dynamics free_body " ^ law));
  Alcotest.(check bool) "to see it is not enough" false
    (Option.is_some (accept "process p = box(1, 1, 1) mass 1 [nil] motion p = (wz, 0, 0)").model.rigid)

(* {1 Moments of orientation}

   By the rules: all draws of three steps, each with its chance. *)

let steps = 3

let mean r m f =
  let rec from s chance =
    let until = Rat.mul (Rat.of_int steps) m.Model.timestep in
    if Rat.compare (Option.get s.State.time) until >= 0 then Rat.mul chance (f s.processes.(0).leaves.(0).turned)
    else
      List.fold_left
        (fun sum (t : Transition.t) -> Rat.add sum (from t.target (Rat.mul chance (Transition.chance t.label))))
        Rat.zero (successors r s)
  in
  from r.first Rat.one

let correlations () =
  let axes = [ Vec.of_ints 1 0 0; Vec.of_ints 0 1 0; Vec.of_ints 0 0 1 ] in
  let check (timestep, (x, y, z)) =
    let law = Printf.sprintf "diffuse(0, turning = (%s, %s, %s))" x y z in
    let text =
      Printf.sprintf
        "dynamics constant_spin timestep %s\nprocess p = box(2, 1, 1) mass 1 [nil]\nmotion p = %s\n\
         check c : always time >= 0" timestep law
    in
    let r = start text and number text = Result.get_ok (Rat.of_literal text) in
    let step = number timestep and x = number x and y = number y and z = number z in
    let one (u, c) =
      let kept = Rat.sub Rat.one (Rat.mul step c) in
      let all = Rat.mul kept (Rat.mul kept kept) in
      let other v =
        let found = mean r (Semantics.model r.c) (fun q -> Vec.dot v (Quaternion.apply q u)) in
        Alcotest.(check string) (law ^ " in " ^ timestep)
          (Rat.to_string (if Vec.equal u v then all else Rat.zero))
          (Rat.to_string found)
      in
      List.iter other axes
    in
    List.iter one (List.combine axes [ Rat.add y z; Rat.add x z; Rat.add x y ])
  in
  List.iter check
    [
      ("1/4", ("1/8", "1/8", "1/8")); ("1", ("1/10", "0", "1/30")); ("1/3", ("1", "1/2", "1"));
      ("2", ("0", "0", "1/20")); ("1/2", ("0", "0", "0"));
    ]

(* A step by a step; and what is drawn of the velocity is what it would be without turns, and independent. *)
let independent () =
  let shares law =
    let r = start (settings ^ two ^ "motion p = " ^ law) in
    List.filter_map
      (fun (t : Transition.t) ->
         match t.label with Draw { given; chance; _ } -> Some (given, chance) | _ -> None)
      (successors r r.first)
  in
  let alone = shares "diffuse((1/8, 1/2, 0), (0, 0, 1))" in
  let both = shares "diffuse((1/8, 1/2, 0), (0, 0, 1), turning = 1/4)" in
  let spins = shares "diffuse(0, turning = 1/4)" in
  let chance list v w =
    List.fold_left
      (fun sum ((g : Given.t), c) ->
         let fits = Option.fold ~none:true ~some:(Vec.equal g.velocity) v in
         let fits = fits && Option.fold ~none:true ~some:(fun w -> Option.equal Vec.equal g.spin (Some w)) w in
         if fits then Rat.add sum c else sum)
      Rat.zero list
  in
  Alcotest.(check int) "all pairs" (List.length alone * List.length spins) (List.length both);
  let check ((g : Given.t), c) =
    let spin = Option.get g.spin in
    let product = Rat.mul (chance alone (Some g.velocity) None) (chance spins None (Some spin)) in
    Alcotest.(check string) (Given.to_string g) (Rat.to_string product) (Rat.to_string c)
  in
  List.iter check both

(* The least power of two, and the greatest sum of constants. *)
let least_spin () =
  let check what expected ~timestep c =
    let found =
      match Diffusion.turns ~timestep c with
      | Ok (spin, _) -> Rat.to_string spin
      | Error most -> "at most " ^ Rat.to_string most
    in
    Alcotest.(check string) what expected found
  in
  let of_sum sum = Vec.make (Rat.mul Rat.half sum) Rat.zero (Rat.mul Rat.half sum) in
  let q a b = Rat.make (Z.of_int a) (Z.of_int b) in
  check "a tangent of 1/4" "1/2" ~timestep:Rat.one (of_sum (q 2 17));
  check "a little more" "1" ~timestep:Rat.one (of_sum (q 2001 17000));
  check "a little" "1/16" ~timestep:Rat.one (of_sum (q 2 1025));
  check "in a timestep of 1/4" "2" ~timestep:(q 1 4) (of_sum (q 8 17));
  check "none" "0" ~timestep:Rat.one Vec.zero;
  check "the most" "2" ~timestep:Rat.one (of_sum (q 115200 83521));
  check "more than that" "at most 230400/83521" ~timestep:(q 1 2) (of_sum (q 230401 83521))

(* {1 Faults} *)

let faults =
  let law text = "dynamics constant_spin process p = box(1, 1, 1) mass 1 [nil] motion p = " ^ text in
  [
    case "a spin that is no vector" "SC0205" "wx" (law "(0, 0, 0) spin wx");
    case "a spin in a choice that is no vector" "SC0205" "1" (law "choose { (0, 0, 0) spin 1 }");
    case "a spin beside diffuse" "SC0205" "(0, 0, 1)" ~says:"no spin beside it" (law "diffuse(1) spin (0, 0, 1)");
    case "a spin beside inertial" "SC0110" "spin" (law "inertial spin (0, 0, 1)");
    case "a constant that depends on the state" "SC0601" "wx" (law "diffuse(1, turning = wx)");
    case "a negative constant of turning" "SC0601" "-1" ~says:"negative" (law "diffuse(1, turning = -1)");
    case "turning twice" "SC0201" "turning" (law "diffuse(1, turning = 1/9, turning = 1/9)");
    case "turning too fast" "SC0601" "diffuse(1, turning = 1)" ~says:"more than 115200/83521"
      (law "diffuse(1, turning = 1)");
    case "a spin that cannot be evaluated at all" "SC0207" "1/(2 - 2)" (law "(0, 0, 0) spin (1/(2 - 2), 0, 0)");
  ]

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("laws that turn",
   [
     ( "Steer",
       [
         case "Steer: what a law with a spin sees and gives" sees; case "Steer: a law without a spin" stays;
         case "Steer: spins of a compound" compound; case "Steer: the angular momentum of a free body" free;
         case "Steer: when rigid" rigid;
       ] );
     ("Draw", [ case "Draw: spins" draws ]);
     ( "Diffuse",
       [
         case "Diffuse: correlations of three steps" correlations;
         case "Diffuse: orientation and place are independent" independent;
         case "Diffuse: the least spin" least_spin;
       ] );
     ("faults", cases faults);
   ])
