(* Models with ranges, asked about by model.check. *)

open Oracle_cases
open Asking

(* They meet where -2 < y < 2, of [-5, 5]. *)
let over_ranges () =
  let session = create () in
  let asked members = `Assoc (("text", `String Cases.ranged) :: members) in
  let where = ("where", `Bool true) in
  let at y = ("parameters", `Assoc [ ("y", y) ]) in
  let meet members =
    match member "properties" (member "result" (ask session "model.check" (asked members))) with
    | `List [ property ] -> property
    | _ -> Alcotest.fail "one check has one property"
  in
  let found = member "where" (meet [ where ]) in
  check_text "probability" {|"2/5"|} (shown (member "probability" found));
  check_text "parameters" {|["y"]|} (shown (member "parameters" found));
  let names = function `Assoc members -> List.map fst members | _ -> [] in
  Alcotest.(check bool) "where, unasked" false (List.mem "where" (names (meet [])));
  let verdict text members =
    check_text text (Printf.sprintf "%S" text) (shown (member "verdict" (meet members)))
  in
  verdict "violated" [];
  let bound value included = `Assoc [ ("value", `Int value); ("included", `Bool included) ] in
  let range low high = `Assoc [ ("low", low); ("high", high) ] in
  verdict "holds" [ at (`List [ `Int 0; `Int 1 ]) ];
  verdict "violated" [ at (`List [ `Int 0; `Int 2 ]) ];
  verdict "holds" [ at (range (bound 0 true) (bound 2 false)) ];
  verdict "violated" [ at (range (bound 0 true) (bound 2 true)) ];
  verdict "holds" [ at (`Int 1) ];
  (* They meet at 10. *)
  let until time = ("limits", `Assoc [ ("time", `Int time) ]) in
  verdict "undecided" [ at (`List [ `Int 0; `Int 1 ]); until 9 ];
  verdict "holds" [ at (`List [ `Int 0; `Int 1 ]); until 11 ];
  let refused members = code (ask session "model.check" (asked members)) in
  Alcotest.(check int) "of a point" (-32003) (refused [ at (`Int 1); where ]);
  Alcotest.(check int) "out of the range" (-32003) (refused [ at (`List [ `Int 4; `Int 6 ]) ]);
  Alcotest.(check int) "half a range" (-32602) (refused [ at (`List [ `Int 1 ]) ]);
  Alcotest.(check int) "no truth value" (-32602) (refused [ ("where", `Int 1) ]);
  let states n = ("limits", `Assoc [ ("states", `Int n) ]) in
  Alcotest.(check int) "too many states" (-32000) (refused [ states 100_000_000 ]);
  Alcotest.(check int) "a handle" (-32602) (refused [ ("model", `String "m1") ]);
  Alcotest.(check int) "it is not loaded" (-32003) (code (ask session "model.load" (asked [])));
  let loaded = member "result" (ask session "model.load" (asked [ at (`Int 1) ])) in
  check_text "a point is loaded" {|{"y":"1/1"}|} (shown (member "parameters" loaded))

let () = Alcotest.run "oracle over ranges" [ ("models", [ case "over ranges" over_ranges ]) ]
