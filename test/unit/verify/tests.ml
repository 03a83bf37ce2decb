let () =
  Scc_test_support.Suites.run
    [ Test_check.suite;
      Test_coverage.suite;
      Test_slowing.suite;
      Test_together.suite;
      Test_growth.suite;
      Test_unsettled.suite;
      Test_lost.suite;
      Test_left_out.suite;
      Test_advice.suite;
      Test_shares.suite;
      Test_cut_short.suite;
      Test_draws_ahead.suite ]
