(* What is told of phases, with a clock that goes on by what is done. *)

open Scc_graph_search
module Measured = Scc_cli__Measured

let now = ref 0.
let takes seconds = now := !now +. seconds

let phases () =
  now := 0.;
  let m = Measured.start ~clock:(fun () -> !now) () in
  let attempt = Measured.booking m Limits.quiet.attempt in
  let conclude seconds = ignore (attempt.run Concluding (fun () -> takes seconds)) in
  Measured.phase m "read" (fun () -> takes 1.);
  Measured.phase m "explore" (fun () ->
      takes 2.;
      ignore (attempt.run Exploring (fun () -> takes 4.));
      conclude 8.;
      ignore (attempt.run Proving (fun () -> takes 512.));
      ignore (attempt.run Reporting (fun () -> conclude 16.));
      ignore (attempt.run Concluding (fun () -> takes 32.; conclude 64.)));
  Measured.phase m "coverage" (fun () -> takes 128.; conclude 256.);
  Alcotest.(check (list (pair string (float 0.)))) "of each, what is its own"
    [ ("read", 1.); ("explore", 6.); ("conclude", 376.); ("prove", 512.); ("coverage", 128.) ]
    (Measured.seconds m)

let given_up () =
  now := 0.;
  let m = Measured.start ~clock:(fun () -> !now) () in
  let attempt = Measured.booking m Limits.quiet.attempt in
  let work () = Measured.phase m "explore" (fun () -> attempt.run Concluding (fun () -> takes 1.; raise Exit)) in
  (match work () with _ -> Alcotest.fail "it ended" | exception Exit -> ());
  Measured.phase m "explore" (fun () -> takes 2.);
  Alcotest.(check (list (pair string (float 0.)))) "what raises counts"
    [ ("explore", 2.); ("conclude", 1.) ]
    (Measured.seconds m)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "measured" [ ("phases", [ case "within others" phases; case "given up" given_up ]) ]
