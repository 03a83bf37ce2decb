let passes (name, tests) =
  match Alcotest.run ~and_exit:false name tests with
  | () -> true
  | exception Alcotest.Test_error -> false

let run suites = if List.mem false (List.map passes suites) then exit 1
