let () =
  Scc_test_support.Suites.run
    [ Round_trip_test.suite;
      Region_test.suite;
      Curved_test.suite;
      Mutation_test.suite ]
