let () =
  Scc_test_support.Suites.run
    [ Test_diffusion.suite;
      Test_drawn_bodies.suite;
      Test_no_delay.suite;
      Test_odds.suite;
      Test_faults.suite;
      Test_language.suite;
      Test_later.suite;
      Test_properties.suite;
      Test_ranges.suite;
      Test_terms.suite;
      Test_turning.suite;
      Test_turning_laws.suite;
      Test_unused_families.suite;
      Test_well_formed.suite ]
