let joined groups =
  let names = List.sort_uniq compare (List.map fst groups) in
  let cases name = List.concat_map (fun (n, cases) -> if n = name then cases else []) groups in
  List.map (fun name -> (name, cases name)) names

let run suites =
  let groups = List.concat_map snd suites in
  Alcotest.run (Filename.basename (Sys.getcwd ())) (joined groups)
