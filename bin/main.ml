let () = Scc_system.Ending.run Scc_cli.main
