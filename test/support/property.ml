let seed = 42

let case ?(speed = `Quick) (QCheck2.Test.Test cell as test) =
  (* a state for each property, so that none depends on which others ran before it *)
  let run () = QCheck2.Test.check_exn ~rand:(Random.State.make [| seed |]) test in
  Alcotest.test_case (QCheck2.Test.get_name cell) speed run

let cases tests = List.map (fun test -> case test) tests
