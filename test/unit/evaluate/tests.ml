let () =
  Scc_test_support.Suites.run
    [ Test_trajectory.suite;
      Test_spinning.suite;
      Test_event.suite;
      Test_atoms.suite ]
