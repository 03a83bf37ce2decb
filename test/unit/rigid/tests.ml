let () =
  Scc_test_support.Suites.run
    [ Mass_test.suite;
      Closest_test.suite;
      Near_contact_test.suite;
      Impact_test.suite;
      Cast_test.suite;
      Bernstein_test.suite;
      Sweep_test.suite;
      Reference_test.suite ]
