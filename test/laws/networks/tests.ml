let () =
  Scc_test_support.Suites.run
    [ Test_random_networks.suite;
      Test_kernel.suite;
      Test_symmetry_laws.suite;
      Test_time_laws.suite;
      Test_event_laws.suite;
      Test_limit_laws.suite;
      Test_cutting.suite;
      Test_bisimilarity.suite;
      Test_order.suite;
      Test_locality.suite;
      Test_lots.suite;
      Test_blocked.suite ]
