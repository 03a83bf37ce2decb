let () =
  Scc_test_support.Suites.run
    [ Test_relations.suite;
      Test_random.suite;
      Test_timed.suite;
      Test_texts.suite;
      Test_draws.suite ]
