(* In the order in which names come first: some tests are about what those before them have counted. *)
let joined groups =
  let cases name = List.concat_map (fun (n, cases) -> if String.equal n name then cases else []) groups in
  let rec from seen = function
    | [] -> []
    | (name, _) :: rest when List.mem name seen -> from seen rest
    | (name, _) :: rest -> (name, cases name) :: from (name :: seen) rest
  in
  from [] groups

let run suites =
  let groups = List.concat_map snd suites in
  Alcotest.run (Filename.basename (Sys.getcwd ())) (joined groups)
