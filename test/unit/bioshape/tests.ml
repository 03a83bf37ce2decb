let () = Scc_test_support.Suites.run [ Round_trip_test.suite; Error_test.suite; Mutation_test.suite ]
