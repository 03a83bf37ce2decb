(* What a command costs, as a count that is the same each time: the words that it allocates, told on standard error
   when it ends. Its arguments are those of scc. *)
let () =
  Scc_system.Ending.run (fun () ->
      let code = Scc_cli.main () in
      let { Gc.major_words; promoted_words; _ } = Gc.quick_stat () in
      Printf.eprintf "%.0f words\n%!" (Gc.minor_words () +. major_words -. promoted_words);
      code)
