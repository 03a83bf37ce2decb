let () =
  Scc_test_support.Suites.run
    [ Test_ctl.suite;
      Test_explanations.suite;
      Test_late.suite;
      Test_contrast.suite;
      Test_tables.suite;
      Test_reasons.suite;
      Test_long.suite;
      Test_laws.suite;
      Test_means.suite;
      Test_layers.suite;
      Test_enumeration.suite ]
