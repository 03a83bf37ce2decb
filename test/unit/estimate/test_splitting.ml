(* Rare events by splitting, beside exact probabilities. *)

open Scc_exact
open Scc_estimate
open Scc_test_models
open Counting

let walker =
  Load.read "../../../specs/models/far.sc"
  |> String.split_on_char '\n'
  |> List.filter (fun line -> not (String.length line > 5 && String.sub line 0 5 = "check"))
  |> String.concat "\n"

(* Two walkers: a level is passed in many states. *)
let two =
  walker
  ^ "process other = solids.Cube(1) mass 1 at translate (0, 9, 0) [nil]\n\
     motion other = choose { (1, 0, 0), (-1, 0, 0), (2, 0, 0) }\n"

let plan ?(steps = 10_000) text property ~levels ~effort =
  let states = List.mapi (fun i level -> Printf.sprintf "check level%d : possibly (%s)\n" i level) levels in
  let e = Load.exactly (Load.text (text ^ "\ncheck asked : " ^ property ^ "\n" ^ String.concat "" states)) in
  let named name = List.find (fun (c : Scc_property.Property.check) -> c.name = name) e.checks in
  let path = Result.get_ok (Path.of_check e.model (named "asked")) in
  let goal, horizon = Option.get (Splitting.goal path) in
  let level i _ =
    match (named (Printf.sprintf "level%d" i)).formula with
    | Finally (_, _, State p) -> p
    | _ -> Alcotest.fail "no level"
  in
  let semantics = Scc_engine.Standard.of_model e.model in
  let initial = Result.get_ok (Scc_semantics.Network.initial semantics e.declared) in
  let exact =
    match (Scc_verify.Check.run Scc_verify.Setup.default semantics ~initial [ named "asked" ]).outcomes with
    | [ { verdict = Measured { values = (_, { Scc_ctl.Eval.least = Exact p; _ }) :: _; _ }; _ } ] -> p
    | _ -> Alcotest.failf "%s has no exact value" property
  in
  ( { Splitting.semantics; declared = e.declared; goal; horizon; levels = List.mapi level levels; effort; steps },
    exact )

let repetitions plan ~seed n = List.init n (Splitting.repeat plan ~seed ~interrupted:(fun () -> false))

(* The mean of many estimates is within five deviations of the probability. *)
let without_bias () =
  let one (text, property, levels) =
    let plan, exact = plan text property ~levels ~effort:6 in
    let n = 600 in
    let all = List.map (Splitting.estimate plan) (repetitions plan ~seed:3L n) in
    let sum f = List.fold_left (fun s x -> Rat.add s (f x)) Rat.zero all in
    let mean = Rat.div (sum Fun.id) (Rat.of_int n) in
    let variance = Rat.div (sum (fun x -> Rat.mul (Rat.sub x mean) (Rat.sub x mean))) (Rat.of_int (n * n)) in
    let off = Rat.sub mean exact in
    if Rat.sign variance = 0 || Rat.compare (Rat.mul off off) (Rat.mul (Rat.of_int 25) variance) > 0 then
      Alcotest.failf "%s: %f, not %f" property (Rat.to_float mean) (Rat.to_float exact)
  in
  let x a = "not gone(walker) and x(walker) >= " ^ a in
  List.iter one
    [
      (walker, "P = ? [ eventually (" ^ x "4" ^ ") ]", [ x "1"; x "2"; x "3" ]);
      (walker, "P = ? [ eventually (" ^ x "4" ^ ") within 9 ]", [ x "1"; x "2"; x "3" ]);
      (* The goal holds while time passes, and levels are not all passed before. *)
      (walker, "P = ? [ eventually (" ^ x "5/2" ^ ") within 13/2 ]", [ x "3"; x "1"; x "2" ]);
      ( walker,
        "P = ? [ eventually event absorb(walker, ruin) within 8 ]",
        [ "not gone(walker) and x(walker) <= -1" ] );
      (two, "P = ? [ eventually (x(other) >= 5) within 5 ]", [ "x(other) >= 2"; "x(other) >= 3" ]);
    ]

(* How often the ends miss, of so many experiments of 20 repetitions. *)
let on_a_line ~count () =
  let x a = "not gone(walker) and x(walker) >= " ^ string_of_int a in
  let levels = List.init 5 (fun i -> x (i + 1)) in
  let plan, exact = plan walker ("P = ? [ eventually (" ^ x 6 ^ ") ]") ~levels ~effort:8 in
  let miss = fraction 1 10 in
  let one i =
    let all = repetitions plan ~seed:(Int64.of_int (100 + i)) 20 in
    Option.get (Splitting.summary plan all ~confidence:(Rat.sub Rat.one miss))
  in
  let all = List.init count one in
  let counted test = List.length (List.filter test all) in
  let low (s : Splitting.summary) = Rat.compare s.low exact > 0 in
  let high (s : Splitting.summary) = Rat.compare s.high exact < 0 in
  few_missed "the proved ends" ~count ~miss (counted (fun s -> low s || high s));
  few_missed "the end that is not proved" ~count ~miss (counted (fun s -> Rat.compare s.likely exact < 0));
  Alcotest.(check bool) "it is of the size" true
    (List.for_all (fun s -> Rat.compare s.Splitting.likely (Rat.mul (Rat.of_int 12) exact) < 0) all)

(* Runs that are left make the estimate less, and take the upper end away. *)
let left () =
  let x a = "not gone(walker) and x(walker) >= " ^ a in
  let plan, _ = plan ~steps:3 walker ("P = ? [ eventually (" ^ x "4" ^ ") ]") ~levels:[ x "2" ] ~effort:10 in
  let s = Option.get (Splitting.summary plan (repetitions plan ~seed:1L 20) ~confidence:(fraction 9 10)) in
  Alcotest.(check bool) "some are left" true (s.left > 0 && Rat.equal s.high Rat.one && Rat.equal s.likely Rat.one)

let texts () =
  let check text expected =
    let found = match Splitting.levels text with Ok levels -> levels | Error _ -> [ "refused" ] in
    Alcotest.(check (list string)) text expected found
  in
  check "x(p) >= 1, 2, 5/2" [ "x(p) >= 1"; "x(p) >= 2"; "x(p) >= 5/2" ];
  check "distance2(p, q) < 9, 4" [ "distance2(p, q) < 9"; "distance2(p, q) < 4" ];
  check "x(p)>-2..0, 7" [ "x(p)> -2"; "x(p)> -1"; "x(p)> 0"; "x(p)> 7" ];
  check "x(p) >= 2, 1" [ "refused" ];
  check "x(p) <= 1..2" [ "refused" ];
  check "x(p)" [ "refused" ]

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "splitting"
    [
      ( "splitting",
        [
          case "Splitting: without bias" without_bias; case "Splitting: a walker on a line" (on_a_line ~count:20);
          case "runs that are left" left; case "levels" texts;
        ] );
    ]
