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

let check_text text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let options = { Check.default with bounds = { Bounds.default with states = Given 120 } } in
    let report = Check.run options semantics ~initial e.checks in
    List.map (fun (o : Verdict.outcome) -> (o.check.name, Option.is_some o.slowing)) report.outcomes

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let closing () =
  let text = read "../../../specs/models/laws/closing.sc" in
  let more = "\ncheck forever : always x(west) < x(ball)\ncheck never : possibly x(west) > -2\n" in
  Alcotest.(check (list (pair string bool)))
    "where a bound ended the exploration"
    [ ("between", false); ("closes", false); ("beyond", false); ("forever", true); ("never", true) ]
    (check_text (text ^ more))

let () =
  let case = Alcotest.test_case in
  Alcotest.run "slowing" [ ("slowing", [ case "gaps" `Quick gaps; case "walls that close" `Quick closing ]) ]
