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

(* Values for what has none, by `start` of model.load. *)
let starts () =
  let session = create () in
  let load members = ask session "model.load" (`Assoc (("text", `String Cases.ranged) :: members)) in
  let start s = ("start", s) and parameters y = ("parameters", `Assoc [ ("y", y) ]) in
  let random seed = start (`Assoc [ ("random", seed) ]) in
  let y_of what members =
    match member "parameters" (member "result" (load members)) with
    | `Assoc [ ("y", `String y) ] -> y
    | _ -> Alcotest.failf "no value of y: %s" what
  in
  let y members = y_of "sampled" members in
  let simple = start (`String "simple") in
  check_text "simple" "0/1" (y [ simple ]);
  (* As scc trace --start random:7 has it. *)
  check_text "random" "795/256" (y [ random (`Int 7) ]);
  check_text "the seed as a text" "795/256" (y [ random (`String "7") ]);
  check_text "another seed" "1095/256" (y [ random (`Int 8) ]);
  check_text "narrowed" "2/1" (y [ simple; parameters (`List [ `Int 1; `Int 3 ]) ]);
  check_text "narrowed, random" "671/256" (y [ random (`Int 7); parameters (`List [ `Int 1; `Int 3 ]) ]);
  check_text "given" "4/1" (y [ simple; parameters (`Int 4) ]);
  let without_ranges = ask session "model.load" (`Assoc [ ("text", `String Cases.model); simple ]) in
  Alcotest.(check bool) "nothing to choose" true (member "result" without_ranges <> `Null);
  (* The handle is that of the start: so is every answer about it, also with a formula. *)
  let handle members = member "model" (member "result" (load members)) in
  let about members name more = ask session name (`Assoc (("model", handle members) :: more)) in
  let run members = shown (member "result" (about members "replay" [ ("choose", `String "first") ])) in
  check_text "the same run" (run [ parameters (`String "795/256") ]) (run [ random (`Int 7) ]);
  let value formula members = shown (member "value" (member "result" (about members "evaluate" [ formula ]))) in
  let seventh = value ("formula", `String "y") [ random (`Int 7) ] in
  check_text "the value" {|{"exact":"795/256","float":3.10546875}|} seventh;
  let verdict members =
    let formula = ("formula", `String "possibly bound(p, q)") in
    shown (member "verdict" (member "result" (about members "evaluate" [ formula ])))
  in
  check_text "they meet" {|"holds"|} (verdict [ simple ]);
  check_text "they do not meet" {|"violated"|} (verdict [ random (`Int 7) ]);
  let refused members = code (load members) in
  Alcotest.(check int) "an unknown word" (-32602) (refused [ start (`String "first") ]);
  Alcotest.(check int) "no seed" (-32602) (refused [ start (`Assoc []) ]);
  Alcotest.(check int) "a seed that is none" (-32602) (refused [ random (`String "0x7") ]);
  Alcotest.(check int) "a seed of 65 bits" (-32602) (refused [ random (`String "18446744073709551616") ]);
  Alcotest.(check int) "out of the range" (-32003) (refused [ simple; parameters (`Int 6) ]);
  let all_of_them = `Assoc [ ("text", `String Cases.ranged); simple ] in
  Alcotest.(check int) "a check is of all starts" (-32602) (code (ask session "model.check" all_of_them))

let () =
  Alcotest.run "oracle over ranges"
    [ ("models", [ case "over ranges" over_ranges; case "starts" starts ]) ]
