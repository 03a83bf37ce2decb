(* A small share of the long test of casts.ml, with a seed of its own. *)

open Scc_long

let share ~random ~degenerate ~seed () =
  let report = Run.run { random; degenerate; seed; only = None; hulls = [ 14; 40 ] } in
  match report.differences with
  | [] -> Alcotest.(check bool) "as many cases as asked" true (report.by_chance >= random)
  | first :: _ -> Alcotest.failf "%d differences; the first: %s" (List.length report.differences) first

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "casts against brute force"
    [ ( "share of the long test",
        [ case "mostly by chance" (share ~random:6_000 ~degenerate:400 ~seed:2);
          case "mostly degenerate" (share ~random:400 ~degenerate:2_000 ~seed:3) ] ) ]
