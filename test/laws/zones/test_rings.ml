(* A ring may open and close for ever within an instant, without any collision: then time does not go on for
   others, and a slice does not leave it out. *)

open Scc_verify
module Loaded = Scc_loading.Loaded

let scene ~again ~at =
  let end_ name polarity side =
    let then_ = if again then Printf.sprintf "rho({<clasp, {only %s}>}). %s" side name else "nil" in
    Printf.sprintf "behaviour %s on Cube = <%sclasp, {only %s}>. %s\n" name polarity side then_
  in
  {|model ring
bonds cyclic
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}
  ^ (if at = "k" then "param k in [0, 1]\n" else "")
  ^ end_ "Hook" "" "top" ^ end_ "Eye" "~" "bottom"
  ^ {|process a = Cube mass 1 [Hook]
process b = Cube mass 1 at translate (2,0,0) [nil]
process c = Cube mass 1 at translate (2,0,2) [nil]
process d = Cube mass 1 at translate (0,0,2) [Eye]
bond <link, {a.right, b.left}>
bond <link, {b.top, c.bottom}>
bond <link, {c.left, d.right}>
|}
  ^ Printf.sprintf "process s = Cube mass 1 velocity (1,0,0) at translate (%s,50,0) [nil]\n" at
  ^ "check a : possibly x(s) > 2 within 5\n"

let load text =
  let read_file _ = Error "there is none" in
  match Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name:"ring" text) with
  | Ok l -> l
  | Error _ -> Alcotest.fail "it does not load"

let by_states text =
  let l = load text in
  match Scc_semantics.Network.initial l.semantics l.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial -> Check.run Check.default l.semantics ~initial l.checks

let over_zones text =
  let { Loaded.semantics; declared; checks; uncertain; _ } = load text in
  let uncertain = match uncertain with Some u -> u | None -> Alcotest.fail "nothing is uncertain" in
  match Zone_check.run Check.default semantics uncertain ~declared ~exactly:true ~premises:[] checks with
  | Ok report -> report
  | Error _ -> Alcotest.fail "it is not well-formed"

let case run ~at () =
  let is what ~again left_out verdict =
    let report : Check.report = run (scene ~again ~at) in
    let names = List.concat_map (fun (s : Check.slice) -> s.left_out) report.slices in
    Alcotest.(check (list string)) what left_out names;
    let found =
      match report.outcomes with
      | [ { verdict = Holds { bounds = []; _ }; _ } ] -> "holds"
      | [ { verdict = Violated _; _ } ] -> "violated"
      | _ -> "not known"
    in
    Alcotest.(check string) what verdict found
  in
  is "it closes" ~again:false [ "a"; "b"; "c"; "d" ] "holds";
  is "it opens and closes again and again" ~again:true [] "violated"

let () =
  Alcotest.run "rings"
    [
      ( "round for ever",
        [
          Alcotest.test_case "by states" `Quick (case by_states ~at:"0");
          Alcotest.test_case "over zones" `Quick (case over_zones ~at:"k");
        ] );
    ]
