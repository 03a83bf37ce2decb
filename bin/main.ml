let () = exit (Scc_cli.main ())
