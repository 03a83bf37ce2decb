(* When it is said that event times grow ever slower. *)

open Scc_exact
open Scc_semantics
open Scc_verify
open Scc_test_models

let instants gap n =
  let rec from k t all = if k > n then List.rev all else
      let t = Rat.add t (gap k) in
      from (k + 1) t (t :: all)
  in
  from 1 Rat.zero [ Rat.zero ]

let over k = Rat.make Z.one (Z.of_int k)

let gaps () =
  let said what expected gap n =
    Alcotest.(check bool) what expected (Option.is_some (Slowing.of_instants (instants gap n)))
  in
  said "constant" false (fun _ -> Rat.one) 100;
  said "1/n diverges" false over 400;
  said "1/n^2" true (fun k -> over (k * k)) 400;
  said "1/2^n" true (fun k -> Rat.make Z.one (Z.shift_left Z.one k)) 40;
  said "too few to tell" false (fun k -> over (k * k)) 23;
  said "enough" true (fun k -> over (k * k)) 24;
  said "at first alone" false (fun k -> if k < 200 then over (k * k) else over 10) 400;
  let twice = List.concat_map (fun t -> [ t; t ]) in
  let count times =
    match Slowing.of_instants times with
    | Some s -> List.map (fun (x : Slowing.stretch) -> x.instants) s.stretches
    | None -> []
  in
  let squares = instants (fun k -> over (k * k)) 40 in
  Alcotest.(check (list int)) "each instant once" [ 5; 10; 20 ] (count (twice squares))

let told = function
  | None -> ""
  | Some (Verdict.Named _) -> "named"
  | Some (Proved q) -> Printf.sprintf "%s, %s" (Rat.to_string q.factor) (Rat.to_string q.until)

let check_text ?(states = 120) text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let options = { Setup.default with bounds = { Bounds.default with states = Given states } } in
    let report = Check.run options semantics ~initial e.checks in
    List.map (fun (o : Verdict.outcome) -> (o.check.name, told o.converges)) report.outcomes

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let closing () =
  let text = read "../../../specs/models/laws/closing.sc" in
  let more = "\ncheck forever : always x(west) < x(ball)\ncheck never : possibly x(west) > -2\n" in
  Alcotest.(check (list (pair string string)))
    "where a bound ended the exploration"
    [ ("between", ""); ("closes", ""); ("beyond", ""); ("forever", "named"); ("never", "named") ]
    (check_text (text ^ more))

(* {1 Proofs} *)

let replace from into text =
  match Str.split_delim (Str.regexp_string from) text with
  | [ _ ] -> Alcotest.fail ("no " ^ from)
  | pieces -> String.concat into pieces

let quickening () =
  let text = read "../../../specs/models/laws/quicken.sc" in
  let flat = "\ncheck flat : always y(ball) = 0\n" in
  let proved ?states what expected text =
    Alcotest.(check (option string)) what (Some expected)
      (List.assoc_opt "flat" (check_text ?states (text ^ flat)))
  in
  proved "each round four times as fast" "4, 9/2" text;
  proved "half as much again" "9/4, 10" (replace "(2*vx, 2*vy, 2*vz)" "(3*vx/2, vy, vz)" text);
  (* The first step of the ball takes as long as its speed of 1 lets it, and then that of 2. *)
  proved "a condition that does not ask how fast" "2, 15"
    (replace "(2*vx, 2*vy, 2*vz)" "(if vx > 0 then vx else 2*vx, vy, vz)" text);
  let unproved what text = proved what "named" text in
  unproved "a law that asks how fast"
    (replace "(2*vx, 2*vy, 2*vz)" "(if vx > -1000 then 2*vx else 2*vx, vy, vz)" text);
  unproved "a law that asks where" (replace "2*vx, 2*vy" "if x > 5 then vx else 2*vx, 2*vy" text);
  proved "no bounce yet" "" (replace "timestep 100" "timestep 1e-40" text);
  unproved "an eps that waits" (replace "[nil]" "[eps(1000). nil]" text);
  (* It expires whenever the ball bounces in the first round, and is as old after it as before. *)
  let slow = replace "(2*vx, 2*vy, 2*vz)" "(if vx > 0 then vx else 2*vx, vy, vz)" text in
  let company behaviour = slow ^ "\nprocess k = Cube mass 1 at translate (0,50,0) [" ^ behaviour ^ "]\n" in
  proved ~states:8 "one round is enough" "2, 15" (company "nil");
  proved ~states:8 "an eps that comes round in step" "" ("behaviour K = eps(3). K\n" ^ company "K")

let tetrahedron = "vertices a (0,0,0) b (1,0,0) c (0,1,0) d (0,0,1) faces f [a,c,b] g [a,b,d] h [a,d,c] i [b,c,d]"

let linear () =
  let law text =
    let model =
      Printf.sprintf "shape T { %s }\nprocess p = T mass 3 [nil]\nmotion p = (%s)\n" tetrahedron text
    in
    (Load.exactly (Load.text model)).model.Scc_calculus.Model.leaves.(0).law
  in
  let is expected text = Alcotest.(check bool) text expected (Quickening.linear (law text)) in
  List.iter (is true)
    [
      "vx, vy, vz"; "2*vx - vy/mass, 0, vz*mass"; "vx*vy/vz, vx*vx/vy, 0 - vz";
      "if vx >= 2*vy and not vz = 0 then vx else vz, vy, 0";
    ];
  List.iter (is false)
    [
      "vx + 1, vy, vz"; "vx*vy, vy, vz"; "1, vy, vz"; "vx*dt, vy, vz"; "vx*time, vy, vz"; "x, vy, vz";
      "round(vx, 1/2), vy, vz"; "if vx > 1 then vx else vy, vy, vz"; "if x > 0 then vx else vy, vy, vz";
      "vx/vy, vy, vz";
    ]

let suite =
  let case = Alcotest.test_case in
  ("slowing",
   [
     ("slowing", [ case "gaps" `Quick gaps; case "walls that close" `Quick closing ]);
     ( "proofs",
       [ case "runs that repeat themselves faster" `Quick quickening; case "linear laws" `Quick linear ] );
   ])
